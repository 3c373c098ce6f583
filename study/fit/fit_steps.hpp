// SPDX-License-Identifier: Apache-2.0
// What the search of a configuration takes away: a step of a number, a unit.
#ifndef HALFSPACE_STUDY_FIT_FIT_STEPS_HPP_
#define HALFSPACE_STUDY_FIT_FIT_STEPS_HPP_

#include <optional>
#include <string>
#include <vector>

#include "study/fit/fit.hpp"

namespace halfspace::model {

// The numbers of a configuration that accuracy depends on, those first that save most memory.
std::vector<const ConfigField*> fit_numbers(const Config&);

// A step less, or more, of a number: one, or of a power of two its half, or its double. None at the end of its limits.
std::optional<Config> stepped(const Config&, const ConfigField&, int direction);

// A unit that may not be there, or a simpler one in its place; its planes are generous again.
struct FitUnit {
  const char* name;                                 // the choice of the configuration that it is
  std::optional<Config> (*without)(const Config&);  // none where it is not there
};
const std::vector<FitUnit>& fit_units();

// What a scene asks of the units of lights and textures, over all frames.
struct FitNeeds {
  int lights = 0, materials = 0, squarings = -1;  // log2 of the largest exponent of a highlight
  int textures = 0, texels = 0;
};
FitNeeds fit_needs(const FitScene&, const ref::IdealLook&);

// More than enough, with f sub-pixel bits, for the look. It may be refused.
Config generous(const FitScene&, const ref::IdealLook&, const FitNeeds&, int subpixel_bits);

// Likewise of frames between key frames.
Config generous_motion(int width, int height, int face_bits, KeyFilter filter);

}  // namespace halfspace::model

#endif  // HALFSPACE_STUDY_FIT_FIT_STEPS_HPP_
