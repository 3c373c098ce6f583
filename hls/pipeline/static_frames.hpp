// SPDX-License-Identifier: Apache-2.0
// Frames of which what stands still is drawn once: hs_pipeline draws passes, and commands merge them with buffers in
// memory, into buffers or into the frame.
//
//   command ─► static_run ─merge, stored, drawn─► ztest_merge ─► found
//                │    ▲                                │
//   pipeline ─entry   └── memory of buffers ◄─kept─┐ merged
//                                        frame ◄─shown─┴── static_run
//
// What of a frame is a pass, and what commands it takes, is the driver's: docs/static.md.
#ifndef HALFSPACE_HLS_PIPELINE_STATIC_FRAMES_HPP_
#define HALFSPACE_HLS_PIPELINE_STATIC_FRAMES_HPP_

#include "hls/formats/streams.hpp"
#include "hls/objects/static_run.hpp"
#include "hls/objects/ztest_merge.hpp"

namespace halfspace {

#define HS_STATIC_FRAMES_STREAMS(X) HS_STATIC_STREAMS(X) HS_MERGE_STREAMS(X)

// Those of the table from the command on; `entry` is of hs_pipeline too.
template <class F>
struct StaticStreams {
  HS_STREAM_MEMBERS(HS_STATIC_FRAMES_STREAMS)
};

// A command; the stamps of its pass are in s.entry.
template <class F, class Memory>
void static_frames(StaticStreams<F>& s, Memory& memory) {
  const StaticCommand<F> run = s.command.read();
  static_fetch(run, memory, s.entry, s.merge, s.stored, s.drawn);
  ztest_merge(s.merge, s.stored, s.drawn, s.merged, s.found);
  static_store(run, memory, s.merged, s.shown);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_PIPELINE_STATIC_FRAMES_HPP_
