// SPDX-License-Identifier: Apache-2.0
// The data rates of a frame, counted at the streams of the kernels.
#ifndef HALFSPACE_MODEL_PIPELINE_RATES_HPP_
#define HALFSPACE_MODEL_PIPELINE_RATES_HPP_

#include "model/pipeline/engine.hpp"
#include "ref/raster/architecture.hpp"

namespace halfspace::model {

// Triangles, fragments, visible pixels, and with lighting its operations; what is not in a stream stays 0. Takes a
// rendering.
ref::Rates count_rates(Engine& engine, const ref::SnappedList& scene, const Config& config);

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_PIPELINE_RATES_HPP_
