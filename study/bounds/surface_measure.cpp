// SPDX-License-Identifier: Apache-2.0
// From snapped vertices to the colour that is shown: lit or not, with texture or without.
#include <algorithm>
#include <cmath>
#include <random>

#include "ref/geometry/plane.hpp"
#include "study/bounds/bounds_measure.hpp"
#include "study/proofs/phong_bounds.hpp"
#include "study/proofs/shown_bounds.hpp"
#include "study/proofs/texture_bounds.hpp"

namespace halfspace::model {
namespace {

constexpr std::size_t kPixels = 24;  // of a triangle that are looked at
constexpr double kTiny = 1e-9;       // what doubles are off, LSB

using Triple = std::array<int, 3>;

// A colour of a pixel, and how far off it may be. `sees`: within the premises of the proved number.
struct Channel {
  double value, bound;
  bool sees;
};

class SurfaceMeter : public FeatureMeter {
 public:
  SurfaceMeter(const Config& config, KernelProbe& probe, BoundsReport& report)
      : config_(config), probe_(probe), report_(report), full_((1 << config.colour_bits) - 1) {
    std::mt19937_64 random(1);
    if (has_lighting(config)) load_lights(random);
    if (has_texture(config)) load_texture(random);
  }

  void measure(const MeasuredTriangle& m) override {
    std::mt19937_64 random(seed_of(m.triangle));
    if (has_lighting(config_)) probe_.give(normals_ = some_normals(random));
    if (has_texture(config_)) probe_.give(coordinates_ = some_coordinates(random));
    const std::size_t step = std::max<std::size_t>(1, m.pixels.size() / kPixels);
    for (std::size_t n = 0; n < m.pixels.size(); n += step) {
      const int x = m.pixels[n].x, y = m.pixels[n].y;
      const std::array<std::uint32_t, 3> shown = probe_.shown(x, y);
      if (is_phong(config_)) {
        const std::array<std::uint32_t, 3> lit = has_texture(config_) ? probe_.lit(x, y) : shown;
        for (int c = 0; c < 3; ++c) see(kPhongColour, lit[std::size_t(c)], surface(m, c, x, y), m.at(x, y));
      }
      for (int c = 0; c < 3; ++c) {
        const Channel want = has_texture(config_) ? textured(m, c, x, y) : surface(m, c, x, y);
        see(kShown, shown[std::size_t(c)], want, m.at(x, y));
      }
    }
    if (is_phong(config_)) measure_worst_light(m);
  }

 private:
  void see(Quantity quantity, std::uint32_t got, const Channel& want, const Witness& where) {
    if (want.bound < 0) return;
    BoundRow& row = report_.rows[quantity];
    const double error = double(got) - want.value;
    if (row.exact() ? row.count(1, error != 0)
        : want.sees ? row.see(error, want.bound + kTiny)
                    : row.hold(error, want.bound + kTiny)) {
      row.where = where;
    }
  }

  // Of the pixel whose normal is turned most, under the light that tells most of it: at right angles to the normal but
  // for what it would graze, its highlight where the power is steepest, both to the side that the normal is turned to.
  void measure_worst_light(const MeasuredTriangle& m) {
    const std::size_t step = std::max<std::size_t>(1, m.pixels.size() / kPixels);
    glm::dvec3 normal(0), turn(0);
    int x = -1, y = -1;
    for (std::size_t n = 0; n < m.pixels.size(); n += step) {
      const RealNormal real = exact_normal(m, m.pixels[n].x, m.pixels[n].y);
      const glm::dvec3 exact(real[0], real[1], real[2]);
      const double length = glm::length(exact);
      if (length < std::ldexp(0.5, config_.normal_bits)) continue;
      const Triple got = probe_.normal(m.pixels[n].x, m.pixels[n].y);
      const glm::dvec3 off = (glm::dvec3(got[0], got[1], got[2]) - exact) / length, way = exact / length;
      const glm::dvec3 across = off - glm::dot(off, way) * way;
      if (glm::length(across) > glm::length(turn)) turn = across, normal = way, x = m.pixels[n].x, y = m.pixels[n].y;
    }
    if (x < 0 || turn == glm::dvec3(0)) return;
    const glm::dvec3 side = glm::normalize(turn);
    const double chord = value(white_phong(config_).chord), power = std::ldexp(1.0, exact_log2(config_.gloss));
    const double steepest = std::max(std::sqrt((power - 1) / power), 0.1), along = std::min(1.3 * chord + 1e-4, 0.5);
    const RawLight light = frame_.lights[0];
    frame_.lights[0] = {direction(side + along * normal),
                        direction(std::sqrt(1 - steepest * steepest) * side + steepest * normal)};
    normals_.material = std::min(2, int(frame_.materials.size()) - 1);
    probe_.load(frame_);
    probe_.give(normals_);
    const std::array<std::uint32_t, 3> lit = probe_.lit(x, y), shown = probe_.shown(x, y);
    for (int c = 0; c < 3; ++c) {
      see(kPhongColour, lit[std::size_t(c)], surface(m, c, x, y), m.at(x, y));
      see(kShown, shown[std::size_t(c)], has_texture(config_) ? textured(m, c, x, y) : surface(m, c, x, y), m.at(x, y));
    }
    frame_.lights[0] = light;
    probe_.load(frame_);
  }

  // Words.
  Triple direction(const glm::dvec3& way) const {
    const glm::dvec3 v = glm::normalize(way);
    const int one = 1 << (cosine_fraction(config_) + 1);
    Triple out;
    for (int c = 0; c < 3; ++c) out[std::size_t(c)] = std::min(int(std::lround(v[c] * one)), one - 1);
    return out;
  }
  Triple unit(std::mt19937_64& random) const {
    std::normal_distribution<double> gauss;
    return direction(glm::dvec3(gauss(random), gauss(random), gauss(random)) + glm::dvec3(1e-9));
  }
  // Materials of one white light, of its highlight, of both; the last is of any.
  void load_lights(std::mt19937_64& random) {
    const int one = full_ << kCoefficientFraction, lights = config_.lights;
    for (int i = 0; i < lights; ++i) frame_.lights.push_back({unit(random), unit(random)});
    const int materials = std::min(config_.materials, 4);
    for (int m = 0; m < materials; ++m) {
      RawMaterial& material = frame_.materials.emplace_back();
      material.gloss = exact_log2(config_.gloss);
      material.reflections.resize(std::size_t(lights));
      for (RawReflection& r : material.reflections) {
        const bool white = m < 3 && &r == &material.reflections[0];
        for (std::size_t c = 0; c < 3; ++c) {
          if (white && m != 1) r.diffuse[c] = one;
          if (white && m != 0) r.specular[c] = one;
          if (m < 3) continue;
          r.base[c] = int(random() % std::uint64_t(one / 4 + 1));
          r.diffuse[c] = int(random() % std::uint64_t(2 * one)), r.specular[c] = int(random() % std::uint64_t(2 * one));
        }
        if (!has_gloss(config_)) r.specular = {};
      }
    }
    probe_.load(frame_);
  }
  RawNormals some_normals(std::mt19937_64& random) const {
    const int limit = 1 << config_.normal_bits;
    RawNormals out;
    out.material = int(random() % frame_.materials.size());
    const std::uint64_t kind = random() % 8;
    auto any = [&] { return int(random() % std::uint64_t(2 * limit)) - limit; };
    for (std::size_t v = 0; v < 3; ++v) {
      const Triple way = unit(random);
      for (std::size_t c = 0; c < 3; ++c) {
        // From 4 on hardly apart, from 6 on hardly longer than a half.
        const int places = cosine_fraction(config_) + 1 - config_.normal_bits;
        const int long_one = std::clamp(way[c] >> places, -limit, limit - 1), short_one = long_one / 2 + long_one / 64;
        const int near = std::clamp(out.normals[0][c] + int(random() % 9) - 4, -limit, limit - 1);
        out.normals[v][c] = kind == 0            ? any()
                            : kind == 1 && v > 0 ? std::min(-out.normals[0][c], limit - 1)
                            : kind == 2          ? (random() % 2 ? limit - 1 : -limit)
                            : kind >= 4 && v > 0 ? near
                            : kind >= 6          ? short_one
                                                 : long_one;
      }
    }
    return out;
  }
  void load_texture(std::mt19937_64& random) {
    const int side = shown_side(config_);
    ref::Texture texture{"noise", 1 << side, 1 << side, {}};
    for (int n = 0; n < 1 << (2 * side); ++n) {
      auto& rgb = texture.texels.emplace_back();
      // As different as can be; where nothing is filtered, of any product.
      for (auto& channel : rgb) channel = is_bilinear(config_) ? random() % 2 * 255 : random() % 256;
    }
    texels_ = texture.texels;
    const TextureFrame loaded = loaded_textures({texture}, config_);
    probe_.load(loaded);
  }
  RawCoordinates some_coordinates(std::mt19937_64& random) const {
    const std::int64_t most = (std::int64_t(1) << config_.coordinate_bits) - 1, least = std::int64_t(least_q(config_));
    RawCoordinates out;
    out.texture = 1;
    const bool near = random() % 2;
    for (std::size_t v = 0; v < 3; ++v) {
      const std::int64_t any = least + std::int64_t(random() % std::uint64_t(most - least + 1));
      const std::int64_t q = !has_perspective(config_) ? most : near ? least : any;
      for (auto* to : {&out.s, &out.t})
        (*to)[v] = int(near ? q - std::int64_t(random() % std::uint64_t(q / 8 + 1))
                            : std::int64_t(random() % std::uint64_t(q + 1)));
      if (has_perspective(config_)) out.q[v] = int(q);
    }
    return out;
  }

  // Exact colours.
  std::array<double, 3> weights(const MeasuredTriangle& m, int x, int y) const {
    return ref::vertex_weights(ref::OrderedTriangle(m.triangle), ref::pixel_centre(x, config_.subpixel_bits),
                               ref::pixel_centre(y, config_.subpixel_bits));
  }
  static RealNormal real(const Triple& n) { return {(long double)n[0], (long double)n[1], (long double)n[2]}; }
  Channel lit_normal(const RealNormal& n, int c) const {
    const ExactLight exact = exact_light(frame_, normals_.material, n, c, config_);
    return {double(std::clamp(exact.value, 0.0L, (long double)full_)), 0.5 + double(exact.bound),
            normals_.material < 3};
  }
  Channel surface(const MeasuredTriangle& m, int c, int x, int y) const {
    const double distance = m.exact.distance(x, y);
    if (is_phong(config_)) return phong(m, c, x, y, distance);
    if (!is_gouraud(config_)) {
      if (!has_lighting(config_)) return {double(m.triangle.rgb[0][std::size_t(c)]), 0, true};
      return lit_normal(real(normals_.normals[0]), c);
    }
    const double plane = value(plane_bound(colour_numbers(config_), reach(m, x, y)).rounded);
    if (!has_lighting(config_)) return {double(m.exact.quotient(m.exact.colour(c), x, y)), plane, true};
    Channel out = {0, plane, true};
    const std::array<double, 3> weight = weights(m, x, y);
    for (std::size_t v = 0; v < 3; ++v) {
      const Channel vertex = lit_normal(real(normals_.normals[v]), c);
      out.value += weight[v] * vertex.value, out.bound += weight[v] * vertex.bound;
      out.sees = out.sees && vertex.sees;
    }
    return out;
  }
  Dyadic reach(const MeasuredTriangle& m, int x, int y) const {
    return {std::llabs(m.exact.dx(x)) + std::llabs(m.exact.dy(y)), -config_.subpixel_bits};
  }
  RealNormal exact_normal(const MeasuredTriangle& m, int x, int y) const {
    RealNormal n{};
    for (std::size_t i = 0; i < 3; ++i) {
      n[i] = m.exact.quotient(
          m.exact.in_order({normals_.normals[0][i], normals_.normals[1][i], normals_.normals[2][i]}), x, y);
    }
    return n;
  }
  Channel phong(const MeasuredTriangle& m, int c, int x, int y, double distance) const {
    const RealNormal n = exact_normal(m, x, y);
    const PhongBound bound = phong_bound(frame_, normals_.material, n, c, distance, config_);
    const ExactLight exact = exact_light(frame_, normals_.material, n, c, config_);
    const long double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    const bool is_long = length >= std::ldexp(0.5L, config_.normal_bits);
    return {double(std::clamp(exact.value, 0.0L, (long double)full_)), 0.5 + bound.error + bound.jump,
            normals_.material < 3 && is_long && bound.jump == 0};
  }

  double texel(int i, int j, int c) const {
    const int side = 1 << shown_side(config_);
    const auto& rgb = texels_[std::size_t((j & (side - 1)) * side + (i & (side - 1)))];
    return ref::snapped_colour(rgb[std::size_t(c)], config_.colour_bits);
  }
  // With what its texels differ by around the place; a bound below 0 where it is not told: of the nearest, next to the
  // border of a texel.
  Channel textured(const MeasuredTriangle& m, int c, int x, int y) const {
    const Channel lit = surface(m, c, x, y);
    const double distance = m.exact.distance(x, y), side = std::ldexp(1.0, shown_side(config_));
    const double q = has_perspective(config_) ? double(m.exact.quotient(m.exact.in_order(coordinates_.q), x, y))
                                              : std::ldexp(1.0, config_.coordinate_bits);
    double at[2], off[2];
    for (int axis = 0; axis < 2; ++axis) {
      const double part = double(m.exact.quotient(m.exact.in_order(axis ? coordinates_.t : coordinates_.s), x, y)) / q;
      at[axis] = part * side - (is_bilinear(config_) ? 0.5 : 0);
      off[axis] = texture_place_bound(config_, side, part, q, distance) + texture_cut_bound(config_);
    }
    const int first_i = int(std::floor(at[0] - off[0])), last_i = int(std::floor(at[0] + off[0]));
    const int first_j = int(std::floor(at[1] - off[1])), last_j = int(std::floor(at[1] + off[1]));
    double exact = 0, filtered = 0;
    if (!is_bilinear(config_)) {
      if (first_i != last_i || first_j != last_j) return {0, -1, false};
      exact = texel(first_i, first_j, c);
    } else {
      double du = 0, dv = 0;
      for (int j = first_j; j <= last_j + 1; ++j) {
        for (int i = first_i; i <= last_i + 1; ++i) {
          if (i <= last_i) du = std::max(du, std::fabs(texel(i + 1, j, c) - texel(i, j, c)));
          if (j <= last_j) dv = std::max(dv, std::fabs(texel(i, j + 1, c) - texel(i, j, c)));
        }
      }
      const int i = int(std::floor(at[0])), j = int(std::floor(at[1]));
      const double u = at[0] - i, v = at[1] - j;
      exact = (1 - v) * ((1 - u) * texel(i, j, c) + u * texel(i + 1, j, c)) +
              v * ((1 - u) * texel(i, j + 1, c) + u * texel(i + 1, j + 1, c));
      filtered = texel_bound(config_, off[0], off[1], du, dv);
    }
    return {lit.value * exact / full_, textured_bound(config_, lit.bound, filtered), lit.sees};
  }

  const Config config_;
  KernelProbe& probe_;
  BoundsReport& report_;
  const int full_;
  LightingFrame frame_;
  std::vector<std::array<std::uint8_t, 3>> texels_;
  RawNormals normals_;
  RawCoordinates coordinates_;
};

}  // namespace

std::unique_ptr<FeatureMeter> make_surface_meter(const Config& config, KernelProbe& probe, BoundsReport& report) {
  return std::make_unique<SurfaceMeter>(config, probe, report);
}

}  // namespace halfspace::model
