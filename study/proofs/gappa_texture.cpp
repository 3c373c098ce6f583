// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "study/proofs/gappa_text.hpp"
#include "study/proofs/texture_bounds.hpp"

namespace halfspace::model {
namespace {

// cut: to the weights, half of the last of them added.
std::string texel_place(const Config& config) {
  ScriptParts parts = place_parts(config, "Where a pixel lies in a square texture; whole repetitions do not count.",
                                  square_side(config));
  if (is_bilinear(config)) {
    const PlaceBounds bounds = place_bounds(config, square_side(config));
    const Dyadic half = {1, -kWeightBits - 1};
    parts.definitions.push_back(fmt::format("weights = fixed<-{},dn>(place - 1b-1 + {})", kWeightBits, number(half)));
    parts.goals.push_back("weights - (span*X - 1b-1) " + symmetric(bounds.place + half));
    parts.hints.push_back(
        fmt::format("weights - (span*X - 1b-1)\n  -> (weights - (place - 1b-1 + {0})) + {0} + (place - span*X){1}",
                    number(half), has_perspective(config) ? " {q <> 0}" : ""));
  }
  return script(config, parts);
}

// Of four texels: means of two are exact, and the mean of these is rounded.
std::string filter(const Config& config) {
  const int full = (1 << config.colour_bits) - 1;
  return script(config,
                {"A filtered texel: rounded once, and never out of its bits.",
                 {fmt::format("texel = fixed<-{},nu>(mean)", kFilteredFraction)},
                 {fmt::format("mean in [0, {}]", full)},
                 {"texel - mean " + symmetric({1, -kFilteredFraction - 1}), fmt::format("texel in [0, {}b0]", full)},
                 {}});
}

// P: the product of a colour and a filtered texel F, a whole number of units of 2^-8 LSB squared; T: the exact mean.
std::string product_of_texel(const Config& config) {
  const int c = config.colour_bits, full = (1 << c) - 1;
  const Dyadic product = Dyadic{1, -c - 1} + Dyadic{1, -c - 8}, half{1, -1}, texel{1, -kFilteredFraction - 1};
  return script(
      config, {"The product with a texel, over full scale: by two terms of a series, half of what they lack added.",
               {"P = L*F*256", fmt::format("second = fixed<0,dn>(P*1b-{})", c),
                fmt::format("sum = (P + second + 128)*1b-{}", c + 8), "colour = fixed<0,nu>(sum)"},
               {fmt::format("L in [0, {}]", full), fmt::format("F in [0, {}]", full), "F - T " + symmetric(texel),
                "@FIX(P, 0)"},
               {fmt::format("sum - P*1b-8/{} {}", full, symmetric(product)),
                fmt::format("colour - L*T/{} {}", full, symmetric(product + half + texel))},
               {fmt::format("sum - P*1b-8/{0}\n  -> (second - P*1b-{1})*1b-{2} + 1b-{3} - P*1b-{4}/{0}", full, c, c + 8,
                            c + 1, 2 * c + 8),
                fmt::format("colour - L*T/{0} -> (colour - sum) + (sum - P*1b-8/{0}) + L/{0}*(F - T)", full)}});
}

}  // namespace

void add_texture_scripts(const Config& config, std::vector<GappaScript>& scripts) {
  scripts.push_back({"shade_texture_place", texel_place(config)});
  if (!is_bilinear(config)) return;  // every product of two whole colours is tried
  scripts.push_back({"shade_texture_filter", filter(config)});
  scripts.push_back({"shade_texture_product", product_of_texel(config)});
}

// s, q: as planes have them, rounded; S = X*Q, Q: exact; rho: of the reciprocal.
ScriptParts place_parts(const Config& config, const std::string& what, int log2_span) {
  const PlaceBounds bounds = place_bounds(config, log2_span);
  const std::string rounded = symmetric(bounds.rounded), span = std::to_string(std::int64_t(1) << log2_span);
  const int b = config.coordinate_bits;
  ScriptParts parts{what, {}, {"X in [0, 1]", "s - S " + rounded}, {}, {}};
  if (has_perspective(config)) {
    parts.definitions = {"span = " + span, "S = X*Q", "quotient = s / q", "place = span*(quotient*(1 + rho))"};
    parts.premises.push_back(fmt::format("Q in [1b{}, {}]", b - 1, (std::int64_t(1) << b) - 1));
    parts.premises.push_back("q - Q " + rounded);
    parts.premises.push_back("rho in [-1b-18, 1b-18]");
    parts.goals.push_back("quotient - X " + symmetric(bounds.quotient));
    parts.hints = {"quotient - X -> ((s - S) - X*(q - Q)) / q {q <> 0}",
                   "place - span*X -> span*((quotient - X) + quotient*rho) {q <> 0}"};
  } else {
    parts.definitions = {"span = " + span, fmt::format("S = X*1b{}", b), fmt::format("place = span*s*1b-{}", b)};
    parts.hints = {fmt::format("place - span*X -> span*1b-{}*(s - S)", b)};
  }
  parts.goals.push_back("place - span*X " + symmetric(bounds.place));
  return parts;
}

}  // namespace halfspace::model
