// SPDX-License-Identifier: Apache-2.0
// The program around one Verilated model: of a unit its bench, of hs_pipeline, hs_system, hs_static_frames and
// hs_up_convert the co-simulation.
#include <algorithm>
#include <cstdio>
#include <set>

#include "tb/composed/static_frames.hpp"
#include "tb/film/between.hpp"
#include "tb/film/film.hpp"
#include "tb/harness/options.hpp"
#include "tb/harness/pipeline.hpp"
#include "tb/harness/units.hpp"
#include "tb/report/picture.hpp"
#include "tb/report/report.hpp"
#include "tb/report/wave.hpp"
#include "tb/system/system.hpp"

namespace halfspace::tb {
namespace {

void check_model(const Model& model, const Vectors& vectors) {
  const bool same_lanes = model.lanes_x() == vectors.lanes_x && model.lanes_y() == vectors.lanes_y;
  if (!same_lanes || model.config() != vectors.config) {
    throw Error(vectors.directory + "/manifest.json: the set is for " + vectors.config + ", " +
                std::to_string(vectors.lanes_x) + "x" + std::to_string(vectors.lanes_y) + " lanes, this model is " +
                model.title() + "; take the program tb_…_" + vectors.config + "_" + std::to_string(vectors.lanes()) +
                " or make the set with its --config and --lanes");
  }
  const std::uint32_t width = std::uint32_t(model.constant("MaxWidth"));
  const std::uint32_t height = std::uint32_t(model.constant("MaxHeight"));
  for (const Frame& frame : vectors.frames) {
    if (frame.width <= width && frame.height <= height) continue;
    throw Error(vectors.directory + "/manifest.json: a frame of " + std::to_string(frame.width) + "x" +
                std::to_string(frame.height) + " does not fit " + model.title() + ", which draws " +
                std::to_string(width) + "x" + std::to_string(height) + " at most; make the set with another --config");
  }
}

// The streams named, and those that tell the triangles of these.
void load_streams(const std::set<std::string>& names, Vectors* vectors) {
  std::set<std::string> wanted = names;
  if (wanted.erase("between") != 0) wanted.insert({"ordered", "compensated"});
  for (const Stream& stream : vectors->streams) {
    if (names.count(stream.name) != 0 && !stream.context.empty()) wanted.insert(stream.context);
  }
  for (Stream& stream : vectors->streams) {
    if (wanted.count(stream.name) != 0) load_words(vectors->directory, &stream);
  }
  if (names.count("between") != 0) fill_between(vectors);
}

void report(const Vectors& vectors, const Options& options, const std::vector<Result>& results) {
  if (!options.json.empty()) write_file(options.json, json_report(vectors, options, results));
}

Result run_bench(const Model& model, Vectors* vectors, const Options& options) {
  const std::vector<std::string> names = unit_streams(model, *vectors);
  load_streams({names.begin(), names.end()}, vectors);
  const Result result = run_unit(*vectors, options);
  if (!options.only_wave) print_result(*vectors, result);
  if (!options.only_wave) report(*vectors, options, {result});
  return result;
}

void write_pictures(const Options& options, const Vectors& vectors, const Words& shown) {
  const Frame& frame = vectors.frames.back();
  const auto png = [&](const std::string& rgba) { return png_of(frame.width, frame.height, rgba); };
  write_file(options.pictures + "/frame_rtl.png", png(rgba_picture(vectors, shown)));
  const std::string wrong = wrong_pixels(vectors, shown), file = options.pictures + "/wrong_pixels.png";
  const long red = std::count(wrong.begin(), wrong.end(), 1), blue = std::count(wrong.begin(), wrong.end(), 2);
  std::remove(file.c_str());
  if (red + blue == 0) return;
  write_file(file, png(map_of_wrong(vectors, wrong)));
  std::printf("%s: %ld pixels of the last frame are wrong, %ld never came\n", file.c_str(), red, blue);
}

Result run_sequence(Model* model, Vectors* vectors, const Options& options) {
  std::set<std::string> names;
  for (const Stream& stream : vectors->streams) names.insert(stream.name);
  load_streams(names, vectors);
  const bool film = model->top() == "hs_up_convert";
  const Result result = film ? run_film(model, *vectors, options) : run_static_frames(model, *vectors, options);
  if (!options.only_wave) print_result(*vectors, result);
  if (!options.only_wave) report(*vectors, options, {result});
  return result;
}

Result run_cosim(Model* model, Vectors* vectors, const Options& options) {
  std::set<std::string> names;
  for (const Stream& stream : vectors->streams) names.insert(stream.name);
  load_streams(names, vectors);
  if (!options.dump.empty() && vectors->find("motion") != nullptr) {
    throw Error("--dump: a frame between key frames has motion and no picture; leave it out");
  }
  LastFrame last;
  const Result result = run_pipeline(model, *vectors, options, &last);
  if (options.only_wave) return result;
  if (!options.dump.empty()) write_file(options.dump, rgba_picture(*vectors, last.pixel));
  if (!options.pictures.empty() && vectors->find("motion") == nullptr) write_pictures(options, *vectors, last.pixel);
  if (!options.dump_index.empty()) write_file(options.dump_index, index_picture(*vectors, last.counted.at("scan")));
  report(*vectors, options, {result});
  print_result(*vectors, result);
  return result;
}

Result run_board(Model* model, Vectors* vectors, const Options& options) {
  std::set<std::string> names;
  for (const Stream& stream : vectors->streams) names.insert(stream.name);
  load_streams(names, vectors);
  Picture last;
  const Result result = run_system(model, *vectors, options, &last);
  if (options.only_wave) return result;
  print_result(*vectors, result);
  report(*vectors, options, {result});
  if (options.pictures.empty()) return result;
  std::string rgba;
  for (const std::uint32_t pixel : last.pixels) {
    rgba += {char(pixel >> 16), char(pixel >> 8), char(pixel), char(255)};
  }
  write_file(options.pictures + "/frame_rtl.png", png_of(last.width, last.height, rgba));
  return result;
}

// A pipeline clears its buffers after a reset, which takes longer than small frames: seeds take turns.
Start start_of(const Options& options, bool unit) {
  const Start turns[] = {Start::kOnes, Start::kRandom, Start::kZeros};
  return unit ? Start::kRandom : turns[options.seed % 3];
}

int run(int argc, char** argv) {
  const bool system = model_top() == "hs_system";
  const bool unit = model_top() != "hs_pipeline" && model_top() != "hs_up_convert" && !system;
  const Options options = parse_options(argc, argv, model_top());
  if (options.json == "-") give_standard_output_to_files();
  Vectors vectors = load_manifest(options.vectors);
  if (vectors.is_film()) add_between(&vectors);
  const std::unique_ptr<Model> model = make_model(options.seed, start_of(options, unit));
  check_model(*model, vectors);
  if (!options.only_wave)
    std::printf("%s, seed %llu, stall %d %%, %s\n", model->title().c_str(),
                static_cast<unsigned long long>(options.seed), options.stall, options.vectors.c_str());
  const auto run = [&](Model* of) {
    if (model_top() == "hs_static_frames" || model_top() == "hs_up_convert") return run_sequence(of, &vectors, options);
    if (system) return run_board(of, &vectors, options);
    return unit ? run_bench(*of, &vectors, options) : run_cosim(of, &vectors, options);
  };
  const Result result = run(model.get());
  const auto again = [&] { run(make_model(options.seed, start_of(options, unit)).get()); };
  if (!options.wave.empty()) write_wave(argc, argv, options, result, again);
  return result.passed() ? 0 : 1;
}

}  // namespace
}  // namespace halfspace::tb

int main(int argc, char** argv) {
  try {
    return halfspace::tb::run(argc, argv);
  } catch (const halfspace::tb::Error& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 2;
  }
}
