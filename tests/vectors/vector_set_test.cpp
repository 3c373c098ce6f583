// SPDX-License-Identifier: Apache-2.0
// What is committed of generated things matches what is generated: the RTL packages, and the manifests of the standard
// sets, whose digests change with any bit of any stream. Each failure names the command that writes it again.
#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "model/package/package.hpp"
#include "model/pipeline/engine.hpp"
#include "ref/error.hpp"
#include "vectors/standard_set.hpp"

namespace halfspace::tests {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

class VectorSet : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  std::string write(const std::string& name, std::uint64_t seed) {
    const ref::RasterFormat format = model::raster_format(GetParam());
    std::vector<model::NamedFrame> frames = model::corner_frames(format);
    for (auto& frame : model::random_frames(format, seed, 4, 60)) frames.push_back(std::move(frame));
    return model::write_vector_set((folder_ / name).string(),
                                   {"standard", model::find_configuration(GetParam()), 4, seed}, frames, nullptr);
  }
  fs::path folder_ = fs::temp_directory_path() / ("halfspace_vector_set_test_" + std::to_string(getpid()));
};

TEST_P(VectorSet, PackageIsTheCommittedOne) {
  const fs::path file = fs::path(HALFSPACE_SOURCE) / "rtl" / "formats" / GetParam() / "hs_formats_pkg.sv";
  EXPECT_EQ(text_of(file), model::formats_package(model::find_configuration(GetParam())))
      << file << " has drifted: run `halfspace package --config " << GetParam() << " -o " << file.string() << "`";
}

TEST_P(VectorSet, ManifestIsTheCommittedOne) {
  const fs::path file = fs::path(HALFSPACE_SOURCE) / "vectors" / "standard" / (std::string(GetParam()) + ".json");
  EXPECT_EQ(text_of(file), write("standard", 1))
      << "the bits of a stream have changed: if that is meant, run `halfspace vectors standard --config " << GetParam()
      << " --out DIR --json " << file.string() << "` and say why in the commit";
}

TEST_P(VectorSet, ManifestDescribesTheFiles) {
  const nlohmann::json manifest = nlohmann::json::parse(write("set", 1));
  ASSERT_EQ(manifest["streams"].size(), 9u);
  for (const auto& stream : manifest["streams"]) {
    std::ifstream file(folder_ / "set" / stream["file"].get<std::string>());
    std::size_t words = 0, digits = (stream["bits"].get<std::size_t>() + 3) / 4;
    for (std::string line; std::getline(file, line);) {
      if (line.rfind("//", 0) == 0) continue;
      ASSERT_EQ(line.size(), digits) << stream["name"];
      ++words;
    }
    EXPECT_EQ(words, stream["words"]) << stream["name"];
    EXPECT_GT(words, 0u) << stream["name"];
    // The fields tile the word, from its most significant bit down.
    int at = stream["bits"];
    for (const auto& field : stream["fields"]) {
      at -= field["width"].get<int>() * field["count"].get<int>();
      EXPECT_EQ(at, field["lsb"]) << stream["name"] << " " << field["name"];
    }
    EXPECT_EQ(at, 0);
  }
}

TEST_P(VectorSet, PicturesOfAllLanesComeFromOneScene) {
  EXPECT_THROW(model::make_engine(GetParam(), 3), ref::Error);
  for (const int lanes : {1, 2, 4, 8, 16}) {
    const auto engine = model::make_engine(GetParam(), lanes);
    EXPECT_EQ(engine->lanes_x() * engine->lanes_y(), lanes);
    for (const model::Layout& layout : engine->layouts()) {
      EXPECT_LE(layout.bits, model::kMaxWordBits) << layout.stream << " of " << lanes << " lanes";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Configurations, VectorSet, testing::Values("low", "middle", "high"));

}  // namespace
}  // namespace halfspace::tests
