// SPDX-License-Identifier: Apache-2.0
// No width is a bit too wide: the kernels with one derived width a bit narrower, its top bit taken away, go wrong on
// the extremes. The kernels with formats read at run time stand for the compiled ones (configuration_test).
#include <gtest/gtest.h>

#include <cstdio>

#include "model/formats/format_fields.hpp"
#include "model/pipeline/engine.hpp"
#include "vectors/frames/extremes.hpp"

namespace halfspace::tests {
namespace {

using model::Configuration;
using model::NamedFrame;

std::vector<NamedFrame> frames_of(const Configuration& configuration) {
  const ref::RasterFormat format = model::raster_format(configuration);
  std::vector<NamedFrame> frames = model::extreme_frames(format);
  for (auto& frame : model::largest_frames(format)) frames.push_back(std::move(frame));
  return frames;
}

// The first frame whose picture is off by more than the bounds allow, and how; empty when all are right.
std::string fault_of(model::Engine& engine, const std::vector<NamedFrame>& frames,
                     const std::vector<ref::Frame>& references) {
  for (std::size_t n = 0; n < frames.size(); ++n) {
    const ref::Frame kernels = engine.render(frames[n].scene);
    const ref::Frame& reference = references[n];
    for (std::size_t at = 0; at < reference.index.size(); ++at) {
      const char* what = nullptr;
      if ((kernels.index[at] != 0) != (reference.index[at] != 0)) what = "coverage";
      else if (kernels.index[at] != reference.index[at])
        what = kernels.depth[at] == reference.depth[at] ? nullptr : "index";
      else if (std::abs(std::int64_t(kernels.depth[at]) - std::int64_t(reference.depth[at])) > 1) what = "depth";
      else {
        for (int c = 0; c < 3; ++c) {
          if (std::abs(int(kernels.colour[at][c]) - int(reference.colour[at][c])) > 1) what = "colour";
        }
      }
      if (what) return std::string(what) + " in: " + frames[n].note;
    }
    if (kernels.visible != reference.visible) return "visible in: " + frames[n].note;
  }
  return "";
}

class Width : public testing::TestWithParam<const char*> {};

TEST_P(Width, IsNotABitTooWide) {
  const Configuration configuration = model::find_configuration(GetParam());
  const Config config = configuration.config();
  const std::vector<NamedFrame> frames = frames_of(configuration);
  std::vector<ref::Frame> references;
  for (const NamedFrame& frame : frames) references.push_back(ref::render(frame.scene));

  const FormatTable right = format_table(config);
  const auto engine = model::make_runtime_engine(config, right, 4);
  ASSERT_EQ(fault_of(*engine, frames, references), "");
  for (const model::FormatField& field : model::format_fields()) {
    if (field.part != Part::kBase) continue;
    FormatTable table = right;
    NumberFormat& format = table.*field.format;
    ASSERT_GT(format.width, 1) << field.name;
    --format.width;
    --format.integer;
    const auto narrower = model::make_runtime_engine(config, table, 4);
    const std::string fault = fault_of(*narrower, frames, references);
    std::printf("%-7s %-22s %2d -> %2d bits: %s\n", GetParam(), field.name, format.width + 1, format.width,
                fault.c_str());
    EXPECT_FALSE(fault.empty()) << field.name << " of " << GetParam() << " can do with " << format.width << " bits";
  }
}
INSTANTIATE_TEST_SUITE_P(Of, Width, testing::Values("low", "middle", "high"));

}  // namespace
}  // namespace halfspace::tests
