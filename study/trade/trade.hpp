// SPDX-License-Identifier: Apache-2.0
// What a configuration gives for what it takes: accuracy against the ideal picture (ref/raster/ideal.hpp) and the
// reference, cycles and traffic of the RTL.
#ifndef HALFSPACE_STUDY_TRADE_TRADE_HPP_
#define HALFSPACE_STUDY_TRADE_TRADE_HPP_

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "model/formats/configuration.hpp"
#include "model/pipeline/accesses.hpp"
#include "model/pipeline/cycles.hpp"
#include "ref/raster/ideal.hpp"
#include "ref/raster/raster.hpp"
#include "study/trade/accuracy.hpp"
#include "study/trade/subject.hpp"

namespace halfspace::model {

// How far a frame is from the ideal picture.
struct PictureError {
  std::uint64_t pixels = 0;
  std::uint64_t covered_differ = 0;  // one shows a triangle, the other the background
  std::uint64_t index_differ = 0;    // they show different faces of the scene
  // Where both show the same face:
  std::uint64_t compared = 0;
  double colour_largest = 0, colour_rms = 0;  // of a channel, LSB of 8 bits
  double depth_largest = 0, depth_rms = 0;    // LSB of the stored depth; 0 without one
  // Of all channels of the whole frame, dB against 255; infinite when equal. Rounding to 8 bits alone gives 58.9 dB,
  // more where the background is seen.
  double psnr = 0;
};
// `list` is what the frame was drawn from.
PictureError picture_error(const ref::IdealFrame& ideal, const ref::TriangleList& list, const ref::Frame& frame,
                           int depth_bits);

// Of stored values against those that the reference has before rounding, on the same snapped triangles, where both show
// the same triangle: ½ where everything is rounded to the nearest.
struct StoredError {
  double depth_largest = 0;                    // LSB of the stored depth; 0 without one
  std::optional<double> colour_largest = 0.0;  // of a channel, LSB of 8 bits; none where the reference has none
};
StoredError stored_error(const ref::Frame& reference, const ref::Frame& kernels, int depth_bits);

// Shimmer: what changes from frame to frame of a slow pan and does not in the ideal. The picture is moved by kPanX to
// the right and kPanY down a frame, primes apart from every grid of sub-pixels, so that no vertex keeps its place on
// it: an edge whose snapped ends creep and jump does so differently in every frame. With e_k the frame less its ideal,
//   rms = RMS of e_k − e_(k−1) over k, pixels and channels, LSB of 8 bits.
// An error that stands still in the picture does not count, a pixel that is wrong in one frame alone counts twice.
struct Shimmer {
  double rms = 0;
  double pixels = 0;  // a frame: that show a wrong face now and not before, or before and not now
};
constexpr double kPanX = 1.0 / 17, kPanY = 1.0 / 19;  // pixels a frame
constexpr int kPanFrames = 17;

class ShimmerMeter {
 public:
  void add(const ref::IdealFrame& ideal, const ref::TriangleList& list, const ref::Frame& frame);
  // Of two frames or more.
  Shimmer result() const;

 private:
  std::vector<std::array<float, 3>> error_;
  std::vector<bool> wrong_;
  std::uint64_t frames_ = 0;
  double squares_ = 0;
  std::uint64_t changes_ = 0;
};

struct Trade {
  std::size_t triangles = 0;
  PictureError ideal;
  Accuracy reference;  // snapped as well
  StoredError stored;
  Shimmer shimmer;
  UnitIntervals intervals;
  Cycles cycles;
  Accesses accesses;
  std::uint64_t texture_bytes = 0;  // read and written a frame beside those: texels, and planes of coordinates
  bool compiled = false;            // the kernels, and not read at run time
  double native_ms = 0;             // a frame by the kernels, on one thread of this machine, the median of five
};

// Bytes that texture reads and writes a frame that came out so: texels, and planes of coordinates.
std::uint64_t texture_bytes(const Config&, const TextureFrame&, const ref::Frame&);

// A scene as the geometry hands it to a view.
using Projection = std::function<ref::TriangleList(const ref::View&)>;

// Against the ideal picture by `look`. Throws ref::Error when the subject does not fit.
Trade measure_trade(const Subject&, int width, int height, const Configuration&, int lanes, const ref::IdealLook& look);

}  // namespace halfspace::model

#endif  // HALFSPACE_STUDY_TRADE_TRADE_HPP_
