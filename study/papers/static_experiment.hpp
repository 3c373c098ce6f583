// SPDX-License-Identifier: Apache-2.0
// The experiment of the static objects buffer: a crowd of which few move, by four methods side by side.
#ifndef HALFSPACE_STUDY_PAPERS_STATIC_EXPERIMENT_HPP_
#define HALFSPACE_STUDY_PAPERS_STATIC_EXPERIMENT_HPP_

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "ref/builtin/crowd.hpp"
#include "ref/objects/static_objects.hpp"

namespace halfspace::model {

// Of numbers that come one a frame.
class Spread {
 public:
  void add(double value);
  std::uint64_t count() const { return count_; }
  double mean() const { return mean_; }
  double deviation() const;  // standard, over all frames
  double largest() const { return largest_; }

 private:
  std::uint64_t count_ = 0;
  double mean_ = 0, squares_ = 0, largest_ = 0;
};

struct StaticExperimentOptions {
  ref::CrowdOptions crowd;
  std::string config = "middle";
  int lanes = 4, width = 640, height = 480;
  int buffers = 7;      // of the last method
  int frames = 150;     // of each number of moving objects, after one that is not counted
  int full_frames = 2;  // of those, at the end, that are drawn as a whole as well, and compared
  std::vector<int> moving{10, 40, 80, 120};
};

enum class StaticMethod { kAll, kNoQuery, kQuery, kQueryMany };
constexpr std::size_t kStaticMethods = 4;

// The frames of one method with one number of moving objects.
struct MethodFrames {
  Spread drawn, redrawn;                  // objects
  Spread triangles;                       // of them, handed to the rasterizer
  Spread cycles;                          // by the model of the RTL
  Spread milliseconds;                    // of one thread, as the processor counts them, in the reference
  std::uint64_t starts = 0, updates = 0;  // objects that began to move, and for which an S-buffer was drawn again
};

struct StaticStep {
  int moving;
  std::array<MethodFrames, kStaticMethods> methods;  // in the order of StaticMethod
};

struct StaticExperiment {
  std::uint64_t triangles = 0;                         // of all objects
  std::uint64_t handed = 0;                            // of them, that face the viewer, in the first frame
  std::array<double, kStaticMethods> first_seconds{};  // of the first frame, which draws all objects
  std::uint64_t compared = 0;  // pixels of the methods, found equal to those of drawing everything
  std::vector<StaticStep> steps;
  ref::ObjectBuffer picture{1, 1, 1};  // the last
};

// phase, done, total
using ExperimentProgress = std::function<void(const char* phase, std::size_t done, std::size_t total)>;

// Throws ref::Error when a picture differs from that of drawing everything.
//
// Cycles of a frame: the slowest of triangle setup and shade setup, over the objects drawn, and ztest_merge, without
// waits. The last takes a stamp a cycle: the frame; a frame more for each S-buffer that objects are drawn into, as a
// pass ends with a scan of it; the box of each object that is asked for or erased; and what is merged anew of all
// S-buffers. The rasterizer takes fewer than the setup: of triangles of a pixel about one stamp each.
StaticExperiment run_static_experiment(const StaticExperimentOptions&, const ExperimentProgress&);

}  // namespace halfspace::model

#endif  // HALFSPACE_STUDY_PAPERS_STATIC_EXPERIMENT_HPP_
