// SPDX-License-Identifier: Apache-2.0
// The frames of a vector set as a program has them: triangles, answers, records to load; and the pictures.
#ifndef HALFSPACE_TB_SYSTEM_SCENE_HPP_
#define HALFSPACE_TB_SYSTEM_SCENE_HPP_

#include <vector>

#include "driver/halfspace.h"
#include "tb/harness/channel.hpp"
#include "tb/system/ports.hpp"

namespace halfspace::tb {

// Whether hs_system draws the frame as the set has it: the indices of its triangles are their places.
bool is_in_order(const Vectors& vectors, std::size_t frame);
// None of a frame that has no triangle.
std::vector<hs_triangle> triangles_of(const Vectors& vectors, std::size_t frame);
// One for each triangle; of those that are not visible zeros.
std::vector<hs_answer> answers_of(const Vectors& vectors, std::size_t frame);
// A stream that is loaded, its fields one after the other, and their widths.
std::vector<std::uint64_t> values_of(const Stream& stream, std::size_t frame, std::vector<std::uint8_t>* widths);
Picture picture_of(const Vectors& vectors, std::size_t frame);

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_SYSTEM_SCENE_HPP_
