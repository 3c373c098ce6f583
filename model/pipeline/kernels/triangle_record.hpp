// SPDX-License-Identifier: Apache-2.0
// A snapped triangle as the kernels take it.
#ifndef HALFSPACE_MODEL_PIPELINE_KERNELS_TRIANGLE_RECORD_HPP_
#define HALFSPACE_MODEL_PIPELINE_KERNELS_TRIANGLE_RECORD_HPP_

#include <cstdint>

#include "hls/formats/records.hpp"
#include "ref/geometry/snap.hpp"

namespace halfspace::model {

// `object` is looked at with F::kHasObjects alone; `last` is 0.
template <class F>
Triangle<F> triangle_record(const ref::SnappedTriangle& in, std::uint32_t index, std::uint32_t object) {
  Triangle<F> t{};
  t.index = from_raw<typename F::Index>(index);
  if (F::kHasObjects) t.object = from_raw<typename F::Object>(object);
  for (int v = 0; v < 3; ++v) {
    t.x[v] = from_raw<typename F::Coord>(in.x[v]);
    t.y[v] = from_raw<typename F::Coord>(in.y[v]);
    t.depth[v] = from_raw<typename F::Depth>(in.depth[v]);
    t.r[v] = from_raw<typename F::Colour>(in.rgb[v][0]);
    t.g[v] = from_raw<typename F::Colour>(in.rgb[v][1]);
    t.b[v] = from_raw<typename F::Colour>(in.rgb[v][2]);
  }
  return t;
}

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_PIPELINE_KERNELS_TRIANGLE_RECORD_HPP_
