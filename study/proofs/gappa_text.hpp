// SPDX-License-Identifier: Apache-2.0
// What the scripts for Gappa are written with.
#ifndef HALFSPACE_STUDY_PROOFS_GAPPA_TEXT_HPP_
#define HALFSPACE_STUDY_PROOFS_GAPPA_TEXT_HPP_

#include <string>
#include <vector>

#include "study/proofs/bounds_proved.hpp"
#include "study/proofs/gappa.hpp"

namespace halfspace::model {

std::string number(const Dyadic& n);
std::string symmetric(const Dyadic& n);  // in [-n, n]
std::string header(const Config& config, const std::string& what);

// A script of its parts: definitions and hints a line each.
struct ScriptParts {
  std::string what;
  std::vector<std::string> definitions, premises, goals, hints;
};
std::string script(const Config& config, const ScriptParts& parts);

// The scripts of a feature that are not of planes.
void add_lighting_scripts(const Config& config, std::vector<GappaScript>& scripts);
void add_texture_scripts(const Config& config, std::vector<GappaScript>& scripts);
void add_motion_scripts(const Config& config, std::vector<GappaScript>& scripts);
void add_shown_script(const Config& config, std::vector<GappaScript>& scripts);

// Definitions, premises, goals and hints of `place`, whose exact value is span·X, X the quotient of exact planes.
ScriptParts place_parts(const Config& config, const std::string& what, int log2_span);

}  // namespace halfspace::model

#endif  // HALFSPACE_STUDY_PROOFS_GAPPA_TEXT_HPP_
