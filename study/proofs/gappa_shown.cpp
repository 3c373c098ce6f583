// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "study/proofs/gappa_text.hpp"
#include "study/proofs/lighting_bounds.hpp"
#include "study/proofs/motion_bounds.hpp"
#include "study/proofs/phong_bounds.hpp"
#include "study/proofs/shown_bounds.hpp"
#include "study/proofs/texture_bounds.hpp"

namespace halfspace::model {
namespace {

// z: the plane of the colours of the vertices as it is rounded at the pixel, v: the exact mean of these, V: that of
// exact colours. Where a triangle has one colour, or a pixel its own, that is all.
ScriptParts surface(const Config& config) {
  const std::string lit = has_lighting(config) ? symmetric(light_bound(config) + Dyadic{1, -1}) : "in [0, 0]";
  if (is_gouraud(config)) {
    const Dyadic plane = plane_bound(colour_numbers(config), largest_reach(config, Vertices::kGuardBand)).rounded;
    return {"From snapped vertices to the colour that is shown.",
            {},
            {"z - v " + symmetric(plane), "v - V " + lit},
            {"z - V " + symmetric(surface_bound(config))},
            {}};
  }
  return {"From snapped vertices to the colour that is shown.",
          {},
          {"z - v " + symmetric(surface_bound(config)), "v - V in [0, 0]"},
          {"z - V " + symmetric(surface_bound(config))},
          {}};
}

// t: the texel as filtered, f: the exact mean at the place that the weights are of, T: at the exact place, du and dv
// off, where neighbours differ by Du and Dv.
std::string textured(const Config& config) {
  const int full = (1 << config.colour_bits) - 1;
  ScriptParts parts = surface(config);
  const ShownTexel texel = shown_texel(config);
  parts.definitions.push_back("f = T + du*Du + dv*Dv");
  parts.premises.push_back(fmt::format("z in [0, {}]", full));
  parts.premises.push_back(fmt::format("T in [0, {}]", full));
  parts.premises.push_back("t - f " + symmetric(texel.filter));
  parts.premises.push_back("du " + symmetric(texel.place));
  parts.premises.push_back("dv " + symmetric(texel.place));
  parts.premises.push_back("Du " + symmetric(texel.apart));
  parts.premises.push_back("Dv " + symmetric(texel.apart));
  parts.premises.push_back(fmt::format("shown - z*t/{} {}", full, symmetric(texel.product)));
  if (is_bilinear(config)) parts.goals.push_back("t - T " + symmetric(texel.texel));
  parts.goals.push_back(fmt::format("shown - V*T/{} {}", full, symmetric(shown_bound(config))));
  parts.hints.push_back("t - T -> (t - f) + du*Du + dv*Dv");
  parts.hints.push_back(fmt::format("shown - V*T/{0} -> (shown - z*t/{0}) + z/{0}*(t - T) + T/{0}*(z - V)", full));
  return script(config, parts);
}

// A: the colour of a key at the exact place, k: at that of the vector, off by du and dv pixels of the key, where it
// changes by Du and Dv a pixel; r: what relighting is off.
std::string between(const Config& config) {
  const ShownKey key = shown_key(config);
  return script(
      config, {"From snapped vertices, and two key frames, to the colour that is shown.",
               {"k = A + du*Du + dv*Dv"},
               {"shown - (k + r) " + symmetric(key.colour), "du " + symmetric(key.place), "dv " + symmetric(key.place),
                "Du " + symmetric(key.slope), "Dv " + symmetric(key.slope), "r " + symmetric(key.difference)},
               {"shown - A " + symmetric(shown_bound(config))},
               {"shown - A -> (shown - (k + r)) + du*Du + dv*Dv + r"}});
}

}  // namespace

void add_shown_script(const Config& config, std::vector<GappaScript>& scripts) {
  if (value(shown_bound(config)) == 0) return;
  scripts.push_back({"shown", has_motion(config)    ? between(config)
                              : has_texture(config) ? textured(config)
                                                    : script(config, surface(config))});
}

}  // namespace halfspace::model
