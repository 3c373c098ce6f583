// SPDX-License-Identifier: Apache-2.0
// Configurations: files, headers and refusals; and the kernels with formats read at run time against the compiled ones.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "model/formats/format_fields.hpp"
#include "model/pipeline/engine.hpp"
#include "ref/error.hpp"
#include "tests/formats/random_config.hpp"
#include "tests/formats/streams_of.hpp"
#include "vectors/standard_set.hpp"

namespace halfspace::tests {
namespace {

using model::Configuration;

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string refusal_of(const std::string& toml) {
  try {
    model::parse_configuration(toml, "x.toml");
  } catch (const ref::Error& e) {
    return e.what();
  }
  return "accepted";
}

// The text of `middle` with one line in the place of another.
std::string middle_with(const std::string& field, const std::string& line) {
  std::istringstream in(model::configuration_toml(model::find_configuration("middle")));
  std::string text, one;
  while (std::getline(in, one)) text += (one.rfind(field + " ", 0) == 0 ? line : one) + "\n";
  return text;
}

TEST(Configuration, HeadersAreWhatTheFilesSay) {
  for (const Configuration& named : model::named_configurations()) {
    const std::string stem = std::string(HALFSPACE_SOURCE) + "/hls/formats/configs/" + named.name();
    const Configuration file = model::find_configuration(stem + ".toml");
    EXPECT_EQ(text_of(stem + ".toml"), model::configuration_toml(file));
    EXPECT_EQ(text_of(stem + ".hpp"), model::configuration_header(file))
        << "run `halfspace config " << stem << ".toml --header " << stem << ".hpp`";
    EXPECT_EQ(file.name(), named.name());
    EXPECT_EQ(model::configuration_toml(file), model::configuration_toml(named));
  }
}

TEST(Configuration, RefusesWithItsReason) {
  const std::pair<std::string, std::string> cases[] = {
      {middle_with("width", "width = 9000"), "width and height are 1 to 8192"},
      {middle_with("width", "width = 1020"), "raise range_bits"},
      {middle_with("width", "width = 640.0"), "x.toml:2: width is a whole number"},
      {middle_with("width", "width 640"), "x.toml:2:"},
      {middle_with("width", "widht = 640"), "there is no field 'widht'"},
      {middle_with("width", ""), "the field 'width' is missing"},
      {middle_with("name", "name = \"../x\""), "a name has letters"},
      {middle_with("triangles", "triangles = 1"), "triangles is 2 to"},
      {middle_with("subpixel_bits", "subpixel_bits = 0"), "subpixel_bits is 1 to 12"},
      {middle_with("depth_bits", "depth_bits = 33"), "depth_bits is 2 to 32"},
      {middle_with("colour_bits", "colour_bits = 9"), "colour_bits is 1 to 8"},
      {middle_with("lanes", "lanes = 3"), "lanes is 1, 2, 4, 8 or 16"},
      {middle_with("reciprocal_bits", "reciprocal_bits = 50"), "reciprocal_bits is 2 to 40"},
      {middle_with("reciprocal_bits", "reciprocal_bits = 25"), "depth planes can be off by half an LSB"},
      {middle_with("depth_fraction", "depth_fraction = 11"), "depth planes can be off by half an LSB"},
      {middle_with("colour_fraction", "colour_fraction = 11"), "colour planes can be off by half an LSB"},
      {middle_with("colour_fraction", "colour_fraction = 19"), "reciprocal_bits is subpixel_bits +"},
  };
  for (const auto& [toml, sentence] : cases)
    EXPECT_NE(refusal_of(toml).find(sentence), std::string::npos) << refusal_of(toml);
  EXPECT_EQ(refusal_of(middle_with("lanes", "lanes = 16")), "accepted");
  // The half that rounds a gradient of the largest triangle would be 2^66.
  EXPECT_EQ(refusal(Config{"x", 100, 100, 100, 20, 10, 8, 8, 38, 21, 21, 1}), Refusal::kGradientWord);
}

TEST(Configuration, AtRunTimeGivesTheBitsOfTheCompiledKernels) {
  for (const Configuration& named : model::named_configurations()) {
    const Config config = named.config();
    std::vector<model::NamedFrame> frames = model::corner_frames(model::raster_format(named));
    for (auto& frame : model::random_frames(model::raster_format(named), 5, 8, 60)) frames.push_back(std::move(frame));
    for (const int lanes : {1, 2, 4, 8, 16}) {
      SCOPED_TRACE(named.name() + ", lanes " + std::to_string(lanes));
      const auto compiled = model::make_engine(named, lanes);
      const auto runtime = model::make_runtime_engine(config, format_table(config), lanes);
      const std::string streams = streams_of(*compiled, frames);
      EXPECT_GT(streams.size(), 100000u);
      EXPECT_TRUE(streams == streams_of(*runtime, frames));
    }
  }
}

// In every configuration of the tests a number that is more than it may be is refused, and so is one of what is not
// there. Each is refused with its limits in some of them.
TEST(Configuration, HoldsEveryNumberToItsLimits) {
  std::set<std::string> held;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(HALFSPACE_SOURCE "/tests/configs")) {
    if (entry.path().extension() != ".toml") continue;
    const Configuration file = model::find_configuration(entry.path());
    EXPECT_EQ(text_of(entry.path()), model::configuration_toml(file)) << "run `halfspace config FILE --toml FILE`";
    for (const model::ConfigField& field : model::config_fields()) {
      if (!field.is_number()) continue;
      SCOPED_TRACE(file.name() + ": " + field.name);
      Config c = file.config();
      const bool is_idle = !has_part(field.part, c) && !field.allowed.is_optional;
      field.set(c, is_idle ? field.allowed.high : field.allowed.high + 1);
      const Refusal reason = refusal(c);
      EXPECT_NE(reason, Refusal::kNone);
      if (reason != field.refused) continue;
      EXPECT_NE(model::refusal_text(reason).find(field.name), std::string::npos) << model::refusal_text(reason);
      held.insert(field.name);
    }
  }
  for (const model::ConfigField& field : model::config_fields()) {
    EXPECT_EQ(held.count(field.name), field.is_number() ? 1u : 0u) << field.name;
  }
}

// Two engines of different formats take turns: neither sees the other's.
TEST(Configuration, EnginesDoNotShareFormats) {
  const Config low = model::find_configuration("low").config(), high = model::find_configuration("high").config();
  const auto frames_low = model::random_frames(model::raster_format("low"), 3, 2, 20);
  const auto frames_high = model::random_frames(model::raster_format("high"), 3, 2, 20);
  const auto a = model::make_runtime_engine(low, format_table(low), 4),
             b = model::make_runtime_engine(high, format_table(high), 4);
  const std::string first = streams_of(*a, frames_low);
  streams_of(*b, frames_high);
  EXPECT_TRUE(first == streams_of(*a, frames_low));
}

// Configurations that nobody named: coverage is exact and the bounds hold, whatever the numbers.
TEST(Configuration, OfRandomNumbersIsAcceptedOrRefusedAndRight) {
  RandomConfigs configs(11);
  for (int n = 0; n < 60; ++n) {
    Config numbers = configs.plain();
    while (!has_depth(numbers) || !is_gouraud(numbers)) numbers = configs.plain();
    const Configuration configuration("random", numbers);
    SCOPED_TRACE(model::configuration_toml(configuration));
    const auto engine = model::make_engine(configuration, numbers.lanes);
    for (const auto& frame : model::random_frames(model::raster_format(configuration), n, 2, 40)) {
      const ref::Frame kernels = engine->render(frame.scene), reference = ref::render(frame.scene);
      for (std::size_t at = 0; at < reference.index.size(); ++at) {
        // A fragment that one of them rounds to full depth does not pass there.
        const bool at_the_end =
            std::min(kernels.depth[at], reference.depth[at]) + 1 >= ref::full_depth(numbers.depth_bits);
        ASSERT_TRUE(at_the_end || (kernels.index[at] != 0) == (reference.index[at] != 0)) << "pixel " << at;
        if (kernels.index[at] != reference.index[at]) continue;
        ASSERT_LE(std::abs(std::int64_t(kernels.depth[at]) - std::int64_t(reference.depth[at])), 1) << "pixel " << at;
      }
    }
  }
}

// What tells configurations apart: each number alone, and no name.
TEST(Configuration, IsTheSameWhenAllNumbersAre) {
  const Config low = model::find_configuration("low").config();
  Config other = low;
  other.name = "other";
  EXPECT_TRUE(model::same_numbers(low, other));
  for (const model::ConfigField& field : model::config_fields()) {
    other = low;
    field.set(other, field.get(low) + 1);
    EXPECT_FALSE(model::same_numbers(low, other)) << field.name;
  }
  other = low;
  other.architecture = Architecture::kGamma;
  EXPECT_FALSE(model::is_compiled({"low", other}));
  other = low;
  other.lanes = 16;
  EXPECT_TRUE(model::is_compiled({"low", other}));
}

}  // namespace
}  // namespace halfspace::tests
