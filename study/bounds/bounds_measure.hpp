// SPDX-License-Identifier: Apache-2.0
// Measures the kernels against exact arithmetic, into the rows of a report.
#ifndef HALFSPACE_STUDY_BOUNDS_BOUNDS_MEASURE_HPP_
#define HALFSPACE_STUDY_BOUNDS_BOUNDS_MEASURE_HPP_

#include <memory>

#include "study/bounds/bounds.hpp"
#include "study/bounds/bounds_exact.hpp"
#include "study/bounds/bounds_probe.hpp"
#include "study/proofs/bounds_proved.hpp"

namespace halfspace::model {

// ztest_index and scan_index on frames of random triangles, against buffers of its own.
void measure_frames(const Configuration& configuration, std::uint64_t seed, BoundsReport& report);
// ztest_merge on random entries, against keys of 64 bits.
void measure_merges(const Configuration& configuration, std::uint64_t seed, BoundsReport& report);

// Of what a plane's register holds at a pixel without its ½, in LSB.
double plane_error(const PlaneNumbers& numbers, const ExactTriangle& exact, const Values& values,
                   const ProbedPlane& plane, int x, int y);

// All other kernels, a triangle at a time.
class TriangleMeter {
 public:
  TriangleMeter(const Config& config, BoundsReport& report);

  // What follows belongs to a class of this name, in a frame of this size.
  void begin(const std::string& class_name, int width, int height);
  // Setup, every covered pixel, and the coverage of every row.
  void measure(const ref::SnappedTriangle& triangle);
  // Climbs from farthest triangles to the largest error of a channel at the last pixel of the frame, `steps` triangles
  // tried, and measures the worst ones on the way.
  void search(TriangleSource& source, Vertices vertices, bool depth, int steps);

 private:
  // The rows of a channel.
  struct Channel {
    PlaneNumbers numbers;
    Quantity gradient, plane, plane_in_frame, steps, rounded;
  };
  // A channel of a triangle: what its plane is, and what it should be.
  struct Attribute {
    const Channel& channel;
    const ExactTriangle& exact;
    const Values& values;
    const ProbedPlane& plane;
  };

  void measure_setup(const ExactTriangle& exact, const ProbedSetup& setup);
  void measure_gradients(const Attribute& attribute, const ProbedSetup& setup);
  void measure_pixel(const Attribute& attribute, std::uint32_t sent, int x, int y);
  void measure_coverage(const ExactTriangle& exact, const std::vector<ProbedPixel>& pixels);
  Witness place(int x = -1, int y = -1) const;

  Config config_;
  BoundsReport& report_;
  std::unique_ptr<KernelProbe> probe_;
  Channel depth_, colour_;
  int width_ = 0, height_ = 0;       // of the frame
  ref::SnappedTriangle triangle_{};  // that is measured
  bool in_frame_ = false;            // its vertices, in the largest frame
};

}  // namespace halfspace::model

#endif  // HALFSPACE_STUDY_BOUNDS_BOUNDS_MEASURE_HPP_
