// SPDX-License-Identifier: Apache-2.0
// The numerical extremes of light, texture, motion, compensation and objects (vectors/frames/features), kernels
// against the reference within the derived bounds. docs/extremes.md has the promises and the numbers that this test
// prints; the RTL meets the same frames as `halfspace vectors extremes`.
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>

#include "tests/config_path.hpp"
#include "tests/formats/extremes/feature_configurations.hpp"
#include "tests/formats/extremes/frame_judge.hpp"
#include "tests/formats/extremes/unit_judges.hpp"
#include "tests/formats/random_config.hpp"
#include "vectors/frames/features/feature_extremes.hpp"

namespace halfspace::tests {
namespace {

using model::Configuration;

Configuration named(const std::string& name) { return model::find_configuration(config_path(name)); }

class FeatureExtremes : public testing::TestWithParam<std::string> {
 protected:
  const Configuration configuration_ = named(GetParam());
  const Config config_ = configuration_.config();
  const ref::RasterFormat format_ = model::raster_format(configuration_);

  // And what docs/extremes.md says of it is that.
  void print(const char* kind, std::size_t frames, const Measured& m) const {
    const std::string largest = fmt::format("{:.3f}", m.largest);
    std::printf(
        "%-15s %-22s %3zu frames %7llu numbers, %6.2f %% sharp: %s off at most, %.2f %% not the reference's; "
        "blind %llu\n",
        GetParam().c_str(), kind, frames, static_cast<unsigned long long>(m.judged),
        100 * double(m.sharp) / double(m.judged), largest.c_str(), 100 * double(m.differ) / double(m.sharp),
        static_cast<unsigned long long>(m.blind));
    const std::string size = GetParam().substr(GetParam().find('_') + 1);
    if (size != "low" && size != "middle" && size != "high") return;
    const std::string row = row_of(kind),
                      steep = fmt::format("{:.1f} %", 100 - 100 * double(m.sharp) / double(m.judged));
    for (const std::string& number : {largest, m.sharp == m.judged ? largest : steep}) {
      EXPECT_NE(row.find(number), std::string::npos) << "docs/extremes.md, row " << kind << ": there is no " << number;
    }
  }
  static std::string row_of(const std::string& kind) {
    std::ifstream page(HALFSPACE_SOURCE "/docs/extremes.md");
    std::string line;
    while (std::getline(page, line) && line.rfind("| " + kind + " |", 0) != 0) continue;
    return line;
  }
};

TEST_P(FeatureExtremes, KernelsAreWithinTheBounds) {
  const auto one = model::make_engine(configuration_, 1), four = model::make_engine(configuration_, 4);
  std::size_t classes = 0;
  for (const model::FeatureExtremeClass& kind : model::feature_extreme_classes()) {
    const std::vector<model::NamedFrame> frames = model::frames_of(kind, format_, config_);
    EXPECT_EQ(frames.empty(), !kind.is_there(config_)) << kind.name;
    Measured measured;
    for (const model::NamedFrame& frame : frames) {
      const FrameJudge judge(config_, frame);
      EXPECT_EQ(judge.fault(*one, &measured), "") << frame.note;
      EXPECT_EQ(judge.fault(*four), "") << frame.note;
    }
    if (frames.empty()) continue;
    ++classes;
    EXPECT_GT(measured.judged, 50u) << kind.name;
    EXPECT_GT(measured.sharp, (measured.judged + measured.blind) / 5) << kind.name;
    print(kind.name, frames.size(), measured);
  }
  EXPECT_GT(classes, 0u);
}

// The formula on integers, which the bounds are about, is the reference's.
class LightExtremes : public FeatureExtremes {};
TEST_P(LightExtremes, TheFormulaIsTheReference) {
  std::uint64_t compared = 0;
  for (const model::NamedFrame& frame : model::feature_extremes(format_, config_)) {
    const LightBound light(config_, frame.lighting);
    if (!light.is_unit()) continue;  // no cosine of the reference is cut to 1
    for (const model::RawNormals& t : frame.lighting.triangles) {
      for (const auto& n : t.normals) {
        const std::array<double, 3> want = light.reference(t.material, {double(n[0]), double(n[1]), double(n[2])});
        for (int c = 0; c < 3; ++c, ++compared) {
          const double got = std::clamp(double(light.sum(t.material, n, c).value), 0.0, light.full());
          ASSERT_NEAR(got, want[std::size_t(c)], 1.0 / 64) << frame.note;
        }
      }
    }
  }
  EXPECT_GT(compared, 1000u);
}

class CompensationExtremes : public FeatureExtremes {};
TEST_P(CompensationExtremes, AreTheDefinitionAndWithinTheBoundOfTheReference) {
  const model::Compensator kernels(configuration_);
  Measured measured;
  const std::vector<model::NamedCompensation> frames = model::compensation_extremes(config_);
  for (const model::NamedCompensation& frame : frames) {
    EXPECT_EQ(compensation_fault(config_, kernels, frame), "") << frame.note;
    EXPECT_EQ(compensation_reference_fault(config_, kernels, frame, measured), "") << frame.note;
  }
  EXPECT_GT(measured.judged, 100u);
  print("compensation", frames.size(), measured);
}

class MergeExtremes : public FeatureExtremes {};
TEST_P(MergeExtremes, AreTheDefinition) {
  for (const int lanes : {1, 2, 4, 8, 16}) {
    const model::Merger kernels(configuration_, lanes);
    std::vector<model::NamedMerge> runs = model::merge_extremes(config_);
    runs.push_back(model::largest_merge(config_));
    for (const model::NamedMerge& run : runs) EXPECT_EQ(merge_fault(config_, kernels, lanes, run), "") << run.note;
  }
}

TEST(FeatureExtremesOfAny, KernelsAreWithinTheBounds) {
  RandomConfigs random(11);
  std::uint64_t judged = 0;
  for (int n = 0; n < 40; ++n) {
    const Config config = that_draws_all(random.next());
    const Configuration configuration = configuration_of(config);
    SCOPED_TRACE(model::configuration_toml(configuration));
    const auto engine = model::make_engine(configuration, config.lanes);
    Measured measured;
    for (const model::NamedFrame& frame : model::feature_extremes(model::raster_format(configuration), config)) {
      EXPECT_EQ(FrameJudge(config, frame).fault(*engine, &measured), "") << frame.note;
    }
    judged += measured.judged;
    if (has_motion(config)) {
      for (const model::NamedCompensation& frame : model::compensation_extremes(config))
        EXPECT_EQ(compensation_fault(config, model::Compensator(configuration), frame), "") << frame.note;
    }
    if (!has_objects(config)) continue;
    for (const model::NamedMerge& run : model::merge_extremes(config))
      EXPECT_EQ(merge_fault(config, model::Merger(configuration, config.lanes), config.lanes, run), "") << run.note;
  }
  EXPECT_GT(judged, 100000u);
}

INSTANTIATE_TEST_SUITE_P(Of, FeatureExtremes, testing::ValuesIn(feature_configurations()));
INSTANTIATE_TEST_SUITE_P(Of, LightExtremes, testing::ValuesIn(feature_configurations(has_lighting)));
INSTANTIATE_TEST_SUITE_P(Of, CompensationExtremes, testing::ValuesIn(feature_configurations(has_motion)));
INSTANTIATE_TEST_SUITE_P(Of, MergeExtremes, testing::ValuesIn(feature_configurations(has_objects)));

}  // namespace
}  // namespace halfspace::tests
