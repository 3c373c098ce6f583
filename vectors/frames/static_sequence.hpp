// SPDX-License-Identifier: Apache-2.0
// A sequence of the static objects buffer as hs_pipeline and ztest_merge see it: passes, and runs.
#ifndef HALFSPACE_VECTORS_FRAMES_STATIC_SEQUENCE_HPP_
#define HALFSPACE_VECTORS_FRAMES_STATIC_SEQUENCE_HPP_

#include <string>
#include <vector>

#include "model/drivers/static_frames.hpp"
#include "vectors/frames/merge_frames.hpp"

namespace halfspace::model {

// Notes begin with the frame of the sequence. That of a run in which a pass is merged ends with "pass P", its place in
// `passes`.
struct StaticSequence {
  std::vector<NamedFrame> passes;
  std::vector<NamedMerge> runs;
};

// A frame of it as hs_static_frames sees it.
struct StaticSequenceFrame {
  std::string note;  // its kinds of runs
  std::vector<NamedFrame> passes;
  std::vector<RawCommand> commands;
  std::vector<RawEntry> picture;  // what is shown
  std::uint64_t run_cycles = 0;   // of StaticFrameWork
};

// Of moving_scene(objects), from a seed.
StaticSequence static_sequence(const StaticFramesOptions& options, int objects, int frames, std::uint64_t seed);
std::vector<StaticSequenceFrame> static_sequence_frames(const StaticFramesOptions& options, int objects, int frames,
                                                        std::uint64_t seed);

}  // namespace halfspace::model

#endif  // HALFSPACE_VECTORS_FRAMES_STATIC_SEQUENCE_HPP_
