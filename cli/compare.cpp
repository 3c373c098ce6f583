// SPDX-License-Identifier: Apache-2.0
// halfspace compare
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>

#include "cli/commands.hpp"
#include "cli/common/output.hpp"
#include "ref/error.hpp"
#include "tb/report/compare_words.hpp"
#include "vectors/dump.hpp"

namespace halfspace::cli {
namespace {

namespace fs = std::filesystem;

struct CompareOptions {
  std::string a, b, stream, json;
  tb::Leniency leniency;
};

// A buffer of a dump, or a stream.
struct ComparedPart {
  std::string name, told;  // what is printed of it
  std::uint64_t values, different;
  Json json;
};

std::vector<ComparedPart> compare_dumps(const CompareOptions& options) {
  std::vector<ComparedPart> parts;
  for (const model::Difference& d : model::compare_dumps(options.a, options.b)) {
    const std::string told = d.different == 0
                                 ? fmt::format("{} values, equal", d.values)
                                 : fmt::format("{} values, {} different{}; first {}", d.values, d.different,
                                               d.largest ? fmt::format(", by {} at most", d.largest) : "", d.first);
    parts.push_back({d.part, told, d.values, d.different, {{"largest", d.largest}, {"first", d.first}}});
  }
  return parts;
}

// A file of words, or a folder with the .hex file of the stream.
tb::Words words_to_compare(const CompareOptions& options, const tb::Stream& stream) {
  const fs::path b(options.b);
  return tb::read_words(fs::is_directory(b) ? (b / stream.file).string() : options.b, stream.bits,
                        std::size_t(1) << 40);
}

// That B is of the same streams, if it says of which it is.
void check_manifest(const CompareOptions& options, const tb::Vectors& vectors) {
  if (!fs::exists(fs::path(options.b) / "manifest.json")) {
    if (!options.stream.empty()) return;
    throw ref::Error(
        fmt::format("{}: neither a dump nor a vector set: give a folder that `halfspace render --dump` or "
                    "`halfspace vectors` has written, or name one stream with --stream",
                    options.b));
  }
  const tb::Vectors other = tb::load_manifest(options.b);
  for (const tb::Stream& stream : vectors.streams) {
    if (!options.stream.empty() && stream.name != options.stream) continue;
    const tb::Stream* const same = other.find(stream.name);
    if (!same || same->bits != stream.bits ||
        (options.stream.empty() && other.streams.size() != vectors.streams.size()))
      throw ref::Error(
          fmt::format("{} and {}: the sets have different streams: write both with one version, of one "
                      "configuration and number of lanes",
                      options.a, options.b));
  }
}

std::vector<ComparedPart> compare_sets(const CompareOptions& options) {
  tb::Vectors vectors = tb::load_manifest(options.a);
  if (!options.stream.empty() && !vectors.find(options.stream)) {
    std::string names;
    for (const tb::Stream& stream : vectors.streams) names += (names.empty() ? "" : ", ") + stream.name;
    throw ref::Error(fmt::format("--stream {}: the set has {}", options.stream, names));
  }
  check_manifest(options, vectors);
  for (tb::Stream& stream : vectors.streams) tb::load_words(options.a, &stream);
  std::vector<ComparedPart> parts;
  for (const tb::Stream& stream : vectors.streams) {
    if (!options.stream.empty() && stream.name != options.stream) continue;
    const tb::Comparison c = tb::compare_words(vectors, stream, words_to_compare(options, stream), options.leniency);
    std::string told = fmt::format("{} words, equal", c.words);
    if (c.wrong() != 0) {
      told = fmt::format("{} words, {} different", c.words, c.different);
      if (c.missing != 0) told += fmt::format(", {} missing", c.missing);
      if (c.surplus != 0) told += fmt::format(", {} too many", c.surplus);
      told += "; first " + c.first;
    }
    parts.push_back(
        {stream.name, told, c.words, c.wrong(), {{"missing", c.missing}, {"surplus", c.surplus}, {"first", c.first}}});
  }
  return parts;
}

int compare(const CompareOptions& options) {
  const bool dumps = model::is_dump(options.a);
  if (!dumps && !fs::exists(fs::path(options.a) / "manifest.json")) {
    throw ref::Error(
        fmt::format("{}: neither a dump nor a vector set: give a folder that `halfspace render --dump` or "
                    "`halfspace vectors` has written",
                    options.a));
  }
  if (dumps != model::is_dump(options.b)) {
    throw ref::Error(fmt::format("{} and {}: one is a dump and one is not: give two of a kind", options.a, options.b));
  }
  if (dumps && (!options.stream.empty() || options.leniency.any_order || options.leniency.masked)) {
    throw ref::Error("a dump has no streams: --stream, --any-order and --masked are for vector sets");
  }
  std::vector<ComparedPart> parts;
  try {
    parts = dumps ? compare_dumps(options) : compare_sets(options);
  } catch (const tb::Error& error) {
    throw ref::Error(error.what());
  }
  std::uint64_t values = 0, different = 0;
  Json json = Json::array();
  for (const ComparedPart& part : parts) {
    fmt::print("{}: {}\n", part.name, part.told);
    values += part.values;
    different += part.different;
    json.push_back({{"part", part.name}, {"values", part.values}, {"different", part.different}});
    json.back().update(part.json);
  }
  if (values == 0) {
    throw ref::Error(fmt::format("{} and {}: there is nothing in them to compare", options.a, options.b));
  }
  fmt::print("compare: {} values, {} different\n", values, different);
  write_json(options.json,
             {{"a", options.a}, {"b", options.b}, {"values", values}, {"different", different}, {"parts", json}});
  return different == 0 ? 0 : 1;
}

}  // namespace

void add_compare(CLI::App& app, int& status) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App* command =
      app.add_subcommand("compare", "hold two dumps, two vector sets, or words of one's own against each other");
  command->footer(
      "What `halfspace render --dump A` wrote, or `halfspace vectors --out A`; with --stream, B may be a file of "
      "words\n"
      "that a unit of your own wrote. Exit status 0: equal; 1: they differ, or cannot be read.\n");
  command->add_option("A", options->a, "folder of a dump or a vector set")->required();
  command->add_option("B", options->b, "another of the same kind; with --stream a file of its words is enough")
      ->required();
  command->add_option("--stream", options->stream, "this stream of the set alone");
  command->add_flag("--any-order", options->leniency.any_order,
                    "words of one triangle may come in any order, where `any_order_within` of the manifest says so");
  command->add_flag("--masked", options->leniency.masked,
                    "fields that do not count may be anything: `valid_if` of the manifest");
  add_json(command, options->json);
  command->callback([options, &status] { status = compare(*options); });
}

}  // namespace halfspace::cli
