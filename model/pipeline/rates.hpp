// SPDX-License-Identifier: Apache-2.0
// The data rates of a frame, counted at the streams of the kernels.
#ifndef HALFSPACE_VECTORS_RATES_HPP_
#define HALFSPACE_VECTORS_RATES_HPP_

#include "ref/architecture.hpp"
#include "vectors/engine.hpp"

namespace halfspace::vectors {

// Triangles, fragments, visible pixels, and with lighting its operations; what is not in a stream stays 0. Takes a rendering.
ref::Rates count_rates(Engine& engine, const ref::SnappedList& scene, const Config& config);

}  // namespace halfspace::vectors

#endif  // HALFSPACE_VECTORS_RATES_HPP_
