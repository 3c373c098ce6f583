// SPDX-License-Identifier: Apache-2.0
// Configurations that nobody named: parts and numbers at random, some of these the smallest or the largest that is
// accepted beside the others.
#ifndef HALFSPACE_MODEL_FORMATS_RANDOM_CONFIGURATION_HPP_
#define HALFSPACE_MODEL_FORMATS_RANDOM_CONFIGURATION_HPP_

#include <cstdint>

#include "model/formats/configuration.hpp"

namespace halfspace::model {

// `random_SEED`; the same one for the same seed. Small: of a frame, tables and memories that a simulation of seconds
// fills, with words of any width.
Configuration random_configuration(std::uint64_t seed, bool is_small);

// The smallest, or else the largest, of a number that is accepted beside the rest of c, which is accepted as it is.
// False where there is no such number in c.
bool to_extreme(Config& c, const ConfigField& number, bool is_smallest);

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_FORMATS_RANDOM_CONFIGURATION_HPP_
