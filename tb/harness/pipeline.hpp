// SPDX-License-Identifier: Apache-2.0
// The co-simulation of hs_pipeline: triangles in, every stream held against the vectors.
#ifndef HALFSPACE_TB_HARNESS_PIPELINE_HPP_
#define HALFSPACE_TB_HARNESS_PIPELINE_HPP_

#include <map>
#include <string>

#include "tb/harness/bench.hpp"

namespace halfspace::tb {

// What the RTL sent for the last frame, to make pictures from.
struct LastFrame {
  Words pixel;                           // of motion where there are no pixels
  std::map<std::string, Words> counted;  // by stream, those of count_rates; scan among them
};

// What is loaded before a frame, and what geometry answers to `visible`.
bool is_loaded(const Stream& stream);
bool is_answer(const Stream& stream);
// Whether one frame may follow the other without a pause: registers and what is loaded are the same.
bool may_follow(const Vectors& vectors, std::size_t a, std::size_t b);
// After reset the pipeline clears its I-buffer, in the smallest stamps two million words a bank.
constexpr std::uint64_t kResetPatience = 10'000'000;
// Cycles of a shader that takes a pixel after the other, `turns` of each, and of background one of a stamp: for the
// words of frames [first, end) of `scan`, or of `masked`.
std::uint64_t serial_pixels(const Stream& scan, std::size_t first, std::size_t end, std::uint64_t turns);
// Of frames [first, end).
Bound bound_of(const Vectors& vectors, const Model& model, int setup_interval, std::size_t first, std::size_t end);

// Leaves the model in the midst of its first frame. Geometry has not answered; whatever comes out is taken and not
// looked at.
void run_part(Model* model, const Vectors& vectors, const Options& options);

// Frames of equal registers follow each other at once; before others the pipeline runs empty (busy_o).
Result run_pipeline(Model* model, const Vectors& vectors, const Options& options, LastFrame* last);

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_HARNESS_PIPELINE_HPP_
