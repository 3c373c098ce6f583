// SPDX-License-Identifier: Apache-2.0
// Frame-rate up-conversion: key frames are drawn, the frames between them made of these.
#ifndef HALFSPACE_REF_MOTION_UP_CONVERT_HPP_
#define HALFSPACE_REF_MOTION_UP_CONVERT_HPP_

#include <memory>
#include <optional>

#include "ref/motion/drawn_frame.hpp"
#include "ref/motion/relight.hpp"

namespace halfspace::ref {

enum class FieldSize {
  kHalf,     // a vector for 2 × 2 pixels
  kPixels,   // a vector a pixel
  kSamples,  // a vector a sample of the frames, which are averaged after compensation
};

struct UpConversion {
  int width, height;    // of a frame; even for half a field
  RasterFormat format;  // what is drawn fits it; its own size counts for nothing
  int samples = 1;      // each way, that a pixel of a frame is the mean of
  ShadingMode shading = ShadingMode::kGouraud;
  std::optional<TextureMode> texture = std::nullopt;
  MotionMethod method = MotionMethod::kExact;
  VectorMapping mapping = VectorMapping::kLinear;
  CompensationMode compensation = {};
  FieldSize field = FieldSize::kSamples;
  bool surfaces = false;  // identity is the surface, not the face
  bool relight = false;   // of exact motion alone
  // What stands still between the keys is as it is rendered, and has no part in the field. Of exact motion, and a
  // vector a sample.
  bool static_buffer = false;
};

struct FrameBetween {
  Colours rendered;           // as it is without up-conversion
  Colours colour;             // compensated; what no key shows is rendered
  Shares shares;              // of pixels of the field
  std::vector<bool> of_keys;  // pixels of the picture, as made_of_keys has them
};

// Two key frames and what lies between them.
class Interval {
 public:
  Interval(const Scene& first, const Scene& second, const UpConversion&);
  Interval(const Interval&) = delete;

  const KeyFrame& key(int k) const { return keys_[k]; }
  // `between` is the scene at a of the way from the first key to the second. Error where `follow` has one.
  FrameBetween at(const Scene& between, double a);

 private:
  // Takes what stands still out of the field; how many pixels show it.
  std::uint64_t leave_out_static(const Scene& between, MotionField&) const;
  // At one resolution.
  struct Drawn {
    View view;
    RasterFormat format;
    OfKeys<std::unique_ptr<Geometry>> keys;
  };
  Drawn drawn(int width, int height) const;

  const OfKeys<Scene> scenes_;
  const UpConversion mode_;
  const Identities identities_;
  Drawn frames_, field_;
  OfKeys<KeyFrame> keys_;
};

// What up-conversion is compared with: the mean of both keys, and the nearer one, of two as near the first.
Colours temporal_average(const Colours& first, const Colours& second);
const Colours& repeated(const Colours& first, const Colours& second, double a);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_MOTION_UP_CONVERT_HPP_
