// SPDX-License-Identifier: Apache-2.0
#include "vectors/frames/static_sequence.hpp"

#include <fmt/format.h>

#include "vectors/frames/moving_scene.hpp"

namespace halfspace::model {
namespace {

// draw(buffers, frame) for each.
template <class Draw>
void each_frame(const StaticFramesOptions& options, int objects, int frames, std::uint64_t seed, Draw draw) {
  ref::Scene scene = moving_scene(objects);
  SceneMotion motion(seed, objects);
  motion.begin(scene);
  StaticFrames buffers(scene, options);
  for (int frame = 0; frame < frames; ++frame) {
    motion.step(scene);
    motion.move_viewer(scene);
    if (motion.dim(scene)) buffers.start_anew();
    draw(buffers, frame);
  }
}

}  // namespace

StaticSequence static_sequence(const StaticFramesOptions& options, int objects, int frames, std::uint64_t seed) {
  StaticSequence out;
  int frame = 0;
  StaticFramesSink sink;
  sink.pass = [&](const NamedFrame& pass) {
    out.passes.push_back(pass);
    out.passes.back().note = fmt::format("frame {}", frame);
  };
  sink.run = [&](const char* what, const MergeInput& in) {
    NamedMerge& run = out.runs.emplace_back();
    run.note = fmt::format("frame {}, {}", frame, what);
    const bool of_pass = in.drawn != nullptr && std::string(what) != "compose";
    if (of_pass) run.note += fmt::format(", pass {}", out.passes.size() - 1);
    run.width = in.width, run.height = in.height, run.box = in.box;
    run.stored = *in.stored;
    if (in.drawn) run.drawn = *in.drawn;
    run.sends = in.sends, run.first = in.first, run.last = in.last, run.background = in.background;
  };
  each_frame(options, objects, frames, seed, [&](StaticFrames& buffers, int n) {
    frame = n;
    buffers.draw(sink);
  });
  return out;
}

std::vector<StaticSequenceFrame> static_sequence_frames(const StaticFramesOptions& options, int objects, int frames,
                                                        std::uint64_t seed) {
  std::vector<StaticSequenceFrame> out;
  StaticFramesSink sink;
  sink.pass = [&](const NamedFrame& pass) { out.back().passes.push_back(pass); };
  sink.command = [&](const char* what, const RawCommand& command) {
    StaticSequenceFrame& frame = out.back();
    frame.note += fmt::format("{}{}", frame.commands.empty() ? "" : ", ", what);
    frame.commands.push_back(command);
  };
  each_frame(options, objects, frames, seed, [&](StaticFrames& buffers, int) {
    out.emplace_back();
    out.back().run_cycles = buffers.draw(sink).run_cycles;
    out.back().picture = buffers.picture();
  });
  return out;
}

}  // namespace halfspace::model
