// SPDX-License-Identifier: Apache-2.0
#include "vectors/engine.hpp"

#include <fmt/format.h>

#include "hls/formats.hpp"
#include "ref/error.hpp"

namespace halfspace::vectors {

std::unique_ptr<Engine> make_engine_low(int lanes);
std::unique_ptr<Engine> make_engine_middle(int lanes);
std::unique_ptr<Engine> make_engine_high(int lanes);

namespace {

ref::RasterFormat raster_format(const Config& c) {
  return {c.name, c.width, c.height, c.triangles, c.range_bits, c.subpixel_bits, c.depth_bits};
}

}  // namespace

std::vector<ref::RasterFormat> raster_formats() {
  return {raster_format(Low::config()), raster_format(Middle::config()), raster_format(High::config())};
}

ref::RasterFormat raster_format(const std::string& config) {
  for (const ref::RasterFormat& format : raster_formats()) {
    if (format.name == config) return format;
  }
  throw ref::Error(fmt::format("there is no configuration '{}': use low, middle or high", config));
}

std::unique_ptr<Engine> make_engine(const std::string& config, int lanes) {
  std::unique_ptr<Engine> engine;
  if (config == "low") engine = make_engine_low(lanes);
  else if (config == "middle") engine = make_engine_middle(lanes);
  else if (config == "high") engine = make_engine_high(lanes);
  else raster_format(config);
  if (!engine) throw ref::Error(fmt::format("there is no stamp of {} lanes: use 1, 2, 4, 8 or 16", lanes));
  return engine;
}

}  // namespace halfspace::vectors
