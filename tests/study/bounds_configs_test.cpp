// SPDX-License-Identifier: Apache-2.0
// `bounds` raises no false alarm: on every configuration of the tests, and on random ones, new with each run. They are
// HALFSPACE_CONFIGURATIONS, 20 if it is not set, from HALFSPACE_SEED, which is printed.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "study/bounds/bounds.hpp"
#include "tests/formats/random_config.hpp"

namespace halfspace::tests {
namespace {

using model::BoundRow;
using model::Configuration;

model::BoundsReport expect_holds(const Configuration& configuration, int triangles, std::uint64_t seed) {
  model::MeasureOptions options;
  options.triangles = triangles;
  options.seed = seed;
  const model::BoundsReport report = model::measured_bounds(configuration, options);
  for (const BoundRow& row : report.rows) {
    if (!row.present()) continue;
    EXPECT_EQ(row.exceeded, 0u) << row.kernel << ": " << row.quantity << ", " << row.where.kind << " "
                                << row.where.number;
    EXPECT_LE(row.seen, row.exact() ? 0 : row.proved) << row.kernel << ": " << row.quantity;
  }
  EXPECT_TRUE(report.holds());
  return report;
}

std::uint64_t number_of(const char* variable, std::uint64_t otherwise) {
  const char* const text = std::getenv(variable);
  return text ? std::strtoull(text, nullptr, 10) : otherwise;
}

TEST(BoundsOfConfigurations, InFilesHold) {
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(HALFSPACE_SOURCE "/tests/configs")) {
    if (entry.path().extension() != ".toml") continue;
    SCOPED_TRACE(entry.path().filename().string());
    const Configuration configuration = model::find_configuration(entry.path());
    if (up_converts(configuration.config())) continue;  // key frames and frames in between are measured apart
    const auto report = expect_holds(configuration, 12, 1);
    EXPECT_TRUE(report.rows[model::kShown].present());
    ++files;
  }
  EXPECT_GE(files, 40);
}

TEST(BoundsOfConfigurations, ThatNobodyNamedHold) {
  const std::uint64_t count = number_of("HALFSPACE_CONFIGURATIONS", 20);
  const std::uint64_t seed = number_of("HALFSPACE_SEED", std::random_device()());
  std::printf("HALFSPACE_SEED=%llu\n", static_cast<unsigned long long>(seed));
  RandomConfigs configs(seed);
  for (std::uint64_t n = 0; n < count && !testing::Test::HasFailure(); ++n) {
    const Configuration configuration("random", configs.next());
    SCOPED_TRACE("HALFSPACE_SEED=" + std::to_string(seed) + "\n" + model::configuration_toml(configuration));
    expect_holds(configuration, 15, seed + n);
  }
}

}  // namespace
}  // namespace halfspace::tests
