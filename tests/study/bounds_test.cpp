// SPDX-License-Identifier: Apache-2.0
// No error that is seen exceeds its proved bound, in any configuration, and in the named ones the bounds are tight.
#include <gtest/gtest.h>

#include <cmath>

#include "hls/formats/formats.hpp"
#include "study/bounds/bounds.hpp"
#include "study/bounds/bounds_measure.hpp"

namespace halfspace::tests {
namespace {

using model::BoundRow;
using model::BoundsReport;
using model::Configuration;

void expect_holds(const BoundsReport& report) {
  EXPECT_TRUE(report.holds());
  for (const BoundRow& row : report.rows) {
    if (!row.present()) continue;
    EXPECT_GT(row.compared, 0u) << row.kernel << ": " << row.quantity;
    EXPECT_EQ(row.exceeded, 0u) << row.kernel << ": " << row.quantity << ", " << row.where.kind << " "
                                << row.where.number;
    EXPECT_LE(row.seen, row.proved) << row.kernel << ": " << row.quantity;
  }
}

BoundsReport measured(const Configuration& configuration, int triangles, std::uint64_t seed) {
  model::MeasureOptions options;
  options.triangles = triangles;
  options.seed = seed;
  return model::measured_bounds(configuration, options);
}

TEST(Bounds, OfNamedConfigurationsHoldAndAreTight) {
  for (const Configuration& configuration : model::named_configurations()) {
    SCOPED_TRACE(configuration.name());
    const BoundsReport report = measured(configuration, 300, 7);
    expect_holds(report);
    for (const BoundRow& row : report.rows) {
      if (row.exact()) continue;
      EXPECT_GE(row.seen, row.proved / 2) << row.kernel << ": " << row.quantity;
      std::printf("%-7s %-15s %-21s %.4g of %.4g\n", configuration.name().c_str(), row.kernel.c_str(),
                  row.quantity.c_str(), row.seen, row.proved);
    }
    EXPECT_LE(report.rows[model::kDepthPlane].proved, 0.39) << "the goal for depth before rounding";
    EXPECT_LE(report.rows[model::kColourPlane].proved, 1.0 / 16) << "the goal for colour before rounding";
  }
}

// What objects add is exact, and looked at, with few objects and with many.
TEST(Bounds, OfConfigurationsWithObjectsHold) {
  for (const int bits : {1, 4, 22}) {
    Config c = model::find_configuration("low").config();
    c.object_bits = bits;
    const BoundsReport report = measured(Configuration("objects", c), 10, 5);
    expect_holds(report);
    for (const model::Quantity quantity : {model::kEntry, model::kMerge, model::kMergeFound}) {
      EXPECT_TRUE(report.rows[quantity].present());
      EXPECT_TRUE(report.rows[quantity].exact());
    }
    EXPECT_GT(report.rows[model::kMerge].compared, 10000u);
  }
  EXPECT_FALSE(measured(model::find_configuration("low"), 1, 5).rows[model::kMerge].present());
}

// A place that is named is the place: its triangle alone has the error again.
TEST(Bounds, AreSeenAgainWhereTheyWereSeen) {
  const Configuration configuration = model::find_configuration("middle");
  const Config config = configuration.config();
  const BoundsReport report = measured(configuration, 50, 3);
  int again = 0;
  for (int quantity = 0; quantity < model::kQuantities; ++quantity) {
    const BoundRow& row = report.rows[quantity];
    if (!row.where.is_triangle) continue;
    BoundsReport alone = model::proved_bounds(config);
    model::TriangleMeter meter(configuration, alone);
    meter.begin("alone", config.width, config.height);
    meter.measure(row.where.triangle);
    EXPECT_EQ(alone.rows[quantity].seen, row.seen) << row.kernel << ": " << row.quantity;
    ++again;
  }
  EXPECT_EQ(again, 10);
}

// The meter is not blind: kernels with a bit less are beyond the bounds that hold with it.
TEST(Bounds, AreExceededWithABitLess) {
  int tried = 0;
  auto expect_exceeded = [&](const Configuration& configuration, int Config::*number, model::Quantity quantity,
                             int lost) {
    Config less = configuration.config();
    less.*number -= 1;
    if (refusal(less) != Refusal::kNone) return;
    ++tried;
    // `lost`: bits by which the unit of the quantity has grown with it.
    const double seen = std::ldexp(measured(Configuration("less", less), 100, 7).rows[quantity].seen, lost);
    EXPECT_GT(seen, model::proved_bounds(configuration.config()).rows[quantity].proved) << configuration.name();
  };
  for (const Configuration& configuration : model::named_configurations()) {
    expect_exceeded(configuration, &Config::reciprocal_bits, model::kReciprocal, 1);
    expect_exceeded(configuration, &Config::depth_fraction, model::kDepthPlane, 0);
    expect_exceeded(configuration, &Config::colour_fraction, model::kColourPlane, 0);
  }
  EXPECT_GE(tried, 6);
}

// The largest values behind the widths. Each is linear in every one of its variables, so it is largest where all of
// them are at an end of their range: the ends are tried, all of them.
TEST(Bounds, OfExactNumbersAreReachedAtTheEndsOfTheirRanges) {
  using model::Wide;
  for (const Configuration& configuration : model::named_configurations()) {
    const Config c = configuration.config();
    const FormatTable table = format_table(c);
    const std::int64_t low = -(std::int64_t(1) << (table.coord.width - 1)), high = -low - 1;
    const std::int64_t full = (std::int64_t(1) << c.depth_bits) - 1;
    Wide delta = 0, area = 0, edge_low = 0, edge_high = 0, numerator = 0;
    for (unsigned ends = 0; ends < 1u << 9; ++ends) {
      auto position = [&](int n) { return Wide(ends >> n & 1 ? high : low); };
      auto depth = [&](int n) { return Wide(ends >> n & 1 ? full : 0); };
      const Wide dx1 = position(2) - position(0), dy1 = position(3) - position(1);
      const Wide dx2 = position(4) - position(0), dy2 = position(5) - position(1);
      const Wide cross = dx1 * dy2 - dx2 * dy1;
      delta = std::max(delta, dx1 < 0 ? -dx1 : dx1);
      area = std::max(area, cross);
      edge_low = std::min(edge_low, cross - 1), edge_high = std::max(edge_high, cross);
      const Wide n = (depth(7) - depth(6)) * dy2 - (depth(8) - depth(6)) * dy1;
      numerator = std::max(numerator, n < 0 ? -n : n);
    }
    auto fits = [](Wide largest, int bits) { return largest < Wide(1) << bits; };
    // Wide enough, and not with a bit less.
    auto expect_bits = [&](Wide largest, int bits) {
      EXPECT_TRUE(fits(largest, bits)) << bits;
      EXPECT_FALSE(fits(largest, bits - 1)) << bits;
    };
    expect_bits(delta, table.delta.width - 1);
    expect_bits(area, table.area.width);
    expect_bits(edge_high, table.edge.width - 1);
    EXPECT_GE(edge_low, -(Wide(1) << (table.edge.width - 1)));
    expect_bits(numerator, c.depth_bits + table.coord.width);
    EXPECT_LT(c.depth_bits + table.coord.width, table.depth_numerator.width);
  }
}

}  // namespace
}  // namespace halfspace::tests
