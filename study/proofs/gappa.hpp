// SPDX-License-Identifier: Apache-2.0
// The bounds of study/proofs/bounds_proved.hpp as scripts for Gappa, which proves each or says that it cannot. They are
// printed from the numbers of a configuration, so every configuration has its own.
#ifndef HALFSPACE_STUDY_PROOFS_GAPPA_HPP_
#define HALFSPACE_STUDY_PROOFS_GAPPA_HPP_

#include <string>
#include <vector>

#include "hls/formats/formats.hpp"

namespace halfspace::model {

struct GappaScript {
  std::string name;  // of its file, without the ending .g
  std::string text;
};

// Every script of a configuration, in flow order. Each has one line `->` with its goals; a number that is as small as
// it can be there is written mantissa b exponent, a limit that need not be is a plain integer.
std::vector<GappaScript> gappa_scripts(const Config& config);

}  // namespace halfspace::model

#endif  // HALFSPACE_STUDY_PROOFS_GAPPA_HPP_
