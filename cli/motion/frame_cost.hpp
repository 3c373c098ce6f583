// SPDX-License-Identifier: Apache-2.0
// What a frame between key frames takes, rendered and made of them, unit by unit.
#ifndef HALFSPACE_CLI_MOTION_FRAME_COST_HPP_
#define HALFSPACE_CLI_MOTION_FRAME_COST_HPP_

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/commands.hpp"
#include "cli/common/table.hpp"
#include "model/drivers/up_convert.hpp"
#include "model/pipeline/cycles.hpp"

namespace halfspace::cli {

// What a frame takes, by the units that each way to make it has.
struct Cost {
  const char* name;
  bool made;          // of key frames; else rendered
  double cycles = 0;  // of the slowest unit
  const char* slowest = "";
  double multiplications = 0;                           // a covered pixel of the frame
  double bytes = 0;                                     // likewise, to and from memory outside
  std::size_t triangles = 0;                            // handed to the pipeline
  std::size_t words = 0, tiles = 0;                     // of motion, and of keys
  std::size_t again = 0, holes = 0;                     // triangles drawn again for holes, and pixels of these
  std::optional<double> psnr = std::nullopt;            // PSNR_Y against the rendered frame, of one that is made
  std::vector<std::pair<const char*, double>> units{};  // cycles of each
  double word_bytes = 0, key_bytes = 0;                 // a covered pixel, of bytes: of motion, of keys
};

// What the renderer's units would take for themselves, of a frame of which triangles and pixels are at hand.
struct FrontEnd {
  model::Cycles cycles;
  double pixels = 0;      // covered
  double pixel_scan = 0;  // cycles of a unit that takes a covered pixel at a time, and one for a stamp of background
  std::size_t triangles = 0, stamps = 0;
};

FrontEnd front_end(const model::Configuration&, const ref::TriangleList&, int lanes);
// The units of setup and rasterizer, of either kind of frame.
void take(Cost&, const char* unit, double cycles);

// A frame as it is rendered, samples squared times the pixels of the picture.
Cost rendered(const char* name, const FrontEnd&, double picture_pixels, bool textured, int lights);
// Of a whole frame, as the colours are drawn, the triangles that have holes: they are asked for and drawn once more,
// and shaded at the holes.
FrontEnd holes_end(const ref::TriangleList& whole, const model::KernelFrameBetween&, const model::KernelUpConversion&,
                   int lanes);
// A frame made of two keys, and its holes. Half a field has a word for 2 × 2 pixels, from a front end of that size.
Cost made(const char* name, const FrontEnd& field, const FrontEnd& holes, double picture_pixels,
          const model::KernelFrameBetween&, const model::KernelUpConversion&);

// The middle frame between keys five apart, by a vector a pixel and by one for 2 × 2.
struct HalfField {
  Cost whole, half;
};
HalfField half_field(const ref::Scene& first, const ref::Scene& between, const ref::Scene& second, int width,
                     int height, const model::Configuration& colour, int lanes);
// Cycles of each unit, bytes, dB: of the whole, of half, and what is saved.
Table table_of(const HalfField&, const std::string& scene);
Json to_json(const HalfField&, const std::string& scene);

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_MOTION_FRAME_COST_HPP_
