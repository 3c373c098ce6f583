// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "study/proofs/gappa_text.hpp"
#include "study/proofs/lighting_bounds.hpp"
#include "study/proofs/phong_bounds.hpp"

namespace halfspace::model {
namespace {

// h: 1/|n| of the normal scaled to 1 <= |n| < 2; y: what reciprocal_sqrt gives for it; d: n·L, so that the cosine is
// d·h.
std::string light_cosine(const Config& config) {
  const int u = cosine_fraction(config);
  return header(config, "A cosine: a dot product is rounded, scaled by the reciprocal of the length, and rounded.") +
         fmt::format(
             "P = fixed<-{u},nu>(d);\nC = fixed<-{u},nu>(P*y);\nrho = (y - h) / h;\n\n"
             "{{ h in [1b-1, 1] /\\ y in [0, 1] /\\ d*h in [0, 1] /\\ rho {root}\n  -> C - d*h {bound} }}\n\n"
             "C - d*h -> (C - P*y) + y*(P - d) + d*h*rho {{h <> 0}};\n",
             fmt::arg("u", u), fmt::arg("root", symmetric(kRootBound)),
             fmt::arg("bound", symmetric(cosine_bound(config))));
}

// Xj: an exact cosine squared j times; Cj: the one at hand. What is proved of a step is the premise of the next.
std::string light_power(const Config& config) {
  std::string steps, premises, goals, hints;
  for (int j = 0; j < exact_log2(config.gloss); ++j) {
    const char* const next = j == 0 ? "" : "\n  /\\ ";
    steps += fmt::format("S{0} = fixed<-{1},nu>(C{0}*C{0});\n", j, cosine_fraction(config));
    premises += fmt::format("{0}X{1} in [0, 1] /\\ C{1} in [0, 1] /\\ C{1} - X{1} {2}", next, j,
                            symmetric(power_bound(config, j)));
    goals += fmt::format("{0}S{1} in [0, 1] /\\ S{1} - X{1}*X{1} {2}", next, j, symmetric(power_bound(config, j + 1)));
    hints += fmt::format("S{0} - X{0}*X{0} -> (S{0} - C{0}*C{0}) + (C{0} - X{0})*(C{0} + X{0});\n", j);
  }
  return header(config, "Powers of a cosine, by squaring, each rounded.") +
         fmt::format("{}\n{{ {}\n  -> {} }}\n\n{}", steps, premises, goals, hints);
}

// kd, ks: coefficients of a light; X, Y: exact cosine and power; C, S: those at hand. The base is in both sums alike.
std::string light_sum(const Config& config) {
  const int full = (1 << config.colour_bits) - 1;
  const bool gloss = has_gloss(config);
  const std::string power = gloss ? fmt::format(" /\\ ks in [0, {}] /\\ S - Y {}", full,
                                                symmetric(power_bound(config, exact_log2(config.gloss))))
                                  : "";
  const char* const highlight = gloss ? " + ks*S" : "";
  const char* const exact = gloss ? " + ks*Y" : "";
  return header(config, "The sum of a light that is white at full scale: products and sum are exact.") +
         fmt::format(
             "got = base + kd*C{highlight};\nexact = base + kd*X{exact};\n\n"
             "{{ base in [0, {full}] /\\ kd in [0, {full}] /\\ C - X {cosine}{power}\n  -> got - exact {bound} }}\n\n"
             "got - exact -> kd*(C - X){last};\n",
             fmt::arg("highlight", highlight), fmt::arg("exact", exact), fmt::arg("full", full),
             fmt::arg("cosine", symmetric(cosine_bound(config))), fmt::arg("power", power),
             fmt::arg("bound", symmetric(light_bound(config))), fmt::arg("last", gloss ? " + ks*(S - Y)" : ""));
}

// What leaves the unit: half an LSB more. Clamped to full scale it comes no farther from what is clamped as well.
std::string light_rounded(const Config& config) {
  return script(config, {"The colour of a light, rounded.",
                         {"colour = fixed<0,nu>(sum)"},
                         {"sum - exact " + symmetric(light_bound(config)), "exact in [0, 4096]"},
                         {"colour - exact " + symmetric(light_bound(config) + Dyadic{1, -1})},
                         {}});
}

// err: what a plane of normals is off, in length; x, y: cosine and power of the exact normal, x1, y1: of the one at
// hand, C, S: as the kernel has them.
std::string phong_colour(const Config& config) {
  const WhitePhong white = white_phong(config);
  const int full = (1 << config.colour_bits) - 1, squarings = exact_log2(config.gloss);
  ScriptParts parts{"A lit pixel: its normal is off, which turns it by a chord, and so its cosines and powers are.",
                    {"chord = err / (len - err*1b-1)", "colour = fixed<0,nu>(kd*C)"},
                    {"len in [1b-1, 2]", "err in [0, " + number(white.error) + "]", fmt::format("kd in [0, {}]", full),
                     "C - x1 " + symmetric(cosine_bound(config)), "x1 - x " + symmetric(white.cosine)},
                    {"chord in [0, " + number(white.chord) + "]", "colour - kd*x " + symmetric(white.rounded)},
                    {"colour - kd*x -> (colour - kd*C) + kd*((C - x1) + (x1 - x))"}};
  if (has_gloss(config)) {
    parts.definitions[1] = "colour = fixed<0,nu>(kd*C + ks*S)";
    parts.premises.push_back(fmt::format("ks in [0, {}]", full));
    parts.premises.push_back("S - y1 " + symmetric(power_bound(config, squarings)));
    parts.premises.push_back("y1 - y " + symmetric(white.power));
    parts.goals[1] = "colour - (kd*x + ks*y) " + symmetric(white.rounded);
    parts.hints[0] =
        "colour - (kd*x + ks*y)\n  -> (colour - (kd*C + ks*S)) + kd*((C - x1) + (x1 - x)) + ks*((S - y1) + (y1 - y))";
  }
  return script(config, parts);
}

}  // namespace

void add_lighting_scripts(const Config& config, std::vector<GappaScript>& scripts) {
  scripts.push_back({"light_cosine", light_cosine(config)});
  if (exact_log2(config.gloss) > 0) scripts.push_back({"light_power", light_power(config)});
  scripts.push_back({"light_sum", light_sum(config)});
  scripts.push_back({"light_rounded", light_rounded(config)});
  if (is_phong(config)) scripts.push_back({"shade_phong_colour", phong_colour(config)});
}

}  // namespace halfspace::model
