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

// What a key pixel of several samples keeps, where they show more than one face.
enum class KeyFaces {
  kPure,  // nothing: no one knows which share of its colour is whose
  kMost,  // the face that most of them show, and their own mean
  kTwo,   // and of the face that comes next, which is asked for what no key shows by the first
};
constexpr KeyFaces kKeyFaces[] = {KeyFaces::kPure, KeyFaces::kMost, KeyFaces::kTwo};
const char* name_of(KeyFaces);  // "pure", …

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
  KeyFaces key_faces = KeyFaces::kTwo;  // of a vector a sample; else pixels go by what they show in their middle
  // Pixels of a key frame for one of a frame, each way: divides the samples, or is a multiple of them. Keys that are
  // finer than the samples are drawn for themselves. 1 unless there is a vector a sample.
  int key_scale = 1;
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
  const Colours& key_colour(int k) const { return key_colours_[k]; }  // the frame as it is shown
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
  std::optional<OfKeys<KeyFrame>> second_;
  OfKeys<Colours> key_colours_;
};

// What up-conversion is compared with: the mean of both keys, and the nearer one, of two as near the first.
Colours temporal_average(const Colours& first, const Colours& second);
const Colours& repeated(const Colours& first, const Colours& second, double a);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_MOTION_UP_CONVERT_HPP_
