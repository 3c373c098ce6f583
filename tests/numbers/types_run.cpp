// SPDX-License-Identifier: Apache-2.0
// The standard vectors from kernels on the numbers of a library, held against the committed manifests, which the native
// kernels wrote: prints the digest of each stream. A configuration that has no manifest is held against the native
// kernels with formats read at run time. Usage: types_run MANIFESTS FOLDER
// FOLDER takes the vectors, for `halfspace compare` when they differ.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "ref/error.hpp"
#include "tests/formats/feature_configs.hpp"
#include "tests/numbers/types_engine.hpp"
#include "tests/objects/object_configs.hpp"
#include "vectors/frames/merge_frames.hpp"
#include "vectors/standard_set.hpp"

namespace halfspace::model {

// In the place of the native engines: write_vector_set() finds this one first. An object of the library that defines it
// again would be an error of the linker.
std::unique_ptr<Engine> make_engine(const Configuration& configuration, int) {
  return tests::HS_MAKE_ENGINE(configuration.name());
}

}  // namespace halfspace::model

namespace halfspace::tests {
namespace {

using nlohmann::json;

constexpr int kStreams = 9, kMergeStreams = 5;

std::vector<model::NamedFrame> standard_frames(const model::Configuration& configuration) {
  const ref::RasterFormat format = model::raster_format(configuration);
  std::vector<model::NamedFrame> frames = model::corner_frames(format);
  for (auto& frame : model::random_frames(format, 1, 4, 60)) frames.push_back(std::move(frame));
  return frames;
}

// Both return how many streams are equal.
int expect_manifest(const model::Configuration& configuration, const std::filesystem::path& manifests,
                    const std::string& folder) {
  const json written = json::parse(model::write_vector_set(folder, {"standard", configuration, kTypesLanes, 1},
                                                           standard_frames(configuration), nullptr));
  const std::filesystem::path path = manifests / (configuration.name() + ".json");
  std::ifstream file(path);
  const json committed = json::parse(file);
  if (written["frames"] != committed["frames"] || written["streams"].size() != committed["streams"].size()) {
    throw ref::Error(
        fmt::format("{}: it is not of these frames: vector_set_test tells how to write it again", path.string()));
  }
  int equal = 0;
  for (std::size_t n = 0; n < written["streams"].size(); ++n) {
    const json& stream = written["streams"][n];
    const bool same = stream == committed["streams"][n];
    fmt::print("{:6} {:10} {:6} words {} {}\n", configuration.name(), stream["name"].get<std::string>(),
               stream["words"].get<int>(), stream["sha256"].get<std::string>(), same ? "equal" : "DIFFERENT");
    equal += same;
  }
  return equal;
}

int expect_native(const model::Configuration& configuration) {
  const Config config = configuration.config();
  const std::vector<model::NamedFrame> frames = standard_frames(configuration);
  using Texts = std::map<std::string, std::string>;
  const auto streams_of = [&](model::Engine& engine) {
    Texts texts;
    for (const model::NamedFrame& frame : frames) {
      model::load_frame(engine, config, frame);
      engine.capture(frame.scene, [&](const model::Layout& layout, const model::Word* words, std::size_t count) {
        for (std::size_t n = 0; n < count; ++n) model::append_hex(texts[layout.stream] += ' ', words[n], layout.bits);
      });
    }
    return texts;
  };
  const Texts here = streams_of(*model::make_engine(configuration, kTypesLanes));
  Texts native = streams_of(*model::make_runtime_engine(config, format_table(config), kTypesLanes));
  int equal = 0;
  for (const auto& [stream, words] : here) {
    const bool same = words == native[stream];
    fmt::print("{:6} {:10} {:6} words {}\n", configuration.name(), stream, std::count(words.begin(), words.end(), ' '),
               same ? "equal" : "DIFFERENT");
    equal += same;
  }
  return equal;
}

// Those of ztest_merge, run by run.
int expect_merge(const model::Configuration& configuration) {
  const model::Merger native(configuration, kTypesLanes);
  std::map<std::string, std::pair<std::size_t, bool>> equal;  // words, and whether they are
  for (const model::NamedMerge& run : model::merge_frames(configuration.config(), 1)) {
    std::vector<model::StreamWords> want;
    native.capture(run.input(), want);
    const std::vector<model::StreamWords> got = HS_MERGE(run.input());
    for (std::size_t n = 0; n < want.size(); ++n) {
      auto& [words, same] = equal.emplace(want[n].layout.stream, std::pair(std::size_t(0), true)).first->second;
      words += want[n].words.size();
      same = same && got.size() == want.size() && got[n].layout.stream == want[n].layout.stream &&
             got[n].words == want[n].words;
    }
  }
  int count = 0;
  for (const auto& [stream, result] : equal) {
    fmt::print("{:6} {:10} {:6} words {}\n", configuration.name(), stream, result.first,
               result.second ? "equal" : "DIFFERENT");
    count += result.second && result.first != 0;
  }
  return count;
}

}  // namespace
}  // namespace halfspace::tests

int main(int argc, char** argv) {
  using namespace halfspace;
  if (argc != 3) return fmt::print(stderr, "usage: types_run MANIFESTS FOLDER\n"), 2;
  try {
    int equal = tests::expect_native(model::Configuration(FlatOnly::config().name, FlatOnly::config()));
    equal += tests::expect_native(model::Configuration(Gamma::config().name, Gamma::config()));
    const model::Configuration objects(ObjectsMiddle::config().name, ObjectsMiddle::config());
    equal += tests::expect_native(objects);
    equal += tests::expect_merge(objects);
    std::filesystem::create_directories(argv[2]);
    for (const model::Configuration& configuration : model::named_configurations()) {
      equal += tests::expect_manifest(configuration, argv[1], fmt::format("{}/{}", argv[2], configuration.name()));
    }
    // Type γ has one more, and there are those of ztest_merge.
    const int streams = tests::kStreams * int(model::named_configurations().size() + 3) + 1 + tests::kMergeStreams;
    fmt::print("{} of {} streams are equal to the native ones\n", equal, streams);
    return equal == streams ? 0 : 1;
  } catch (const std::exception& error) {
    return fmt::print(stderr, "types_run: {}\n", error.what()), 1;
  }
}
