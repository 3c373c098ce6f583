// SPDX-License-Identifier: Apache-2.0
// The streams of the pipeline, of the table in hls/formats/streams.hpp; and what is between units besides: copies for
// two readers, and words that are not watched.
#ifndef HALFSPACE_HLS_PIPELINE_PIPELINE_STREAMS_HPP_
#define HALFSPACE_HLS_PIPELINE_PIPELINE_STREAMS_HPP_

#include "hls/formats/film_records.hpp"
#include "hls/formats/object_records.hpp"
#include "hls/formats/streams.hpp"
#include "hls/numbers/stream.hpp"

namespace halfspace {

template <class F>
struct InnerStreams {
  Stream<Triangle<F>> drawn_triangle, numbered_triangle;        // with objects: copies of triangle
  Stream<Visible<F>> tested;                                    // deferred: before visible_select
  Stream<Visible<F>> selected, returned;                        // with an index_pool: visible, and its copy for that
  Stream<Attributes<F>> coloured_attributes, texed_attributes;  // with texture: copies of those of visible triangles
  Stream<Scan<F>> pixel_scan, object_scan;                      // with objects: copies of scan
  Stream<Triangle<F>> faced_triangle;                           // of films: a copy of triangle
  Stream<Scan<F>> stored_scan;                                  // of films: a copy of masked, as pixel_scan is
  Stream<Scan<F>> coloured_scan, texed_scan;                    // with texture: copies of either
  Stream<Pixel<F>> shown_pixel;                                 // with objects: before join_entry
  Stream<ObjectPixel<F>> object_pixel;                          // likewise
  Probe<int> visits;                                            // stamps that a triangle's walk visits
  Probe<PlaneTests> tests;                                      // what its stamps cost ztest_plane
};

template <class F>
struct Streams : InnerStreams<F> {
  HS_STREAM_MEMBERS(HS_PIPELINE_STREAMS)
};

}  // namespace halfspace

#endif  // HALFSPACE_HLS_PIPELINE_PIPELINE_STREAMS_HPP_
