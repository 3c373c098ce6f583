// SPDX-License-Identifier: Apache-2.0
// No width of light, texture, motion, compensation or objects is a bit too wide: the kernels with one derived width a
// bit narrower, its top bit taken away, go wrong on the extremes. The widths are the rows of the format table: one that
// is new, and that no extreme needs, fails here. width_test does the same for the base pipeline.
#include <gtest/gtest.h>

#include <cstdio>
#include <memory>

#include "hls/motion/key_weights.hpp"
#include "model/formats/format_fields.hpp"
#include "tests/config_path.hpp"
#include "tests/formats/extremes/feature_configurations.hpp"
#include "tests/formats/extremes/frame_judge.hpp"
#include "tests/formats/extremes/unit_judges.hpp"
#include "tests/formats/random_config.hpp"
#include "vectors/frames/features/feature_extremes.hpp"

namespace halfspace::tests {
namespace {

using model::Configuration;

// Whether a weight that is multiplied, any but that of the pixel before the place, is 1.
bool has_weight_of_one(const Config& c) {
  const int g = c.vector_fraction + exact_log2(c.samples), one = 1 << c.weight_bits;
  for (int t = 0; c.filter != KeyFilter::kNearest && t < 1 << g; ++t) {
    const AxisWeights inner = axis_weights(inner_filter(c.filter), t, g, c.weight_bits),
                      outer = axis_weights(c.filter, t, g, c.weight_bits);
    if (inner.tap[2] == one || (c.filter == KeyFilter::kBicubic && outer.tap[2] == one)) return true;
  }
  return false;
}

// The largest sum of weighted colours, and how far below 0 the least is, a colour of full scale being 1.
std::array<double, 2> largest_sums(const Config& c) {
  if (c.filter != KeyFilter::kBicubic) return {1, 0};
  const int g = c.vector_fraction + exact_log2(c.samples);
  std::array<double, 2> most{};
  for (int t = 0; t < 1 << g; ++t) {
    std::array<double, 2> here{};
    for (const int tap : axis_weights(c.filter, t, g, c.weight_bits).tap)
      here[tap < 0] += std::ldexp(std::abs(tap), -c.weight_bits);
    if (here[0] + here[1] > most[0] + most[1]) most = here;
  }
  return {most[0] * most[0] + most[1] * most[1], 2 * most[0] * most[1]};
}

// A width whose top bit no frame can need, in configurations where its derivation is not tight.
bool is_known_to_be_wide(const std::string& field, const Config& c) {
  const FormatTable table = format_table(c);
  if (field == "tap_weight") return !has_weight_of_one(c);
  // Places in front of a frame and behind it, by as much as a vector is long: where the frame itself ends in the first
  // half of them, one behind it wraps to one in front of it, and neither shows anything.
  if (field == "key_place") {
    const int side = max_of(c.width, c.height), end = side + (1 << c.vector_range), span = 1 << bits_for(end);
    return side <= span / 2 && end + 2 * c.samples <= span;  // a filter takes two pixels of a key more
  }
  // A coarse table of weights has no sums beyond full scale.
  if (field == "key_sum" || field == "key_blend") {
    const double full = (1 << c.colour_bits) - 1, difference = c.relight ? full + 1 : 0;
    const auto [above, below] = largest_sums(c);
    const double half = std::ldexp(1.0, table.key_sum.integer - 2);
    return above * full + difference < half && below * full + difference <= half;
  }
  // A power of two of terms, none of which is as large as what they are counted as.
  if (field == "light_sum") {
    const std::int64_t terms = (has_gloss(c) ? 3 : 2) * c.lights,
                       most = (std::int64_t(1) << table.coefficient.width) - 1;
    return terms * most < std::int64_t(1) << (table.light_sum.integer - 1 + kCoefficientFraction);
  }
  // The most zeros that q = 1 has are a power of two, and then a coordinate is a whole repetition or none.
  if (field == "inverse_shift")
    return has_texture(c) && 1 << exact_log2(c.coordinate_bits - 1) == c.coordinate_bits - 1;
  return false;
}

// Everything that a configuration has extremes of.
class Extremes {
 public:
  explicit Extremes(const Configuration& configuration) : configuration_(configuration), c_(configuration.config()) {
    frames_ = model::feature_extremes(model::raster_format(configuration), c_);
    for (const model::NamedFrame& frame : frames_) judges_.push_back(std::make_unique<FrameJudge>(c_, frame));
    if (has_motion(c_)) compensations_ = model::compensation_extremes(c_);
    if (has_objects(c_)) merges_ = model::merge_extremes(c_), merges_.push_back(model::largest_merge(c_));
  }

  // What is wrong with the kernels of this table, and in which frame; empty if nothing is.
  std::string fault(const FormatTable& table) const {
    for (const model::NamedCompensation& frame : compensations_) {
      const std::string what = compensation_fault(c_, model::Compensator(configuration_, table), frame);
      if (!what.empty()) return what + " in: " + frame.note;
    }
    for (const model::NamedMerge& run : merges_) {
      const std::string what = merge_fault(c_, model::Merger(configuration_, table, kLanes), kLanes, run);
      if (!what.empty()) return what + " in: " + run.note;
    }
    return frames_.empty() ? "" : frame_fault(table);
  }

 private:
  std::string frame_fault(const FormatTable& table) const {
    const auto engine = model::make_runtime_engine(c_, table, kLanes);
    for (std::size_t n = 0; n < frames_.size(); ++n) {
      const std::string what = judges_[n]->fault(*engine);
      if (!what.empty()) return what + " in: " + frames_[n].note;
    }
    return "";
  }

  static constexpr int kLanes = 4;
  const Configuration configuration_;
  const Config c_;
  std::vector<model::NamedFrame> frames_;
  std::vector<std::unique_ptr<FrameJudge>> judges_;
  std::vector<model::NamedCompensation> compensations_;
  std::vector<model::NamedMerge> merges_;
};

void expect_no_width_a_bit_too_wide(const Configuration& configuration) {
  const Config config = configuration.config();
  const Extremes extremes(configuration);
  const FormatTable right = format_table(config);
  ASSERT_EQ(extremes.fault(right), "");
  for (const model::FormatField& field : model::format_fields()) {
    if (field.part == Part::kBase || !field.is_used(config)) continue;
    FormatTable table = right;
    NumberFormat& format = table.*field.format;
    if (format.width == 1) continue;
    --format.width;
    --format.integer;
    const std::string fault = extremes.fault(table);
    std::printf("%-15s %-26s %2d -> %2d bits: %s\n", configuration.name().c_str(), field.name, format.width + 1,
                format.width, fault.c_str());
    if (is_known_to_be_wide(field.name, config)) {
      EXPECT_EQ(fault, "") << field.name << " is no longer a bit too wide: say so";
    } else {
      EXPECT_FALSE(fault.empty()) << field.name << " can do with " << format.width << " bits";
    }
  }
}

class FeatureWidth : public testing::TestWithParam<std::string> {};
TEST_P(FeatureWidth, IsNotABitTooWide) {
  expect_no_width_a_bit_too_wide(model::find_configuration(config_path(GetParam())));
}
INSTANTIATE_TEST_SUITE_P(Of, FeatureWidth, testing::ValuesIn(feature_configurations()));

TEST(FeatureWidths, OfRandomConfigurationsAreNotABitTooWide) {
  RandomConfigs random(7);
  for (int n = 0; n < 12;) {
    const Config config = that_draws_all(random.next());
    // The least in which an extreme can show.
    const int pixels = 12 * max_of(config.samples, 1);
    if (!has_feature(config) || std::min(config.width, config.height) < pixels || config.colour_bits < 4) continue;
    if (has_texture(config) && config.texels < 32) continue;
    ++n;
    const Configuration configuration = configuration_of(config);
    SCOPED_TRACE(model::configuration_toml(configuration));
    expect_no_width_a_bit_too_wide(configuration);
  }
}

// Each row is taken a bit from in one configuration at least; but for those of index_pool, which no extreme has.
TEST(FeatureWidths, AreAllTried) {
  for (const model::FormatField& field : model::format_fields()) {
    if (field.part == Part::kBase || field.part == Part::kIndices) continue;
    bool tried = false;
    for (const std::string& name : feature_configurations()) {
      const Config config = model::find_configuration(config_path(name)).config();
      tried = tried || (field.is_used(config) && (format_table(config).*field.format).width > 1 &&
                        !is_known_to_be_wide(field.name, config));
    }
    EXPECT_TRUE(tried) << field.name;
  }
}

}  // namespace
}  // namespace halfspace::tests
