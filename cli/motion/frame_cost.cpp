// SPDX-License-Identifier: Apache-2.0
#include "cli/motion/frame_cost.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "model/motion/motion.hpp"
#include "ref/geometry/viewpoint.hpp"
#include "ref/motion/quality.hpp"

namespace halfspace::cli {

FrontEnd front_end(const model::Configuration& configuration, const ref::TriangleList& triangles, int lanes) {
  const auto engine = model::make_engine(configuration, lanes);
  const ref::SnappedList list = ref::snap(triangles, model::raster_format(configuration));
  const ref::Frame frame = engine->render(list);
  FrontEnd out{model::model_cycles(configuration.config(), *engine, list, frame)};
  out.triangles = list.triangles.size();
  for (int y = 0; y < frame.height; y += engine->lanes_y()) {
    for (int x = 0; x < frame.width; x += engine->lanes_x()) {
      ++out.stamps;
      int covered = 0;
      for (int l = 0; l < lanes; ++l) {
        const int column = x + l % engine->lanes_x(), row = y + l / engine->lanes_x();
        if (column < frame.width && row < frame.height)
          covered += frame.index[std::size_t(row) * frame.width + column] != 0;
      }
      out.pixels += covered;
      out.pixel_scan += std::max(covered, 1);
    }
  }
  return out;
}

void take(Cost& cost, const char* unit, double cycles) {
  cost.units.emplace_back(unit, cycles);
  if (cycles > cost.cycles) cost.cycles = cycles, cost.slowest = unit;
}

namespace {

// `again` goes through the same units after that.
void take_front(Cost& cost, const FrontEnd& front, const FrontEnd& again = {}) {
  const auto both = [&](auto unit) { return double(front.cycles.*unit) + double(again.cycles.*unit); };
  take(cost, "triangle_setup", both(&model::Cycles::triangle_setup));
  take(cost, "plane setup", both(&model::Cycles::shade_setup));
  take(cost, "raster_pineda", both(&model::Cycles::raster));
  cost.triangles = front.triangles;
  cost.again = again.triangles;
}

}  // namespace

// A frame as it is rendered, `samples` squared times the pixels of the picture. Multiplications are those of a pixel
// that goes through the units at one a cycle: six of the Gouraud planes; six of the coordinates, four of perspective,
// nine of the bilinear filter and the product; six of the normals and, for each light, those of hs_lighting with
// highlights. A texture is fetched from outside, four texels of 3 bytes; the picture is written.
Cost rendered(const char* name, const FrontEnd& front, double picture_pixels, bool textured, int lights) {
  Cost cost{name, false};
  take_front(cost, front);
  take(cost, "shade_gouraud", double(front.cycles.scan_out));
  cost.multiplications = 6;
  cost.bytes = 3 * picture_pixels;
  if (textured) {
    take(cost, "shade_texture", front.pixel_scan);
    cost.multiplications += 6 + 3 + 9 + 3;
    cost.bytes += 12 * front.pixels;
  }
  if (lights != 0) {
    take(cost, "shade_phong", front.pixel_scan + front.pixels * (lights - 1));
    cost.multiplications = 6 + 18 * lights;
  }
  cost.multiplications *= front.pixels / picture_pixels;
  cost.bytes /= picture_pixels;
  return cost;
}

FrontEnd holes_end(const ref::TriangleList& whole, const model::KernelFrameBetween& between,
                   const model::KernelUpConversion& mode, int lanes) {
  if (between.hole_faces.empty()) return {};
  const Config motion = mode.motion.config();
  ref::TriangleList asked{whole.width, whole.height, whole.background, {}, {}};
  for (std::size_t k = 0; k < whole.triangles.size(); ++k) {
    const std::uint32_t face = whole.face.empty() ? std::uint32_t(k + 1) : whole.face[k];
    const auto number = std::uint32_t(model::face_number(face, motion));
    if (!std::binary_search(between.hole_faces.begin(), between.hole_faces.end(), number)) continue;
    asked.triangles.push_back(whole.triangles[k]);
    asked.face.push_back(face);
  }
  return front_end(mode.colour, asked, lanes);
}

// A frame made of two keys. Multiplications: two a plane, three of perspective a key; of each key's filter three or,
// bicubic, fifteen a channel; one a channel of the blend; six of the Gouraud planes a hole. A word of motion is written
// and read, tiles are fetched, the picture is written. Half a field has a word for 2 × 2 pixels, from a front end of
// that size.
Cost made(const char* name, const FrontEnd& front, const FrontEnd& holes, double picture_pixels,
          const model::KernelFrameBetween& between, const model::KernelUpConversion& mode) {
  const model::Configuration& configuration = mode.motion;
  const Config motion = configuration.config();
  Cost cost{name, true};
  cost.psnr = ref::quality(between.colour, between.rendered, mode.width, mode.height).psnr_y;
  const double words = mode.half_field ? front.pixels : double(between.words);
  take_front(cost, front, holes);
  take(cost, "scan_index", double(front.stamps + holes.stamps));
  take(cost, "motion_field", front.pixel_scan);
  take(cost, "motion_compensate", double(between.cycles));
  const double planes = (has_perspective(motion) ? 3 : 2) + (relights(motion) ? 3 : 0);
  const double filter = motion.filter == KeyFilter::kNearest ? 0 : motion.filter == KeyFilter::kBicubic ? 15 : 3;
  cost.multiplications = (words * 2 * (2 * planes + (has_perspective(motion) ? 3 : 0)) +
                          double(between.words) * (2 * 3 * filter + 3) + 6 * double(between.shares.filled)) /
                         picture_pixels;
  cost.holes = between.shares.filled;
  double word = 0;
  for (const model::Layout& layout : model::make_engine(configuration, 1)->layouts()) {
    if (layout.stream == "motion") word = layout.bits;
  }
  const double tiles = 64 * double(between.misses[0] + between.misses[1]) * model::key_pixel_bits(motion) / 8;
  cost.word_bytes = words * 2 * word / 8 / picture_pixels, cost.key_bytes = tiles / picture_pixels;
  cost.bytes = cost.word_bytes + cost.key_bytes + 3;
  cost.words = std::size_t(words), cost.tiles = between.misses[0] + between.misses[1];
  return cost;
}

HalfField half_field(const ref::Scene& first, const ref::Scene& between, const ref::Scene& second, int width,
                     int height, const model::Configuration& colour, int lanes) {
  const Config numbers = model::default_motion(colour.config(), &between);
  const model::Configuration motion = model::motion_configuration(colour, numbers, width, height);
  const ref::View whole{width, height, colour.config().range_bits, colour.config().subpixel_bits};
  const auto cost = [&](bool half, double picture_pixels) {
    model::KernelUpConversion mode{width, height, colour, motion};
    mode.half_field = half;
    const int part = half ? 2 : 1;
    const ref::View view{width / part, height / part, colour.config().range_bits, colour.config().subpixel_bits};
    const FrontEnd front = front_end(colour, ref::project(between, view), lanes);
    model::KernelUpConverter converter(mode);
    converter.set_keys(first, second);
    const model::KernelFrameBetween frame = converter.at(between, 0.4);
    return made(half ? "a vector for 2x2 pixels" : "a vector a pixel", front,
                holes_end(ref::project(between, whole), frame, mode, lanes),
                picture_pixels > 0 ? picture_pixels : front.pixels, frame, mode);
  };
  const double pixels = front_end(colour, ref::project(between, whole), lanes).pixels;
  return {cost(false, pixels), cost(true, pixels)};
}

Table table_of(const HalfField& h, const std::string& scene) {
  Table table{"half", "", {{scene, h.whole.name, h.half.name, "saved"}}};
  const auto row = [&](const std::string& name, double whole, double half, int digits) {
    table.rows.push_back({name, fmt::format("{:.{}f}", whole, digits), fmt::format("{:.{}f}", half, digits),
                          whole > 0 ? fmt::format("{:.0f} %", 100 * (1 - half / whole)) : ""});
  };
  for (std::size_t n = 0; n < h.whole.units.size(); ++n)
    row(fmt::format("{}, cycles", h.whole.units[n].first), h.whole.units[n].second, h.half.units[n].second, 0);
  row("slowest unit, cycles", h.whole.cycles, h.half.cycles, 0);
  row("words of motion", double(h.whole.words), double(h.half.words), 0);
  row("their bytes, a pixel", h.whole.word_bytes, h.half.word_bytes, 1);
  row("bytes of keys, a pixel", h.whole.key_bytes, h.half.key_bytes, 1);
  row("all bytes, a pixel", h.whole.bytes, h.half.bytes, 1);
  row("triangles drawn again", double(h.whole.again), double(h.half.again), 0);
  row("pixels of holes", double(h.whole.holes), double(h.half.holes), 0);
  row("multiplications, a pixel", h.whole.multiplications, h.half.multiplications, 1);
  table.rows.push_back({"PSNR_Y, dB", fmt::format("{:.2f}", *h.whole.psnr), fmt::format("{:.2f}", *h.half.psnr),
                        fmt::format("{:.2f} lost", *h.whole.psnr - *h.half.psnr)});
  return table;
}

Json to_json(const HalfField& h, const std::string& scene) {
  Json json = {{"scene", scene}};
  for (const Cost* cost : {&h.whole, &h.half}) {
    Json units;
    for (const auto& [unit, cycles] : cost->units) units[unit] = cycles;
    json[cost == &h.whole ? "whole" : "half"] = {{"cycles", cost->cycles},
                                                 {"slowest", cost->slowest},
                                                 {"units", units},
                                                 {"words", cost->words},
                                                 {"triangles_again", cost->again},
                                                 {"hole_pixels", cost->holes},
                                                 {"word_bytes_a_pixel", cost->word_bytes},
                                                 {"key_bytes_a_pixel", cost->key_bytes},
                                                 {"bytes_a_pixel", cost->bytes},
                                                 {"multiplications_a_pixel", cost->multiplications},
                                                 {"psnr_y_db", *cost->psnr}};
  }
  return json;
}

}  // namespace halfspace::cli
