// SPDX-License-Identifier: Apache-2.0
#include "study/proofs/gappa.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "study/proofs/bounds_proved.hpp"
#include "study/proofs/lighting_bounds.hpp"

namespace halfspace::model {
namespace {

std::string number(const Dyadic& n) { return fmt::format("{}b{}", n.mantissa, n.exponent); }
std::string symmetric(const Dyadic& n) { return fmt::format("in [-{0}, {0}]", number(n)); }

// What a product of 64 bits may be; not a bound of it.
constexpr const char* kWord = "9223372036854775807";

std::string header(const Config& config, const std::string& what) {
  return fmt::format("# {}\n# Printed by `halfspace bounds` from the numbers of configuration `{}`.\n\n", what,
                     config.name);
}

std::string snap(const Config& config) {
  const int range = config.range_bits - 1, f = config.subpixel_bits;
  return header(config, "Snapping: a position in pixels is rounded to f fraction bits, half to even.") +
         fmt::format("x = fixed<-{},ne>(pixels);\n\n{{ pixels in [-1b{}, 1b{}]\n  -> x - pixels {} }}\n", f, range,
                     range, symmetric({1, -f - 1}));
}

// D = m·2^s, R = floor(2^(r+s)/D + ½) in units of 2^−r.
std::string reciprocal(const Config& config) {
  const int r = config.reciprocal_bits;
  return header(config, "The reciprocal of the area D = m*2^s: R has r fraction bits, half up.") +
         fmt::format(
             "R = fixed<-{},nu>(1 / m);\n\n{{ m in [1, 2]\n  -> m*R - 1 {} /\\ R in [1b-1, 1b0] }}\n\n"
             "m*R - 1 -> m*(R - 1/m) {{m <> 0}};\n",
             r, symmetric(reciprocal_bound(config)));
}

// N = H·2^24 + L, |N| < 2^(b+c). What rounded_product keeps in words of 64 bits, and that its sum is N·R + half,
// nothing rounded. half is at most 2^(n−1), n = r + s − f − g, s <= 2c − 1; a kernel
// that rounds after the shift has none.
std::string product(const Config& config, const char* kind, int value_bits, int fraction) {
  const int r = config.reciprocal_bits, c = config.range_bits + config.subpixel_bits;
  const int high_bits = std::max(0, value_bits + c - 24);
  const int largest_shift = 2 * c - 1 + r - config.subpixel_bits - fraction;
  return header(config, fmt::format("The product N*R of a {} gradient, by halves of N = H*2^24 + L: exact.", kind)) +
         fmt::format(
             "half = fixed<0,dn>(half_);\nlow = L*R + half;\ncarry = fixed<24,dn>(low);\nrest = low - carry;\n"
             "high = H*R + carry*1b-24;\n\n"
             "{{ L in [0, 16777215] /\\ H in [-1b{0}, 1b{0}] /\\ R in [1b{1}, 1b{2}] /\\ half in [0, 1b{3}]\n"
             "  /\\ @FIX(L, 0) /\\ @FIX(R, 0)\n"
             "  -> low in [0, {4}] /\\ high in [-{4}, {4}] /\\ rest in [0, 1b24]\n"
             "  /\\ (high*1b24 + rest) - ((H*1b24 + L)*R + half) in [0, 0] }}\n\n"
             "(high*1b24 + rest) - ((H*1b24 + L)*R + half) -> 0;\n",
             high_bits, r - 1, r, std::max(0, largest_shift - 1), kWord);
}

// p, q: N_A·2^f·2^−s and N_B·2^f·2^−s, so that the exact gradients are p/m and q/m LSB a pixel. t = v − v0, which at a
// covered centre is a mean of differences from v0. The one R of both gradients makes its error a factor of t: the
// second hint.
std::string plane(const Config& config, const char* kind, const PlaneNumbers& n, Vertices vertices) {
  const bool guard_band = vertices == Vertices::kGuardBand;
  const PlaneBound bound = plane_bound(n, largest_reach(config, vertices));
  const std::int64_t limit = std::int64_t(1) << (config.range_bits - 1), f = config.subpixel_bits;
  auto vertex = [&](const char* axis, int size) {
    return guard_band ? fmt::format("{}0 in [-{}, {}b-{}]", axis, limit, (limit << f) - 1, f)
                      : fmt::format("{}0 in [0, {}]", axis, size);
  };
  return header(config, fmt::format("The {} plane at a covered pixel centre (x, y), vertex 0 in the {}.", kind,
                                    guard_band ? "guard band" : "frame")) +
         fmt::format(
             "R = fixed<-{r},nu>(1 / m);\nA = fixed<-{g},nu>(p*R);\nB = fixed<-{g},nu>(q*R);\n"
             "dx = x - x0;\ndy = y - y0;\nt = (p*dx + q*dy) / m;\n"
             "register = fixed<-{g},dn>(v0 + A*dx + B*dy + 1b-1);\n\n"
             "{{ m in [1, 2] /\\ t in [-{full}, {full}] /\\ x in [1b-1, {x}b-1] /\\ y in [1b-1, {y}b-1]\n"
             "  /\\ {x0} /\\ {y0}\n"
             "  -> A*dx + B*dy - t {sum} /\\ (v0 + t) - (register - 1b-1) in [-{low}, {high}] }}\n\n"
             "m*R - 1 -> m*(R - 1/m) {{m <> 0}};\n"
             "A*dx + B*dy - t -> dx*(A - p*R) + dy*(B - q*R) + t*(m*R - 1) {{m <> 0}};\n"
             "(v0 + t) - (register - 1b-1)\n"
             "  -> -((A*dx + B*dy - t) + (register - (v0 + A*dx + B*dy + 1b-1))) {{m <> 0}};\n",
             fmt::arg("r", n.reciprocal_bits), fmt::arg("g", n.fraction),
             fmt::arg("full", (std::int64_t(1) << n.value_bits) - 1), fmt::arg("x", 2 * config.width - 1),
             fmt::arg("y", 2 * config.height - 1), fmt::arg("x0", vertex("x", config.width)),
             fmt::arg("y0", vertex("y", config.height)), fmt::arg("sum", symmetric(bound.sum)),
             fmt::arg("low", number(bound.sum)), fmt::arg("high", number(bound.in_register)));
}

// V: the sum of the plane, v: the exact value. The integer part of the register is that of V + ½: it was cut below
// 2^−g.
std::string rounded(const Config& config, const char* kind, const PlaneNumbers& n) {
  const PlaneBound bound = plane_bound(n, largest_reach(config, Vertices::kGuardBand));
  const std::int64_t full = (std::int64_t(1) << n.value_bits) - 1;
  return header(config, fmt::format("A {} at a pixel, rounded: half an LSB more, and never out of its bits.", kind)) +
         fmt::format("z = fixed<0,nu>(V);\n\n{{ V - v {} /\\ v in [0, {}]\n  -> z - v {} /\\ z in [0, {}b0] }}\n",
                     symmetric(bound.sum), full, symmetric(bound.rounded), full);
}

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

}  // namespace

std::vector<GappaScript> gappa_scripts(const Config& config) {
  std::vector<GappaScript> scripts = {{"snap", snap(config)}};
  if (has_planes(config)) scripts.push_back({"triangle_setup_reciprocal", reciprocal(config)});
  auto channel = [&](const char* kind, const PlaneNumbers& n, const std::string& setup, const std::string& at_pixels) {
    scripts.push_back({setup + "_product", product(config, kind, n.value_bits, n.fraction)});
    scripts.push_back({fmt::format("{}_{}", at_pixels, kind), plane(config, kind, n, Vertices::kGuardBand)});
    scripts.push_back({fmt::format("{}_{}_frame", at_pixels, kind), plane(config, kind, n, Vertices::kFrame)});
    scripts.push_back({at_pixels + "_rounded", rounded(config, kind, n)});
  };
  if (has_depth(config)) channel("depth", depth_numbers(config), "triangle_setup", "raster_pineda");
  if (is_gouraud(config)) channel("colour", colour_numbers(config), "shade_setup", "shade_gouraud");
  if (is_phong(config)) channel("normal", normal_numbers(config), "phong_setup", "shade_phong");
  if (has_lighting(config)) {
    scripts.push_back({"light_cosine", light_cosine(config)});
    if (exact_log2(config.gloss) > 0) scripts.push_back({"light_power", light_power(config)});
    scripts.push_back({"light_sum", light_sum(config)});
  }
  return scripts;
}

}  // namespace halfspace::model
