// SPDX-License-Identifier: Apache-2.0
// Static objects buffers by the kernels: what ref/objects/static_objects.hpp is by the reference. hs_pipeline draws
// passes, ztest_merge puts them into S-buffers and frames, erases and asks; here is what a driver does. docs/static.md
// has the rules.
#ifndef HALFSPACE_MODEL_DRIVERS_STATIC_FRAMES_HPP_
#define HALFSPACE_MODEL_DRIVERS_STATIC_FRAMES_HPP_

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "model/objects/merge.hpp"
#include "model/pipeline/engine.hpp"
#include "model/pipeline/named_frame.hpp"
#include "model/pipeline/static_runs.hpp"
#include "ref/geometry/geometry.hpp"
#include "ref/objects/object_states.hpp"

namespace halfspace::model {

struct StaticFramesOptions {
  Configuration configuration;  // with objects
  int lanes = 4;
  int width = 0, height = 0;
  int buffers = 1;  // S-buffers; instance n is in number n mod buffers while it stands still
  // An S-buffer is asked before it is changed; else each update is done, in the whole box of the object.
  bool query = true;
  int window = 0;  // of index reuse
};

// What a frame took.
struct StaticFrameWork {
  bool new_view = false;                             // all is dynamic, and the S-buffers are empty
  std::uint64_t moving = 0, added = 0, redrawn = 0;  // objects drawn: SD and DD; DS; others of an S-buffer, for an SD
  std::uint64_t started = 0, queries = 0, skipped = 0;  // SD, seen from where the last frame was; asked; skipped
  std::uint64_t erased = 0;                             // of the SD, those that left pixels to be drawn again
  std::uint64_t passes = 0, triangles = 0;              // frames of hs_pipeline, and what it was handed
  std::uint64_t runs = 0;                               // of ztest_merge, queries too
  // What they take in hs_static_frames beside its passes, where a place is answered in the next cycle: a pass is merged
  // while it is scanned out.
  std::uint64_t run_cycles = 0;
};

// Told of each pass, and of each run, before it is done. What they point to is gone afterwards. A run is told as
// ztest_merge does it, and as a command of hs_static_frames, which are the same but for what several passes come to: it
// is kept in the D-buffer.
struct StaticFramesSink {
  std::function<void(const NamedFrame&)> pass;
  std::function<void(const char* what, const MergeInput&)> run;
  std::function<void(const char* what, const RawCommand&)> command;
};

class StaticFrames {
 public:
  // The scene as in ref::StaticObjects. Throws ref::Error for a configuration without objects and where
  // ref::ObjectStates does.
  StaticFrames(const ref::Scene&, const StaticFramesOptions&);

  // The scene as it stands now. With lighting in hardware, where the middle of the scene is the point that lights and
  // viewer are seen from, a movement of it may be a change of light.
  const StaticFrameWork& draw(const StaticFramesSink& sink = {});
  // Other lights, materials, meshes or background: the next frame begins as after a movement of the viewpoint.
  void start_anew() { states_.start_anew(); }

  const std::vector<RawEntry>& picture() const { return picture_; }
  const ref::ObjectStates& states() const { return states_; }
  // An S-buffer; null if it is empty.
  const std::vector<RawEntry>* static_buffer(int k) const { return filled_[k] ? &static_[k] : nullptr; }

  // All triangles of these objects, which are instances of the scene in ascending order, as they stand now.
  NamedFrame triangles(const std::vector<std::uint32_t>& instances);
  // A frame of an engine of `configuration`.
  static std::vector<RawEntry> entries(Engine&, const Configuration& configuration, const NamedFrame&);

 private:
  struct Pass {
    NamedFrame frame;
    ref::Box covered;
  };
  void look();
  void leave(std::uint32_t n, std::vector<ref::Box>& holes);
  void update(int k, const std::vector<ref::Box>& holes);
  void compose();
  void show();
  std::vector<Pass> passes(const NamedFrame&, const ref::Box& region);
  std::vector<RawEntry> draw_pass(const NamedFrame&);
  MergeInput input(const std::vector<RawEntry>& stored, const std::vector<RawEntry>* drawn, const ref::Box& box) const;
  MergeResult run(const char* what, const MergeInput& input, const RawCommand& buffers);
  // Of the buffers that a run takes, its command; of its passes, if it has one.
  void tell(const char* what, const MergeInput& input, RawCommand buffers);
  std::uint64_t stamps(const ref::Box&) const;

  const ref::Scene& scene_;
  const StaticFramesOptions options_;
  const Config config_;
  const ref::Box frame_;
  std::unique_ptr<Engine> engine_;
  Merger merger_;
  ref::ObjectStates states_;
  // Of the scene as it stands in this frame.
  std::optional<ref::Geometry> geometry_;
  LightingFrame lighting_;
  TextureFrame texture_;
  std::array<std::uint8_t, 3> background_{};

  std::vector<std::vector<RawEntry>> static_;
  std::vector<bool> filled_;                       // what is in the others is of an earlier viewpoint
  std::vector<RawEntry> still_;                    // those that are filled merged, where they are two or more
  const std::vector<RawEntry>* behind_ = nullptr;  // all that stands still; null: nothing does
  int behind_number_ = 0;                          // of that buffer
  std::vector<RawEntry> picture_;
  ref::Box changed_;  // of the S-buffers in this frame
  StaticFrameWork work_;
  const StaticFramesSink* sink_ = nullptr;
};

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_DRIVERS_STATIC_FRAMES_HPP_
