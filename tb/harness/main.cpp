// SPDX-License-Identifier: Apache-2.0
// The program around one Verilated model: of a unit its bench, of hs_pipeline the co-simulation.
#include <cstdio>
#include <set>

#include "tb/harness/options.hpp"
#include "tb/harness/pipeline.hpp"
#include "tb/harness/units.hpp"
#include "tb/report/report.hpp"

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
  for (const Stream& stream : vectors->streams) {
    if (names.count(stream.name) != 0 && !stream.context.empty()) wanted.insert(stream.context);
  }
  for (Stream& stream : vectors->streams) {
    if (wanted.count(stream.name) != 0) load_words(vectors->directory, &stream);
  }
}

void report(const Vectors& vectors, const Options& options, const std::vector<Result>& results) {
  if (!options.json.empty()) write_file(options.json, json_report(vectors, options, results));
}

int run_bench(const Model& model, Vectors* vectors, const Options& options) {
  const std::vector<std::string> names = unit_streams(model, *vectors);
  load_streams({names.begin(), names.end()}, vectors);
  const Result result = run_unit(*vectors, options);
  print_result(*vectors, result);
  report(*vectors, options, {result});
  return result.passed() ? 0 : 1;
}

int run_cosim(Model* model, Vectors* vectors, const Options& options) {
  std::set<std::string> names;
  for (const Stream& stream : vectors->streams) names.insert(stream.name);
  load_streams(names, vectors);
  if (!options.dump.empty() && vectors->find("motion") != nullptr) {
    throw Error("--dump: a frame between key frames has motion and no picture; leave it out");
  }
  LastFrame last;
  const Result result = run_pipeline(model, *vectors, options, &last);
  if (!options.dump.empty()) write_file(options.dump, rgba_picture(*vectors, last.pixel));
  if (!options.dump_index.empty()) write_file(options.dump_index, index_picture(*vectors, last.counted.at("scan")));
  report(*vectors, options, {result});
  print_result(*vectors, result);
  return result.passed() ? 0 : 1;
}

// A pipeline clears its buffers after a reset, which takes longer than small frames: seeds take turns.
Start start_of(const Options& options, bool unit) {
  const Start turns[] = {Start::kOnes, Start::kRandom, Start::kZeros};
  return unit ? Start::kRandom : turns[options.seed % 3];
}

int run(int argc, char** argv) {
  const bool unit = model_top() != "hs_pipeline";
  const Options options = parse_options(argc, argv, model_top());
  if (options.json == "-") give_standard_output_to_files();
  Vectors vectors = load_manifest(options.vectors);
  const std::unique_ptr<Model> model = make_model(options.seed, start_of(options, unit));
  check_model(*model, vectors);
  std::printf("%s, seed %llu, stall %d %%, %s\n", model->title().c_str(), static_cast<unsigned long long>(options.seed),
              options.stall, options.vectors.c_str());
  return unit ? run_bench(*model, &vectors, options) : run_cosim(model.get(), &vectors, options);
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
