// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "study/bounds/lighting_measure.hpp"
#include "study/proofs/lighting_bounds.hpp"

namespace halfspace::model {
namespace {

using Triple = std::array<int, 3>;

// One random light on a material of which red is the cosine, in LSB, green its largest power, and blue both at full
// scale.
class LightSearch {
 public:
  LightSearch(const Config& config, std::mt19937_64& random)
      : config_(config), table_(format_table(config)), random_(random), engine_(make_lighting_engine(config)) {
    const int one = 1 << kCoefficientFraction, full = ((1 << config.colour_bits) - 1) * one;
    frame_.lights.resize(std::size_t(config.lights));
    frame_.materials.resize(1);
    frame_.materials[0].gloss = exact_log2(config.gloss);
    frame_.materials[0].reflections.resize(std::size_t(config.lights));
    frame_.materials[0].reflections[0] = {{0, 0, 0}, {one, 0, full}, {0, one, full}};
    frame_.lights[0] = {unit(), unit()};
  }

  // Near the directions at first, then near what is worst of `channel` so far.
  void run(int channel, BoundsReport& report) {
    Triple best{};
    double largest = -1;
    for (int round = 0; round < 60; ++round) {
      propose(round, best);
      const auto sums = engine_->sums(frame_);
      const auto colours = engine_->colours(frame_);
      for (std::size_t t = 0; t < sums.size(); ++t) {
        const Triple& normal = frame_.triangles[t].normals[0];
        measure_colour(normal, colours[t][0], report.rows[kLightColour]);
        const double error = measure(normal, sums[t][0], channel, report);
        if (std::fabs(error) > largest) largest = std::fabs(error), best = normal;
      }
    }
  }

 private:
  Triple unit() {
    std::normal_distribution<double> gauss;
    const glm::dvec3 v = glm::normalize(glm::dvec3(gauss(random_), gauss(random_), gauss(random_)) + glm::dvec3(1e-9));
    const int way = 1 << (table_.direction.width - 1);
    Triple out;
    for (int c = 0; c < 3; ++c) out[c] = std::min(int(std::lround(v[c] * way)), way - 1);
    return out;
  }

  void propose(int round, const Triple& best) {
    const int limit = 1 << (table_.normal.width - 1), places = table_.direction.width - table_.normal.width;
    const int reach = round == 0 ? limit / 8 : round < 30 ? std::max(2, limit / 64) : 3;
    frame_.triangles.assign(48, {});
    for (std::size_t t = 0; t < frame_.triangles.size(); ++t) {
      Triple& normal = frame_.triangles[t].normals[0];
      const RawLight& light = frame_.lights[0];
      for (int c = 0; c < 3; ++c) {
        const int from = round == 0 ? (t % 2 ? light.to_light : light.half)[c] >> places : best[c];
        normal[c] = std::clamp(from + int(random_() % std::uint64_t(2 * reach)) - reach, -limit, limit - 1);
      }
      if (normal == Triple{0, 0, 0}) normal[0] = 1;
    }
  }

  // All rows see it; returns the error of `channel`.
  double measure(const Triple& normal, const std::array<std::uint64_t, 3>& sum, int channel, BoundsReport& report) {
    constexpr Quantity kRows[] = {kLightCosine, kLightPower, kLightSum};
    double chosen = 0;
    for (int c = 0; c < 3; ++c) {
      BoundRow& row = report.rows[kRows[c]];
      if (!row.present()) continue;
      const long double got = std::ldexp((long double)sum[c], table_.light_sum.integer - table_.light_sum.width);
      const long double error = got - exact_light(frame_, 0, real(normal), c, config_).value;
      const double in_unit = std::ldexp(double(error), c == 2 ? 0 : cosine_fraction(config_));
      if (row.see(in_unit, row.proved)) row.where = place(normal, row);
      if (c == channel) chosen = in_unit;
    }
    return chosen;
  }

  // As it leaves the unit.
  void measure_colour(const Triple& normal, const Triple& colour, BoundRow& row) const {
    const long double full = (1 << config_.colour_bits) - 1;
    for (int c = 0; c < 3; ++c) {
      const long double exact = std::clamp(exact_light(frame_, 0, real(normal), c, config_).value, 0.0L, full);
      if (row.see(double(colour[std::size_t(c)] - exact), row.proved)) row.where = place(normal, row);
    }
  }
  static RealNormal real(const Triple& n) { return {(long double)n[0], (long double)n[1], (long double)n[2]}; }
  static Witness place(const Triple& n, const BoundRow& row) {
    return {fmt::format("normal ({}, {}, {})", n[0], n[1], n[2]), row.compared};
  }

  Config config_;
  FormatTable table_;
  std::mt19937_64& random_;
  std::unique_ptr<LightingEngine> engine_;
  LightingFrame frame_;
};

}  // namespace

void measure_lighting(const Config& config, std::uint64_t seed, int lights, BoundsReport& report) {
  std::mt19937_64 random(seed);
  for (int n = 0; n < lights; ++n) LightSearch(config, random).run(n % 3, report);
}

}  // namespace halfspace::model
