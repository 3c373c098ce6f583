// SPDX-License-Identifier: Apache-2.0
// The lighting kernels, measured.
#ifndef HALFSPACE_STUDY_BOUNDS_LIGHTING_MEASURE_HPP_
#define HALFSPACE_STUDY_BOUNDS_LIGHTING_MEASURE_HPP_

#include <cstdint>

#include "study/bounds/bounds.hpp"

namespace halfspace::model {

// The kernels of a configuration with lighting, into its rows of the report: random lights, for each a search of
// normals for the largest errors.
void measure_lighting(const Config& config, std::uint64_t seed, int lights, BoundsReport& report);

}  // namespace halfspace::model

#endif  // HALFSPACE_STUDY_BOUNDS_LIGHTING_MEASURE_HPP_
