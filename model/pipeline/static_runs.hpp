// SPDX-License-Identifier: Apache-2.0
// The commands of hs_static_frames, for any configuration with objects: the kernels, and the memory of the buffers.
#ifndef HALFSPACE_MODEL_PIPELINE_STATIC_RUNS_HPP_
#define HALFSPACE_MODEL_PIPELINE_STATIC_RUNS_HPP_

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "model/formats/configuration.hpp"
#include "model/formats/layout.hpp"
#include "model/objects/object_words.hpp"
#include "ref/objects/object_buffer.hpp"

namespace halfspace::model {

// Numbers of buffers: the D-buffer, which takes what several passes come to; S-buffer k; the S-buffers merged.
constexpr int kDynamicBuffer = 0, kStaticBuffers = 1, kMostBuffers = 16;
constexpr int static_buffer_number(int k) { return kStaticBuffers + k; }
constexpr int still_buffer_number(int buffers) { return kStaticBuffers + buffers; }

// StaticCommand as plain numbers.
struct RawCommand {
  bool merges = false, sends = true;
  bool passes = false, anew = false, shows = false;
  int stored = 0, drawn = 0, kept = 0;
  ref::Box box;  // in pixels: the stamps that it meets are those of the run; not empty
  std::uint32_t first = 1, last = 0;
  std::array<std::uint8_t, 3> background{};
};

struct StaticRunResult {
  std::vector<RawEntry> shown;  // of the frame, row by row; background outside the run; empty if nothing is shown
  std::uint64_t count = 0;      // as MergeResult
};

class StaticRuns {
 public:
  // Of frames of one size. `lanes` is 1, 2, 4, 8 or 16. Throws ref::Error without objects.
  StaticRuns(const Configuration&, int lanes, int width, int height);
  ~StaticRuns();

  // `pass`: with `passes`, what hs_pipeline drew. The words of the streams go to `streams`, unless it is null.
  StaticRunResult run(const RawCommand&, const std::vector<RawEntry>* pass,
                      std::vector<StreamWords>* streams = nullptr);
  // Of these streams, in flow order.
  std::vector<Layout> layouts() const;

  class Machine;

 private:
  std::unique_ptr<Machine> machine_;
};

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_PIPELINE_STATIC_RUNS_HPP_
