// SPDX-License-Identifier: Apache-2.0
// Compiled without contraction of a·b + c (vectors/CMakeLists.txt): each operation rounds.
#include "study/stability/plane_models.hpp"

#include <algorithm>
#include <cmath>

namespace halfspace::model {
namespace {

// As in a conversion to UNORM: NaN is 0.
double saturate(double value, double full) { return std::isnan(value) ? 0 : std::clamp(value, 0.0, full); }

}  // namespace

FloatPlane::FloatPlane(const ExactTriangle& t, const Values& values, int bits, int subpixel_bits)
    : full_(std::ldexp(1, bits) - 1) {
  float x[3], y[3], v[3];
  for (int i = 0; i < 3; ++i) {
    x[i] = float(std::ldexp(double(t.x(i)), -subpixel_bits)) - 0.5f;
    y[i] = float(std::ldexp(double(t.y(i)), -subpixel_bits)) - 0.5f;
    v[i] = float(double(values[i]) / full_);
  }
  const float dx01 = x[0] - x[1], dy01 = y[0] - y[1], dx20 = x[2] - x[0], dy20 = y[2] - y[0];
  const float ooa = 1.0f / (dx01 * dy20 - dx20 * dy01);
  const float da01 = v[0] - v[1], da20 = v[2] - v[0];
  dx_ = da01 * (dy20 * ooa) - da20 * (dy01 * ooa);
  dy_ = da20 * (dx01 * ooa) - da01 * (dx20 * ooa);
  v0_ = v[0], x0_ = x[0], y0_ = y[0];
  origin_ = v0_ - (dx_ * x0_ + dy_ * y0_);
}

double FloatPlane::stored(float value) const { return saturate(double(value) * full_, full_); }

double FloatPlane::from_origin(int px, int py) const { return stored((origin_ + dx_ * float(px)) + dy_ * float(py)); }

double FloatPlane::from_vertex(int px, int py) const {
  return stored((v0_ + dx_ * (float(px) - x0_)) + dy_ * (float(py) - y0_));
}

SaturatedPlane::SaturatedPlane(const ExactTriangle& t, const Values& values, int bits, int subpixel_bits, int fraction)
    : triangle_(t), full_(std::ldexp(1, bits) - 1), v0_(values[0]), fraction_(fraction), subpixel_bits_(subpixel_bits) {
  const Wide limit = Wide(1) << (bits + 1 + fraction);
  auto rounded = [&](Wide numerator) {
    const Wide twice = (numerator << (subpixel_bits + fraction + 1)) + t.area(), divisor = 2 * t.area();
    const Wide quotient = twice / divisor - (twice % divisor < 0);
    return std::clamp<Wide>(quotient, -limit, limit);
  };
  const Numerators n = t.numerators(values);
  dx_ = rounded(n.x), dy_ = rounded(n.y);
}

double SaturatedPlane::value(int px, int py) const {
  const Wide sum = dx_ * triangle_.dx(px) + dy_ * triangle_.dy(py);
  return saturate(double(v0_) + std::ldexp(double(sum), -fraction_ - subpixel_bits_), full_);
}

}  // namespace halfspace::model
