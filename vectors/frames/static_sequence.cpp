// SPDX-License-Identifier: Apache-2.0
#include "vectors/frames/static_sequence.hpp"

#include <fmt/format.h>

#include "vectors/frames/moving_scene.hpp"

namespace halfspace::model {

StaticSequence static_sequence(const StaticFramesOptions& options, int objects, int frames, std::uint64_t seed) {
  StaticSequence out;
  ref::Scene scene = moving_scene(objects);
  SceneMotion motion(seed, objects);
  motion.begin(scene);
  StaticFrames buffers(scene, options);
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
  for (; frame < frames; ++frame) {
    motion.step(scene);
    motion.move_viewer(scene);
    if (motion.dim(scene)) buffers.start_anew();
    buffers.draw(sink);
  }
  return out;
}

}  // namespace halfspace::model
