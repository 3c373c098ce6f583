// SPDX-License-Identifier: Apache-2.0
// Cycles a frame of the RTL, without simulating it.
//
// Type γ: the Z-test takes the cycles of ztest_plane; that a stamp waits for one in flight at the same pixels is not
// modelled. The kernels tell what a frame asks of each unit: stamps visited, triangles in a stamp. The model moves
// triangles, not clock edges: each unit takes what it offers after its interval and latency, waits for the one before
// it and for room in the queue behind it (rtl/pipeline/hs_pipeline.sv), as in the comments of rtl/hs_*.sv. Frames
// follow each other at once. Held to the co-simulation in tests/pipeline/cosim_test.py.
#ifndef HALFSPACE_MODEL_PIPELINE_CYCLES_HPP_
#define HALFSPACE_MODEL_PIPELINE_CYCLES_HPP_

#include <cstdint>
#include <vector>

#include "hls/formats/config.hpp"
#include "model/pipeline/engine.hpp"
#include "ref/geometry/snap.hpp"
#include "ref/raster/raster.hpp"

namespace halfspace::model {

// Cycles of the units that depend on the configuration alone.
struct UnitIntervals {
  // A triangle that is not empty; 3 when its box holds no pixel centre, else 7 when D is 0 or it is culled.
  int triangle_setup;
  int shade_setup;  // a triangle that is not empty
};
UnitIntervals unit_intervals(const Config&);

// What a triangle takes of both setup units when nothing keeps it waiting.
struct SetupCycles {
  int triangle_setup, shade_setup;
};
class SetupModel {
 public:
  SetupModel(const Config&, int width, int height);
  SetupCycles cycles(const ref::SnappedTriangle&) const;
  // Whether its box holds a pixel centre and it has an area, so that it is looked at for culling.
  bool has_sign(const ref::SnappedTriangle&) const;

 private:
  const int subpixel_bits_, width_, height_;
  const Cull cull_;
  const UnitIntervals intervals_;
};

struct Cycles {
  std::uint64_t frame = 0;  // from the last pixel of a frame to the last of the next
  // What the units would take that had never to wait: the slowest of them, and a little, is a frame.
  std::uint64_t triangle_setup = 0, shade_setup = 0, raster = 0, test = 0, scan_out = 0;
};

// `frame` is what `engine` renders `scene` to. Frames drawn back to back: the last is counted.
Cycles model_cycles(const Config&, Engine& engine, const ref::SnappedList& scene, const ref::Frame& frame,
                    int frames = 2);

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_PIPELINE_CYCLES_HPP_
