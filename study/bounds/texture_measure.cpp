// SPDX-License-Identifier: Apache-2.0
// Where pixels lie in a texture, and what is made of texels.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "study/bounds/bounds_measure.hpp"
#include "study/bounds/coordinate_words.hpp"
#include "study/proofs/texture_bounds.hpp"
#include "vectors/frames/awkward.hpp"

namespace halfspace::model {
namespace {

constexpr std::size_t kPlaces = 200;  // pixels of a triangle that are looked at
constexpr std::size_t kAwkward = 64;

class TextureMeter : public FeatureMeter {
 public:
  TextureMeter(const Config& config, KernelProbe& probe, BoundsReport& report)
      : config_(config), probe_(probe), row_(report.rows[kTexelPlace]) {
    awkward_ = awkward_coordinates(kAwkward, config, 1);
    const int texels = exact_log2(config.texels), longer = square_side(config);
    square_ = {0, longer, texels - longer};
  }

  void measure(const MeasuredTriangle& m) override {
    std::mt19937_64 random(seed_of(m.triangle));
    const bool premise = random() % 4 != 0;
    RawCoordinates words = awkward_.triangles[random() % kAwkward];
    if (premise) words = square_words(random);
    if (words.texture == 0) return;
    const RawTexture& texture = premise ? square_ : awkward_.textures[std::size_t(words.texture) - 1];
    probe_.give(words);
    const Values s = m.exact.in_order(words.s), t = m.exact.in_order(words.t), q = m.exact.in_order(words.q);
    const std::size_t step = std::max<std::size_t>(1, m.pixels.size() / kPlaces);
    for (std::size_t n = 0; n < m.pixels.size(); n += step) {
      const int x = m.pixels[n].x, y = m.pixels[n].y;
      const ProbedPlace place = probe_.place(texture, x, y);
      const double depth = has_perspective(config_) ? double(m.exact.quotient(q, x, y)) : full() + 1;
      const double distance = m.exact.distance(x, y);
      for (const bool along_u : {true, false}) {
        const int log2_side = along_u ? texture.log2_width : texture.log2_height;
        const double part = double(m.exact.quotient(along_u ? s : t, x, y)) / depth;
        const double span = std::ldexp(1.0, log2_side + words.repeats), side = std::ldexp(1.0, log2_side);
        const double bound = texture_place_bound(config_, span, part, depth, distance) + texture_cut_bound(config_);
        if (!(bound < side / 2)) continue;  // any place is within it
        const double error = place_error(along_u ? place.u : place.v, part * span, side);
        // The proved number is that of the longer side.
        const bool sees = premise && log2_side == square_.log2_width;
        if (sees ? row_.see(error, bound) : row_.hold(error, bound)) row_.where = m.at(x, y);
      }
    }
  }

 private:
  double full() const { return std::ldexp(1.0, config_.coordinate_bits) - 1; }

  // As near to 0 as it can be: whole repetitions do not count. What the nearest cuts off is half of it to either side
  // of the middle.
  double place_error(std::uint64_t place, double exact, double side) const {
    const double want = exact - (is_bilinear(config_) ? 0.5 : 0);
    const double cut = is_bilinear(config_) ? 0 : std::ldexp(0.5, -kWeightBits);
    return std::max(std::fabs(std::remainder(std::ldexp(double(place), -kWeightBits) + cut - want, side)) - cut, 0.0);
  }

  // Of the premises of the proved number: one repetition, and a q of the upper half.
  RawCoordinates square_words(std::mt19937_64& random) const {
    const std::int64_t most = std::int64_t(full()), least = std::int64_t(least_q(config_));
    const std::uint64_t kind = random() % 4;
    RawCoordinates out;
    out.texture = 1;
    for (int v = 0; v < 3; ++v) {
      draw_coordinates(out, std::size_t(v), kind, config_, least, most, random);
    }
    return out;
  }

  const Config config_;
  KernelProbe& probe_;
  BoundRow& row_;
  TextureFrame awkward_;
  RawTexture square_;
};

}  // namespace

std::unique_ptr<FeatureMeter> make_texture_meter(const Config& config, KernelProbe& probe, BoundsReport& report) {
  return std::make_unique<TextureMeter>(config, probe, report);
}

void measure_inverse(const Config&, KernelProbe& probe, BoundRow& row) {
  const ProbedInverse worst = probe.worst_inverse();
  row.compared += worst.compared - 1;
  if (row.see(worst.error / kInverseError, 1)) row.where = {fmt::format("q = {}", worst.q), 1};
}

void measure_texels(const Config& config, KernelProbe& probe, std::uint64_t seed, BoundsReport& report) {
  std::mt19937_64 random(seed);
  const std::uint32_t full = (1u << config.colour_bits) - 1;
  const double one = 1 << kFilteredFraction, bound = 0.5 + filtered_bound(config) + product_bound(config);
  auto value = [&] { return std::uint32_t(random() % 2 ? random() % 2 * full : random() % (full + 1)); };
  auto weight = [&] { return is_bilinear(config) ? int(random() % ((1 << kWeightBits) + 1)) : 0; };
  // Without a filter all products there are.
  const std::uint64_t count = is_bilinear(config) ? 20000 : std::uint64_t(full + 1) * (full + 1);
  for (std::uint64_t n = 1; n <= count; ++n) {
    TexelSample in = {value(), {value(), value(), value(), value()}, weight(), weight()};
    if (!is_bilinear(config))
      in.lit = std::uint32_t((n - 1) / (full + 1)), in.texel[0] = std::uint32_t(n - 1) % (full + 1);
    const ProbedTexel out = probe.textured(in);
    const double column = std::ldexp(in.odd_column, -kWeightBits), row = std::ldexp(in.odd_row, -kWeightBits);
    const double even = in.texel[0] + (double(in.texel[1]) - in.texel[0]) * column;
    const double odd = in.texel[2] + (double(in.texel[3]) - in.texel[2]) * column;
    const double texel = even + (odd - even) * row;
    const Witness where = {fmt::format("texels {} {} {} {}, weights {}/256 {}/256, colour {}", in.texel[0], in.texel[1],
                                       in.texel[2], in.texel[3], in.odd_column, in.odd_row, in.lit),
                           n};
    BoundRow& filtered = report.rows[kTexelFiltered];
    if (filtered.present() && filtered.see(out.filtered / one - texel, filtered.proved)) filtered.where = where;
    BoundRow& colour = report.rows[kTexelColour];
    if (colour.see(out.colour - in.lit * texel / full, bound)) colour.where = where;
  }
}

}  // namespace halfspace::model
