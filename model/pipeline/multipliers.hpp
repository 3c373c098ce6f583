// SPDX-License-Identifier: Apache-2.0
// What multipliers a configuration takes, before any synthesis.
#ifndef HALFSPACE_MODEL_PIPELINE_MULTIPLIERS_HPP_
#define HALFSPACE_MODEL_PIPELINE_MULTIPLIERS_HPP_

#include <cstdint>
#include <optional>

#include "hls/formats/config.hpp"

namespace halfspace::model {

// The multipliers of hs_pipeline, one of a by b bits counted as a·b, the bits that it adds up: one for edges, one for
// the plane of depth, one for those of colour, two a channel in the shader, and with type γ two in the Z-test. Lanes
// add, and have none. None where there are units of lights, texture or motion, which are not counted.
std::optional<std::uint64_t> multiplier_bits(const Config&);

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_PIPELINE_MULTIPLIERS_HPP_
