// SPDX-License-Identifier: Apache-2.0
// What a configuration of motion gives for what it takes: frames between key frames, held against the same frames of
// the reference, as it renders them and as it makes them of the keys.
#ifndef HALFSPACE_STUDY_TRADE_MOTION_TRADE_HPP_
#define HALFSPACE_STUDY_TRADE_MOTION_TRADE_HPP_

#include <cstdint>
#include <functional>
#include <vector>

#include "model/formats/configuration.hpp"
#include "ref/motion/compensate.hpp"
#include "ref/motion/up_convert.hpp"
#include "ref/scene/scene.hpp"

namespace halfspace::model {

// Of a pixel that the kernels take from elsewhere than the reference, LSB of 8 bits of a channel and more.
constexpr int kWrongLsb = 16;

// Of all frames in between; psnr and reference_psnr are those of all their channels together, dB, infinite when equal.
struct MotionTrade {
  int frames = 0;                   // in between
  double psnr = 0, worst_psnr = 0;  // against the frames as the reference renders them; of the worst of them
  double reference_psnr = 0, worst_reference_psnr = 0;  // against the reference's frames in between, nothing rounded
  // Likewise: pixels off by more than kWrongLsb, of the frame that has the most; and the largest error elsewhere.
  std::uint64_t wrong_pixels = 0;
  int colour_largest = 0;
  ref::Shares shares;                           // of pixels of the field
  std::uint64_t cycles = 0;                     // of motion_compensate, of the slowest frame
  std::uint64_t key_bytes = 0, word_bytes = 0;  // read a frame, the mean: of key frames, of motion words
};

struct MotionInput {
  std::function<ref::Scene(double)> at;  // seconds
  double rate = 30;                      // frames a second
  int first = 0, last = 2;               // frames of the animation, both included
  int between = 1;                       // frames made for each key
  int width = 320, height = 240;
};

// The frames in between as the reference makes them, with the triangles and the features of a configuration.
std::vector<ref::FrameBetween> motion_reference(const MotionInput&, const Configuration& motion);

// `motion` is a configuration with motion; its key frames are drawn by colour_configuration() of it. Throws ref::Error.
// `reference`, unless it is null, takes the place of that of the configuration's own features.
MotionTrade measure_motion(const MotionInput&, const Configuration& motion, int lanes,
                           const std::vector<ref::FrameBetween>* reference = nullptr);

// Bits of two key frames, of which a pixel of several samples has two faces.
std::uint64_t key_frame_bits(const Config& motion);

}  // namespace halfspace::model

#endif  // HALFSPACE_STUDY_TRADE_MOTION_TRADE_HPP_
