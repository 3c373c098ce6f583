// SPDX-License-Identifier: Apache-2.0
#include "tb/report/report.hpp"

#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace halfspace::tb {
namespace {

// Most significant first, without zeros in front.
std::string hex_of(const std::vector<std::uint32_t>& word) {
  std::string text;
  for (std::size_t part = word.size(); part-- > 0;) {
    char digits[9];
    std::snprintf(digits, sizeof digits, "%08x", word[part]);
    text += digits;
  }
  return text.substr(std::min(text.find_first_not_of('0'), text.size() - 1));
}

nlohmann::ordered_json json_of(const Timeline& timeline) {
  nlohmann::ordered_json json = {{"first", timeline.first()}, {"step", timeline.step()}};
  for (const Timeline::Row& row : timeline.rows()) json["streams"][row.stream] = row.buckets;
  return json;
}

std::FILE* standard_output = stdout;  // where the file "-" goes

void print_table(const Result& result) {
  const bool lacks = result.missing() != 0;
  std::printf("%-12s %-32s %12s %12s%s\n", "stream", "from -> to", "words", "mismatches", lacks ? "      missing" : "");
  for (const StreamResult& stream : result.streams) {
    const std::string ends = stream.from + " -> " + stream.to;
    std::printf("%-12s %-32s %12zu %12zu", stream.name.c_str(), ends.c_str(), stream.words, stream.mismatches);
    if (lacks) std::printf(" %12zu", stream.missing);
    std::printf("\n");
  }
}

// Only of compositions: what their units' rates allow for the last frame of a pipeline, or for a whole sequence.
void print_bound(const Result& result) {
  if (result.bound.cycles() == 0) return;
  std::printf("bound of %s: %llu cycles (", result.bound.merges == 0 ? "a frame" : "the sequence",
              static_cast<unsigned long long>(result.bound.cycles()));
  if (result.bound.setup != 0) {
    std::printf("setup intervals of the triangles %llu, ", static_cast<unsigned long long>(result.bound.setup));
  }
  if (result.bound.merges != 0)
    std::printf("merged stamps %llu, ", static_cast<unsigned long long>(result.bound.merges));
  std::printf("covered stamps %llu, shader %llu)", static_cast<unsigned long long>(result.bound.stamps),
              static_cast<unsigned long long>(result.bound.pixels));
  std::printf(", measured %llu: %.3f x\n", static_cast<unsigned long long>(result.cycles),
              double(result.cycles) / double(result.bound.cycles()));
}

// Only of a film.
void print_film(const Result& result) {
  const FilmBound& bound = result.film;
  if (bound.frames == 0) return;
  const auto number = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
  std::printf(
      "film of %llu frames: %.0f cycles each; bound %.0f (setup intervals %llu, covered stamps %llu, scan-out "
      "%llu, motion %llu, film %llu), and %.0f a pass after the other: %.3f x\n",
      number(bound.frames), double(result.cycles) / double(bound.frames), double(bound.cycles()) / double(bound.frames),
      number(bound.setup), number(bound.stamps), number(bound.shader), number(bound.motion), number(bound.film),
      double(bound.passes) / double(bound.frames), double(result.cycles) / double(bound.passes));
}

}  // namespace

void print_result(const Vectors& vectors, const Result& result) {
  const bool pipeline = result.unit == "pipeline";
  for (const std::string& failure : result.failures) std::printf("FAIL %s: %s\n", result.unit.c_str(), failure.c_str());
  if (pipeline && !result.first_wrong.empty()) {
    std::printf("first wrong in flow order: %s%s\n", result.first_wrong.c_str(),
                result.follows.empty() ? "" : "; from it follows:");
  }
  for (const std::string& failure : result.follows) std::printf("  %s\n", failure.c_str());
  print_table(result);
  const double million = double(result.simulated) * 1e-6;
  std::printf("cycles: %llu (%s); %llu simulated in %.2f s: %.2f M cycles/s, %.2f M a second of the processor\n",
              static_cast<unsigned long long>(result.cycles), result.cycles_of.c_str(),
              static_cast<unsigned long long>(result.simulated), result.seconds, million / result.seconds,
              million / result.processor_seconds);
  print_bound(result);
  for (const ClientCount& client : result.clients) {
    std::printf("memory: %-12s %8llu requests, %10llu bytes\n", client.name.c_str(),
                static_cast<unsigned long long>(client.requests), static_cast<unsigned long long>(client.bytes));
  }
  print_film(result);
  const std::string missing = result.missing() == 0 ? "" : std::to_string(result.missing()) + " missing, ";
  std::printf("%s %s %s: %zu words on %zu streams compared, %zu mismatches, %s%llu cycles\n",
              pipeline ? "cosim" : ("bench " + result.unit).c_str(), vectors.scene.c_str(), vectors.config.c_str(),
              result.words(), result.streams.size(), result.mismatches(), missing.c_str(),
              static_cast<unsigned long long>(result.cycles));
}

std::string json_report(const Vectors& vectors, const Options& options, const std::vector<Result>& results) {
  using Json = nlohmann::ordered_json;
  Json runs = Json::array();
  bool passed = !results.empty();
  for (const Result& result : results) {
    passed = passed && result.passed();
    Json streams = Json::array();
    for (const StreamResult& stream : result.streams) {
      streams.push_back({{"name", stream.name},
                         {"from", stream.from},
                         {"to", stream.to},
                         {"words", stream.words},
                         {"mismatches", stream.mismatches},
                         {"missing", stream.missing},
                         {"failures", stream.failures}});
      for (const WrongWord& wrong : stream.wrong) {
        streams.back()["wrong"].push_back({{"word", wrong.word}, {"cycle", wrong.cycle}, {"got", hex_of(wrong.got)}});
      }
    }
    Json run = {{"unit", result.unit},
                {"passed", result.passed()},
                {"words", result.words()},
                {"mismatches", result.mismatches()},
                {"missing", result.missing()},
                {"first_wrong", result.first_wrong},
                {"first_cycle", result.first_cycle},
                {"cycles", result.cycles},
                {"cycles_of", result.cycles_of},
                {"simulated_cycles", result.simulated},
                {"seconds", result.seconds},
                {"processor_seconds", result.processor_seconds},
                {"streams", streams},
                {"failures", result.failures},
                {"follows", result.follows}};
    run["repeated"] = result.repeated;
    if (!result.timeline.rows().empty()) run["timeline"] = json_of(result.timeline);
    if (!result.frame_ends.empty()) run["frame_ends"] = result.frame_ends;
    if (result.film.frames != 0) {
      run["film"] = {{"frames", result.film.frames},   {"bound", result.film.cycles()},
                     {"setup", result.film.setup},     {"covered_stamps", result.film.stamps},
                     {"scan_out", result.film.shader}, {"motion", result.film.motion},
                     {"film", result.film.film},       {"passes", result.film.passes}};
    }
    if (result.bound.cycles() != 0) {
      run["bound"] = {{"cycles", result.bound.cycles()},
                      {"setup", result.bound.setup},
                      {"covered_stamps", result.bound.stamps},
                      {"shader", result.bound.pixels}};
      if (result.bound.merges != 0) run["bound"]["merged_stamps"] = result.bound.merges;
    }
    if (result.unit == "pipeline") {
      run["rates"] = {{"triangles", result.rates.triangles},
                      {"reduced_triangles", result.rates.reduced_triangles},
                      {"culled", result.rates.culled},
                      {"fragments", result.rates.fragments},
                      {"reduced_fragments", result.rates.reduced_fragments},
                      {"visible_pixels", result.rates.visible_pixels}};
      if (result.rates.lights) run["rates"]["lightings"] = result.rates.lightings;
      if (result.rates.textures) run["rates"]["texture_fetches"] = result.rates.texture_fetches;
      std::uint64_t total = 0;
      for (const Accesses& a : result.accesses) {
        run["buffers"][a.buffer] = {{"entry_bits", a.entry_bits},
                                    {"read", a.read},
                                    {"written", a.written},
                                    {"bytes_read", Accesses::bytes(a.read, a.entry_bits)},
                                    {"bytes_written", Accesses::bytes(a.written, a.entry_bits)},
                                    {"word_bytes_read", Accesses::bytes(a.word_read, a.entry_bits)},
                                    {"word_bytes_written", Accesses::bytes(a.word_written, a.entry_bits)}};
        run["memory_bits"][a.buffer] = a.memory_bits;
        total += a.memory_bits;
      }
      run["memory_bits"]["total"] = total;
    }
    runs.push_back(run);
  }
  return Json({{"format", "halfspace-cosim 1"},
               {"scene", vectors.scene},
               {"config", vectors.config},
               {"lanes_x", vectors.lanes_x},
               {"lanes_y", vectors.lanes_y},
               {"seed", options.seed},
               {"stall", options.stall},
               {"passed", passed},
               {"runs", runs}})
             .dump(1) +
         "\n";
}

void give_standard_output_to_files() {
  const int kept = dup(STDOUT_FILENO);
  if (kept < 0) return;
  standard_output = fdopen(kept, "wb");
  std::fflush(stdout);
  dup2(STDERR_FILENO, STDOUT_FILENO);
}

void write_file(const std::string& file, const std::string& bytes) {
  const Error failed(file + ": cannot be written; choose a folder that exists and is writable, on a disk with space");
  if (file == "-") {
    const bool sent = std::fwrite(bytes.data(), 1, bytes.size(), standard_output) == bytes.size();
    if (std::fflush(standard_output) != 0 || !sent) throw failed;
    return;
  }
  std::error_code absent;
  const std::filesystem::path named = std::filesystem::canonical(file, absent);
  const std::string target = absent ? file : named.string();
  const bool replaced = absent || std::filesystem::is_regular_file(target, absent);
  const std::string part = replaced ? target + ".part" : target;
  std::ofstream out(part, std::ios::binary);
  out.write(bytes.data(), std::streamsize(bytes.size()));
  out.close();
  if (!out || (replaced && std::rename(part.c_str(), target.c_str()) != 0)) {
    if (replaced) std::remove(part.c_str());
    throw failed;
  }
}

}  // namespace halfspace::tb
