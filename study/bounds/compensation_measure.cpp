// SPDX-License-Identifier: Apache-2.0
// motion_compensate: the weights of its tables, and what it makes of key frames with them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/motion/compensation.hpp"
#include "study/bounds/bounds_measure.hpp"
#include "study/bounds/compensation_exact.hpp"
#include "study/proofs/motion_bounds.hpp"
#include "vectors/frames/compensation_frames.hpp"

namespace halfspace::model {
namespace {

using Taps = std::array<double, 4>;

// Of an entry of the table: its weights, and those of the formula.
struct AxisEntry {
  Taps got, exact;
};

std::vector<AxisEntry> axis_entries(const Config& c, KeyFilter filter) {
  const int g = c.vector_fraction + log2_samples(c);
  std::vector<AxisEntry> out;
  for (int n = 0; n < 1 << g; ++n) {
    const AxisWeights table = axis_weights(filter, n, g, c.weight_bits);
    AxisEntry& entry = out.emplace_back();
    entry.exact = exact_weights(filter, std::ldexp(double(n), -g));
    for (std::size_t i = 0; i < 4; ++i) entry.got[i] = std::ldexp(table.tap[i], -c.weight_bits);
  }
  return out;
}

// A place between the pixels of a key, and the colours that are worst for it.
struct WorstColours {
  double error = 0;
  int x = 0, y = 0;
  bool above = false;
};

void measure_weights(const Config& c, BoundsReport& report, WorstColours& worst) {
  const std::vector<AxisEntry> entries = axis_entries(c, c.filter);
  BoundRow &weight = report.rows[kKeyWeight], &colour = report.rows[kKeyColour];
  const double full = (1 << c.colour_bits) - 1;
  // What is exact is off by what a double is.
  auto see = [](BoundRow& row, double error, const Witness& where) {
    if (row.exact() ? row.count(1, std::fabs(error) > 1e-9) : row.see(error, row.proved + 1e-9)) row.where = where;
  };
  for (std::size_t y = 0; y < entries.size(); ++y) {
    for (std::size_t i = 0; i < 4; ++i) {
      see(weight, std::ldexp(entries[y].got[i] - entries[y].exact[i], c.weight_bits),
          {fmt::format("entry {}", y), y + 1});
    }
    for (std::size_t x = 0; x < entries.size(); ++x) {
      double above = 0, below = 0;
      for (std::size_t n = 0; n < 16; ++n) {
        const double error =
            entries[x].got[n % 4] * entries[y].got[n / 4] - entries[x].exact[n % 4] * entries[y].exact[n / 4];
        (error > 0 ? above : below) += std::fabs(error);
      }
      const double error = std::max(above, below) * full;
      see(colour, error, {fmt::format("entries {} and {}", x, y), 1 + x + y * entries.size()});
      if (error > worst.error) worst = {error, int(x), int(y), above > below};
    }
  }
}

KeyFrame grey_key(int size) {
  KeyFrame key;
  key.width = key.height = size;
  key.rgb.assign(std::size_t(size) * size, {});
  key.face.assign(key.rgb.size(), 1);
  return key;
}

// A frame that shows the worst colours at the place that has them. Empty in a frame that has no room for it.
NamedCompensation worst_frame(const Config& c, const WorstColours& worst) {
  NamedCompensation frame;
  const int s = c.samples, full = (1 << c.colour_bits) - 1;
  frame.note = "the worst colours";
  frame.width = frame.height = 8 * s;
  if (frame.width > c.width || frame.height > c.height) return frame;
  const std::vector<AxisEntry> entries = axis_entries(c, c.filter);
  const AxisEntry &columns = entries[std::size_t(worst.x)], &rows = entries[std::size_t(worst.y)];
  KeyFrame key = grey_key(8);
  for (std::size_t n = 0; n < 16; ++n) {
    const double error = columns.got[n % 4] * rows.got[n / 4] - columns.exact[n % 4] * rows.exact[n / 4];
    key.rgb[8 * (2 + n / 4) + 2 + n % 4].fill((error > 0) == worst.above ? std::uint8_t(full) : std::uint8_t(0));
  }
  frame.key = {key, key};
  frame.weight = 1 << c.weight_bits;
  RawMotion m;
  m.x = m.y = 3 * s, m.face = 1;
  m.key[0].there = true;
  // From the pixel's centre to `worst` behind the centre of pixel 3 of the key.
  const int one = 1 << c.vector_fraction, centre = (s * one) / 2 - one / 2;
  m.key[0].x = worst.x + centre, m.key[0].y = worst.y + centre;
  const int most = (1 << (c.vector_range + c.vector_fraction)) - 1;
  if (std::max(m.key[0].x, m.key[0].y) > most) return frame;
  frame.motion = {m};
  // With what keeps its colour off both ends, where it would be clamped.
  if (relights(c)) {
    double value = 0;
    for (std::size_t n = 0; n < 16; ++n)
      value += columns.exact[n % 4] * rows.exact[n / 4] * key.rgb[8 * (2 + n / 4) + 2 + n % 4][0];
    frame.motion[0].key[0].difference.fill(int(std::lround(full / 2 - value)) * (1 << kDifferenceFraction));
  }
  return frame;
}

// Against exact weights, and the keys that show the point.
void measure_frame(const Configuration& configuration, const NamedCompensation& frame, std::uint64_t number,
                   BoundsReport& report) {
  const Config c = configuration.config();
  const CompensationModel exact(c, true), of_table(c, false);
  const CompensationInput input = frame.input();
  const CompensatedFrame got = Compensator(configuration).run(input);
  std::vector<RawMotion> order = frame.motion;
  order_by_tiles(order, c);
  const double full = (1 << c.colour_bits) - 1;
  BoundRow &keys = report.rows[kKeysShown], &row = report.rows[kCompensated];
  for (std::size_t n = 0; n < order.size(); ++n) {
    const CompensatedPixel& pixel = got.pixels[n];
    const Witness where = {frame.note, number, false, {}, pixel.x, pixel.y};
    const int shown = of_table.pixel(input, order[n]).keys;
    if (keys.count(1, pixel.keys != shown)) keys.where = where;
    if (pixel.keys != shown) continue;
    const CompensationModel::Pixel want = exact.pixel(input, order[n]);
    // A key whose pixels have no weight in the table but some in the formula shows another point.
    if (want.keys != shown) continue;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const double value = std::clamp(want.value[channel], 0.0, full);
      if (row.see(double(pixel.rgb[channel]) - value, row.proved + 1e-9)) row.where = where;
    }
  }
}

}  // namespace

void measure_compensation(const Configuration& configuration, std::uint64_t seed, BoundsReport& report) {
  const Config c = configuration.config();
  WorstColours worst;
  std::vector<NamedCompensation> frames = compensation_frames(c, seed);
  if (c.filter != KeyFilter::kNearest) {
    measure_weights(c, report, worst);
    frames.push_back(worst_frame(c, worst));
  }
  std::uint64_t number = 0;
  for (const NamedCompensation& frame : frames) {
    ++number;
    if (!frame.motion.empty()) measure_frame(configuration, frame, number, report);
  }
}

}  // namespace halfspace::model
