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

// What a setup makes of the triangle that is measured, and where it is covered.
struct MeasuredTriangle {
  const ref::SnappedTriangle& triangle;
  const ExactTriangle& exact;
  const std::vector<ProbedPixel>& pixels;
  Witness place;  // but for the pixel

  Witness at(int x, int y) const {
    Witness out = place;
    out.x = x, out.y = y;
    return out;
  }
};

// Kernels of a feature, on words of their own for each triangle. The words depend on the triangle alone, so that a
// triangle has its errors again.
class FeatureMeter {
 public:
  virtual ~FeatureMeter() = default;
  virtual void measure(const MeasuredTriangle& measured) = 0;
  virtual void finish() {}  // after the last triangle
};
std::unique_ptr<FeatureMeter> make_texture_meter(const Config& config, KernelProbe& probe, BoundsReport& report);
std::unique_ptr<FeatureMeter> make_motion_meter(const Configuration& configuration, KernelProbe& probe,
                                                BoundsReport& report);
std::unique_ptr<FeatureMeter> make_surface_meter(const Config& config, KernelProbe& probe, BoundsReport& report);
// The words' seed.
std::uint64_t seed_of(const ref::SnappedTriangle& triangle);

// The channels that a configuration has planes of, apart from depth of those that colours are stretched to.
struct PlaneChannel {
  PlaneKind kind;
  PlaneNumbers numbers;
  Quantity gradient, plane, plane_in_frame, steps, rounded;
};
std::vector<PlaneChannel> plane_channels(const Config& config);

// All other kernels, a triangle at a time.
class TriangleMeter {
 public:
  TriangleMeter(const Configuration& configuration, BoundsReport& report);

  // What follows belongs to a class of this name, in a frame of this size.
  void begin(const std::string& class_name, int width, int height);
  // Setup, every covered pixel, and the coverage of every row.
  void measure(const ref::SnappedTriangle& triangle);
  // Climbs from farthest triangles to the largest error of a channel at the last pixel of the frame, `steps` triangles
  // tried, and measures the worst ones on the way.
  void search(TriangleSource& source, Vertices vertices, PlaneKind kind, int steps);
  void finish();

 private:
  // A channel of a triangle: what its plane is, and what it should be.
  struct Attribute {
    const PlaneChannel& channel;
    const ExactTriangle& exact;
    const Values& values;
    const ProbedPlane& plane;
  };

  void measure_setup(const ExactTriangle& exact, const ProbedSetup& setup);
  void measure_gradients(const Attribute& attribute, const ProbedSetup& setup);
  void measure_pixel(const Attribute& attribute, std::uint32_t sent, int x, int y);
  void measure_coverage(const ExactTriangle& exact, const std::vector<ProbedPixel>& pixels);
  // Of component c of a channel, which has `components(kind)` of them.
  int components(PlaneKind kind) const;
  Values values_of(const ExactTriangle& exact, const PlaneChannel& channel, int c) const;
  static const ProbedPlane& plane_of(const ProbedSetup& setup, PlaneKind kind, int c);
  static std::uint32_t sent_of(const ProbedPixel& pixel, PlaneKind kind, int c);
  Witness place(int x = -1, int y = -1) const;

  Config config_;
  BoundsReport& report_;
  std::unique_ptr<KernelProbe> probe_;
  std::vector<PlaneChannel> channels_;
  std::vector<std::unique_ptr<FeatureMeter>> features_;
  int width_ = 0, height_ = 0;       // of the frame
  ref::SnappedTriangle triangle_{};  // that is measured
  bool in_frame_ = false;            // its vertices, in the largest frame
};

// Units that have no triangle: the reciprocal of a coordinate, the filter of texels, the weights of a key frame's
// pixels and what is made of these.
void measure_inverse(const Config& config, KernelProbe& probe, BoundRow& row);
void measure_texels(const Config& config, KernelProbe& probe, std::uint64_t seed, BoundsReport& report);
void measure_compensation(const Configuration& configuration, std::uint64_t seed, BoundsReport& report);

}  // namespace halfspace::model

#endif  // HALFSPACE_STUDY_BOUNDS_BOUNDS_MEASURE_HPP_
