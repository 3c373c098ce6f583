// SPDX-License-Identifier: Apache-2.0
// How many words each stream of the pipeline holds in the RTL.
//
//   X(member, depth, fifo)
//
//   member   of Streams<F>
//   depth    words that it holds, as an expression on formats F. Without a queue 1: the output register of its writer,
//            which works on its next word meanwhile. Where the RTL has no register either, as before and behind a fork,
//            1 is the least that a queue has.
//   fifo     the module and the parameter of the RTL that set it; "": no queue
//
// Those of 512 let geometry send 512 triangles before it takes a `visible`. The others keep units busy: with one word
// each the words would come later, and the same. A test holds them to the parameters of the RTL.
#ifndef HALFSPACE_HLS_FORMATS_STREAM_DEPTHS_HPP_
#define HALFSPACE_HLS_FORMATS_STREAM_DEPTHS_HPP_

namespace halfspace {

// How many triangles geometry may send before it takes a `visible`, with any formats: setups and, deferred, attributes
// of them all fit.
constexpr int kTrianglesAhead = 512;

// clang-format off
#define HS_STREAM_DEPTHS(X)                                                                                     \
  X(triangle, 1, "")                                                                                            \
  X(unnumbered, 1, "")                                                                                          \
  X(numbered, 1, "")                                                                                            \
  X(drawn_triangle, 1, "")                                                                                      \
  X(numbered_triangle, 1, "")                                                                                   \
  X(faced_triangle, 1, "")                                                                                      \
  X(setup, kTrianglesAhead, "hs_pipeline SetupFifoDepth")                                                       \
  X(attributes, F::kDeferred ? kTrianglesAhead : 4,                                                             \
    F::kDeferred ? "hs_pipeline DeferFifoDepth" : "hs_shading AttributesFifoDepth")                             \
  X(triangle_depth, 4, "hs_pipeline TriangleDepthFifoDepth")                                                    \
  X(stamp, 4, "hs_pipeline StampFifoDepth")                                                                     \
  X(tested, 1, "")                                                                                              \
  X(selected, 1, "")                                                                                            \
  X(returned, F::kGivesIndices ? F::kIndexWindow : 1, F::kGivesIndices ? "hs_index_pool IndexWindow" : "")            \
  X(visible, 1, "")                                                                                             \
  X(visible_attributes, 4, F::kHasMotion ? "hs_motion AttributesFifoDepth" : "hs_shading AttributesFifoDepth")  \
  X(coloured_attributes, 1, "")                                                                                 \
  X(texed_attributes, 1, "")                                                                                    \
  X(normals, 1, "")                                                                                             \
  X(colours, 4, "hs_shade_planes ColoursFifoDepth")                                                             \
  X(normal_planes, 1, "")                                                                                       \
  X(planes, 1, "")                                                                                              \
  X(texture_coordinates, 1, "")                                                                                 \
  X(texture_planes, 1, "")                                                                                      \
  X(motion_vectors, 1, "")                                                                                      \
  X(motion_planes, 1, "")                                                                                       \
  X(scan, F::kHasTexture || F::kHasObjects ? 1 : 4,                                                             \
    F::kHasTexture || F::kHasObjects ? "" : F::kHasMotion ? "hs_motion ScanFifoDepth" : "hs_shading ScanFifoDepth") \
  X(pixel_scan, F::kHasTexture ? 1 : 4, F::kHasTexture ? "" : "hs_shading ScanFifoDepth")                       \
  X(object_scan, F::kPhong || F::kHasTexture ? 32 : 16, "hs_objects ScanFifoDepth")                             \
  X(coloured_scan, F::kHasTexture ? 32 : 4, "hs_shading ScanFifoDepth")                                         \
  X(texed_scan, 64, "hs_texture ScanFifoDepth")                                                                 \
  X(masked, 1, "")                                                                                              \
  X(stored_scan, 1, "")                                                                                         \
  X(lit, 1, "")                                                                                                 \
  X(shown_pixel, 1, "")                                                                                         \
  X(object_pixel, 1, "")                                                                                        \
  X(pixel, 1, "")                                                                                               \
  X(motion, 1, "")                                                                                              \
  X(entry, 1, "")                                                                                               \
  X(shown, 1, "")
// clang-format on

// StreamDepths<F>::member
template <class F>
struct StreamDepths {
#define HS_STREAM_DEPTH(member, depth, fifo) static constexpr int member = depth;
  HS_STREAM_DEPTHS(HS_STREAM_DEPTH)
#undef HS_STREAM_DEPTH
};

}  // namespace halfspace

#endif  // HALFSPACE_HLS_FORMATS_STREAM_DEPTHS_HPP_
