// SPDX-License-Identifier: Apache-2.0
// Compensation from its definition: taps by their distance from a place, no cache, numbers in double. Weights are those
// of the tables, or exact ones.
#ifndef HALFSPACE_STUDY_BOUNDS_COMPENSATION_EXACT_HPP_
#define HALFSPACE_STUDY_BOUNDS_COMPENSATION_EXACT_HPP_

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "hls/motion/key_filter.hpp"
#include "model/motion/compensation.hpp"

namespace halfspace::model {

// Weights of the pixels −1 … 2 around a place that lies t behind the centre of pixel 0.
inline std::array<double, 4> exact_weights(KeyFilter filter, double t) {
  switch (filter) {
    case KeyFilter::kBicubic:
      return {(-t + 2 * t * t - t * t * t) / 2, (2 - 5 * t * t + 3 * t * t * t) / 2,
              (t + 4 * t * t - 3 * t * t * t) / 2, (t * t * t - t * t) / 2};
    case KeyFilter::kArea: {
      const double sum = (1 - t) * (1 - t) + t * t;
      return {0, (1 - t) * (1 - t) / sum, t * t / sum, 0};
    }
    default: return {0, 1 - t, t, 0};
  }
}

class CompensationModel {
 public:
  // Exact weights, or those of the tables.
  CompensationModel(const Config& config, bool exact) : c_(config), exact_(exact) {}

  using Colour = std::array<double, 3>;

  // Before it is blended; nothing where the key does not show the point.
  std::optional<Colour> key(const CompensationInput& in, const RawMotion& m, int k) const {
    const RawKeyVector& v = m.key[std::size_t(k)];
    if (m.face == 0 || !v.there) return std::nullopt;
    const double x = place(m.x, v.x), y = place(m.y, v.y);
    Colour sum{};
    if (c_.filter == KeyFilter::kNearest) {
      const Tap tap = tap_at(in, m, k, int(std::floor(x)), int(std::floor(y)));
      if (!tap.match) return std::nullopt;
      sum = tap.colour;
    } else {
      const int left = int(std::floor(x - 0.5)), top = int(std::floor(y - 0.5));
      const double t = x - 0.5 - left, u = y - 0.5 - top;
      bool all = c_.filter == KeyFilter::kBicubic;
      for (int j = -1; all && j < 3; ++j) {
        for (int i = -1; i < 3; ++i) all = all && tap_at(in, m, k, left + i, top + j).match;
      }
      if (all) {
        const std::array<double, 4> columns = weights(c_.filter, t), rows = weights(c_.filter, u);
        for (int n = 0; n < 16; ++n) {
          add(sum, columns[std::size_t(n % 4)] * rows[std::size_t(n / 4)],
              tap_at(in, m, k, left - 1 + n % 4, top - 1 + n / 4).colour);
        }
      } else if (!of_four(in, m, k, left, top, t, u, sum)) {
        return std::nullopt;
      }
    }
    for (std::size_t c = 0; c < 3; ++c) sum[c] += std::ldexp(double(v.difference[c]), -kDifferenceFraction);
    return sum;
  }

  struct Pixel {
    Colour value{};  // before it is rounded and clamped
    int keys = 0;
  };
  Pixel pixel(const CompensationInput& in, const RawMotion& m) const {
    const std::optional<Colour> a = key(in, m, 0), b = key(in, m, 1);
    Pixel out;
    out.keys = int(a.has_value()) | int(b.has_value()) << 1;
    const double weight = std::ldexp(in.weight, -c_.weight_bits);
    for (std::size_t c = 0; c < 3; ++c) {
      out.value[c] = a && b ? weight * (*a)[c] + (1 - weight) * (*b)[c] : a ? (*a)[c] : b ? (*b)[c] : 0;
    }
    return out;
  }

  // Of key k at `way` pixels from the centre of a pixel in between, without relighting; nothing where a place within
  // `bound` of it takes a pixel that does not match or, of the nearest, another pixel.
  std::optional<Colour> around(const CompensationInput& in, const RawMotion& m, int k, const std::array<double, 2>& way,
                               const std::array<double, 2>& bound) const {
    const bool nearest = c_.filter == KeyFilter::kNearest, bicubic = c_.filter == KeyFilter::kBicubic;
    const double half = nearest ? 0 : 0.5;
    double at[2];
    int first[2], last[2];
    for (int axis = 0; axis < 2; ++axis) {
      const double centre = (axis ? m.y : m.x) + 0.5 + way[std::size_t(axis)], off = bound[std::size_t(axis)];
      at[axis] = centre / c_.samples - half;
      first[axis] = int(std::floor((centre - off) / c_.samples - half)) - int(bicubic);
      last[axis] = int(std::floor((centre + off) / c_.samples - half)) + (nearest ? 0 : bicubic ? 2 : 1);
    }
    if (nearest && (first[0] != last[0] || first[1] != last[1])) return std::nullopt;
    for (int y = first[1]; y <= last[1]; ++y) {
      for (int x = first[0]; x <= last[0]; ++x) {
        if (!tap_at(in, m, k, x, y).match) return std::nullopt;
      }
    }
    Colour sum{};
    const int left = int(std::floor(at[0])), top = int(std::floor(at[1]));
    if (nearest) return tap_at(in, m, k, left, top).colour;
    const std::array<double, 4> columns = exact_weights(c_.filter, at[0] - left),
                                rows = exact_weights(c_.filter, at[1] - top);
    for (int n = 0; n < 16; ++n) {
      const double weight = columns[std::size_t(n % 4)] * rows[std::size_t(n / 4)];
      if (weight != 0) add(sum, weight, tap_at(in, m, k, left - 1 + n % 4, top - 1 + n / 4).colour);
    }
    return sum;
  }

  std::uint8_t displayed(double value) const {
    return std::uint8_t(std::clamp(std::floor(value + 0.5), 0.0, double((1 << c_.colour_bits) - 1)));
  }

  // Tiles that a cache of 2 × 2 of them has not, for words in this order.
  std::size_t misses(const CompensationInput& in, const std::vector<CompensatedPixel>& order, int k) const {
    std::map<std::pair<int, int>, const RawMotion*> at;
    for (const RawMotion& m : in.motion) at[{m.x, m.y}] = &m;
    std::map<std::pair<int, int>, std::pair<int, int>> cache;
    std::size_t missed = 0;
    for (const CompensatedPixel& p : order) {
      const RawMotion& m = *at.at({p.x, p.y});
      if (m.face == 0 || !m.key[std::size_t(k)].there) continue;
      for (const auto& [x, y] : tiles(in, m, k)) {
        auto [slot, is_new] = cache.emplace(std::make_pair(x % 2, y % 2), std::make_pair(x, y));
        if (!is_new && slot->second == std::make_pair(x, y)) continue;
        slot->second = {x, y};
        ++missed;
      }
    }
    return missed;
  }

 private:
  struct Tap {
    bool match;
    Colour colour;
  };

  double place(int pixel, int vector) const {
    return (pixel + 0.5 + std::ldexp(vector, -c_.vector_fraction)) / c_.samples;
  }

  std::array<double, 4> weights(KeyFilter filter, double t) const {
    if (exact_) return exact_weights(filter, t);
    const int g = c_.vector_fraction + exact_log2(c_.samples);
    const AxisWeights table = axis_weights(filter, std::int64_t(std::ldexp(t, g)), g, c_.weight_bits);
    std::array<double, 4> out{};
    for (std::size_t i = 0; i < 4; ++i) out[i] = std::ldexp(table.tap[i], -c_.weight_bits);
    return out;
  }

  static void add(Colour& sum, double weight, const Colour& colour) {
    for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * colour[c];
  }

  Tap tap_at(const CompensationInput& in, const RawMotion& m, int k, int x, int y) const {
    const KeyFrame& key = *in.key[std::size_t(k)];
    if (x < 0 || y < 0 || x >= key.width || y >= key.height) return {false, {}};
    const std::size_t at = std::size_t(y) * key.width + x;
    return {key.face[at] == m.face, {double(key.rgb[at][0]), double(key.rgb[at][1]), double(key.rgb[at][2])}};
  }

  // Whether one of them matches that has a weight. The weight of the others goes to the one with the largest exact
  // weight; of two alike, to the first in the order of standing_tap.
  bool of_four(const CompensationInput& in, const RawMotion& m, int k, int left, int top, double t, double u,
               Colour& sum) const {
    const KeyFilter filter = c_.filter == KeyFilter::kBicubic ? KeyFilter::kBilinear : c_.filter;
    const std::array<double, 4> columns = weights(filter, t), rows = weights(filter, u);
    const int near_x = t >= 0.5, near_y = u >= 0.5;
    const bool x_first = std::fabs(t - 0.5) <= std::fabs(u - 0.5);
    Tap standing{false, {}};
    double largest = -1, lost = 0;
    for (int n = 0; n < 4; ++n) {
      const bool flip_x = n == 3 || n == (x_first ? 1 : 2), flip_y = n == 3 || n == (x_first ? 2 : 1);
      const int i = near_x ^ int(flip_x), j = near_y ^ int(flip_y);
      const Tap tap = tap_at(in, m, k, left + i, top + j);
      const double weight = columns[std::size_t(1 + i)] * rows[std::size_t(1 + j)];
      const double exact = (i ? t : 1 - t) * (j ? u : 1 - u);
      if (tap.match && weight > 0 && exact > largest) standing = tap, largest = exact;
      if (tap.match) add(sum, weight, tap.colour);
      else lost += weight;
    }
    if (standing.match) add(sum, lost, standing.colour);
    return standing.match;
  }

  std::set<std::pair<int, int>> tiles(const CompensationInput& in, const RawMotion& m, int k) const {
    const RawKeyVector& v = m.key[std::size_t(k)];
    const KeyFrame& key = *in.key[std::size_t(k)];
    const double x = place(m.x, v.x), y = place(m.y, v.y);
    const bool nearest = c_.filter == KeyFilter::kNearest, bicubic = c_.filter == KeyFilter::kBicubic;
    const int before = bicubic ? 1 : 0, after = bicubic ? 2 : nearest ? 0 : 1;
    const int column = int(std::floor(nearest ? x : x - 0.5)), row = int(std::floor(nearest ? y : y - 0.5));
    std::set<std::pair<int, int>> out;
    for (int j = row - before; j <= row + after; ++j) {
      for (int i = column - before; i <= column + after; ++i) {
        if (i >= 0 && j >= 0 && i < key.width && j < key.height) out.insert({i / 8, j / 8});
      }
    }
    return out;
  }

  const Config c_;
  const bool exact_;
};

}  // namespace halfspace::model

#endif  // HALFSPACE_STUDY_BOUNDS_COMPENSATION_EXACT_HPP_
