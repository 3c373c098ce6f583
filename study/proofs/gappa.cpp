// SPDX-License-Identifier: Apache-2.0
#include "study/proofs/gappa.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "study/proofs/bounds_proved.hpp"
#include "study/proofs/gappa_text.hpp"

namespace halfspace::model {
std::string number(const Dyadic& n) { return fmt::format("{}b{}", n.mantissa, n.exponent); }
std::string symmetric(const Dyadic& n) { return fmt::format("in [-{0}, {0}]", number(n)); }

std::string header(const Config& config, const std::string& what) {
  return fmt::format("# {}\n# Printed by `halfspace bounds` from the numbers of configuration `{}`.\n\n", what,
                     config.name);
}

std::string script(const Config& config, const ScriptParts& parts) {
  std::string text = header(config, parts.what);
  for (const std::string& line : parts.definitions) text += line + ";\n";
  text += "\n{ ";
  for (std::size_t n = 0; n < parts.premises.size(); ++n) text += (n ? "\n  /\\ " : "") + parts.premises[n];
  for (std::size_t n = 0; n < parts.goals.size(); ++n) text += (n ? "\n  /\\ " : "\n  -> ") + parts.goals[n];
  text += " }\n";
  for (const std::string& line : parts.hints) text += "\n" + line + ";";
  return parts.hints.empty() ? text : text + "\n";
}

namespace {

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
  const char* const setup = has_motion(config) ? "motion_setup" : "texture_setup";
  const char* const shader = has_motion(config) ? "motion_field" : "shade_texture";
  if (has_coordinates(config)) channel("coordinate", coordinate_numbers(config), setup, shader);
  if (relights(config)) {
    const PlaneNumbers n = difference_numbers(config);
    scripts.push_back({"motion_setup_difference_product", product(config, "difference", n.value_bits, n.fraction)});
    scripts.push_back({"motion_field_difference", plane(config, "difference", n, Vertices::kGuardBand)});
    scripts.push_back({"motion_field_difference_frame", plane(config, "difference", n, Vertices::kFrame)});
    scripts.push_back({"motion_field_difference_rounded", rounded(config, "difference", n)});
  }
  if (has_lighting(config)) add_lighting_scripts(config, scripts);
  if (has_texture(config)) add_texture_scripts(config, scripts);
  if (has_motion(config)) add_motion_scripts(config, scripts);
  add_shown_script(config, scripts);
  return scripts;
}

}  // namespace halfspace::model
