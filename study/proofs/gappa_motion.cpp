// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "study/proofs/gappa_text.hpp"
#include "study/proofs/motion_bounds.hpp"
#include "study/proofs/texture_bounds.hpp"

namespace halfspace::model {
namespace {

// What else a vector is made of are multiples of 2^-f.
std::string vector(const Config& config) {
  ScriptParts parts =
      place_parts(config, "Where a point is in a key frame, and the vector to it.", vector_extent(config));
  const PlaceBounds bounds = place_bounds(config, vector_extent(config));
  const int f = config.vector_fraction;
  parts.definitions.push_back(fmt::format("vector = fixed<-{},nu>(place)", f));
  parts.goals.push_back("vector - span*X " + symmetric(bounds.place + Dyadic{1, -f - 1}));
  return script(config, parts);
}

// The weights of an axis: exact x, y, z, of the table a, b, c; the largest has what their sum lacks of 1.
std::string weight(const Config& config) {
  const int w = config.weight_bits;
  const std::string rounding = fmt::format("fixed<-{},nu>", w);
  if (config.filter != KeyFilter::kBicubic) {
    return script(config, {"Weights of an axis: one is rounded, and the other is what it lacks of 1.",
                           {"a = " + rounding + "(x)"},
                           {"x in [0, 1]"},
                           {"a - x " + symmetric({1, -w - 1}), "(1 - a) - (1 - x) " + symmetric({1, -w - 1})},
                           {}});
  }
  return script(config,
                {"Weights of an axis: three are rounded, and the largest is what they lack of 1.",
                 {"a = " + rounding + "(x)", "b = " + rounding + "(y)", "c = " + rounding + "(z)"},
                 {"x in [-1, 1]", "y in [-1, 1]", "z in [-1, 1]"},
                 {"a - x " + symmetric({1, -w - 1}), "(1 - a - b - c) - (1 - x - y - z) " + symmetric({3, -w - 1})},
                 {"(1 - a - b - c) - (1 - x - y - z) -> -((a - x) + (b - y) + (c - z))"}});
}

// Two by two: x, y exact weights of the second pixel and the second row, a, v those of the table; m: the mean of what
// the rows are off, and so within it; d: how far exact rows lie apart.
std::string key_of_four(const Config& config) {
  const int w = config.weight_bits, full = (1 << config.colour_bits) - 1;
  const Dyadic row = {full, -w - 1};
  return script(config,
                {"A key, two by two: rows are off by a weight, and their own weights are.",
                 {"row = left + (right - left)*a", "exact_row = left + (right - left)*x", "error = m + d*(v - y)"},
                 {fmt::format("right - left in [-{0}, {0}]", full), "a - x " + symmetric({1, -w - 1}),
                  "v - y " + symmetric({1, -w - 1}), fmt::format("d in [-{0}, {0}]", full), "m " + symmetric(row)},
                 {"row - exact_row " + symmetric(row), "error " + symmetric({full, -w})},
                 {"row - exact_row -> (right - left)*(a - x)"}});
}

// Four by four. p, p - 1: what is positive and what is negative of the weights of the rows; e0, e1: errors of rows, in
// their means; n: what is positive of the errors of the rows' weights, d: how far exact rows lie apart. An exact row is
// off by its three rounded weights, each times a difference of colours.
std::string key_of_sixteen(const Config& config) {
  const int w = config.weight_bits, full = (1 << config.colour_bits) - 1;
  const Dyadic weights = {3, -w - 1}, row = {3 * full, -w - 1}, apart = {5 * full, -2};
  return script(
      config,
      {"A key, four by four.",
       {"row = a*c0 + b*c2 + c*c3", "exact_row = x*c0 + y*c2 + z*c3", "error = p*e0 - (p - 1)*e1 + n*d"},
       {fmt::format("c0 in [-{0}, {0}]", full), fmt::format("c2 in [-{0}, {0}]", full),
        fmt::format("c3 in [-{0}, {0}]", full), "a - x " + symmetric({1, -w - 1}), "b - y " + symmetric({1, -w - 1}),
        "c - z " + symmetric({1, -w - 1}), "p in [1, 2473b-11]", "e0 " + symmetric(row), "e1 " + symmetric(row),
        "n in [0, " + number(weights) + "]", "d " + symmetric(apart)},
       {"row - exact_row " + symmetric(row), "error " + symmetric(dyadic_above(key_colour_bound(config)))},
       {"row - exact_row -> (a - x)*c0 + (b - y)*c2 + (c - z)*c3"}});
}

// blend: of one key or, weighted exactly, of two: off by a mean of what they are.
std::string compensated(const Config& config) {
  const Dyadic key = dyadic_above(key_colour_bound(config));
  return script(config, {"The colour of a pixel in between, blended exactly and rounded.",
                         {"colour = fixed<0,nu>(blend)"},
                         {"blend - exact " + symmetric(key)},
                         {"colour - exact " + symmetric(key + Dyadic{1, -1})},
                         {}});
}

}  // namespace

void add_motion_scripts(const Config& config, std::vector<GappaScript>& scripts) {
  scripts.push_back({"motion_field_vector", vector(config)});
  if (tap_bound(config) != 0) {
    scripts.push_back({"motion_compensate_weight", weight(config)});
    const bool bicubic = config.filter == KeyFilter::kBicubic;
    scripts.push_back({"motion_compensate_key", bicubic ? key_of_sixteen(config) : key_of_four(config)});
  }
  scripts.push_back({"motion_compensate_colour", compensated(config)});
}

}  // namespace halfspace::model
