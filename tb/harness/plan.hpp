// SPDX-License-Identifier: Apache-2.0
// What the bench does with the ports of a unit: all that it has to know of it.
#ifndef HALFSPACE_TB_HARNESS_PLAN_HPP_
#define HALFSPACE_TB_HARNESS_PLAN_HPP_

#include <string>
#include <vector>

#include "tb/harness/memory.hpp"
#include "tb/harness/model.hpp"
#include "tb/harness/vectors.hpp"

namespace halfspace::tb {

// The memories of the units. TdbV and TdbS: a word a triangle.
inline const MemoryPorts kIndexBuffer{"read_index_i", "read_en_o",    "read_bank_o",     "read_address_o",
                                      "write_en_o",   "write_bank_o", "write_address_o", "write_index_o"};
inline const MemoryPorts kScannedIndexBuffer{"read_index_i", "read_en_o", nullptr,     "address_o",
                                             "write_en_o",   nullptr,     "address_o", nullptr};
inline const MemoryPorts kDepthBuffer{"read_depth_i", "read_en_o", nullptr,           "read_address_o",
                                      "write_en_o",   nullptr,     "write_address_o", "write_depth_o"};
inline const MemoryPorts kVisibilityDatabase{"fetch_plane_i", "fetch_en_o", nullptr,         "fetch_entry_o",
                                             "store_en_o",    nullptr,      "store_entry_o", "store_plane_o"};
inline const MemoryPorts kShadingDatabase{"read_planes_i", "read_en_o", "read_bank_o", "read_entry_o",
                                          nullptr,         nullptr,     nullptr,       nullptr};
// Of a film: a word a pixel of motion; a bit a lane; a word a block of pixels, two banks; a pixel.
inline const MemoryPorts kMotionBuffer{"read_motion_i", "read_en_o", nullptr,           "read_address_o",
                                       "write_en_o",    nullptr,     "write_address_o", "write_motion_o"};
inline const MemoryPorts kHoleMarks{"read_marks_i", "read_en_o", nullptr,     "address_o",
                                    "write_en_o",   nullptr,     "address_o", nullptr};
inline const MemoryPorts kKeyFrames{"read_block_i", "key_read_en_o", "key_read_bank_o", "key_read_address_o",
                                    nullptr,        nullptr,         nullptr,           nullptr};
inline const MemoryPorts kFilmBuffer{"read_film_i",     "film_read_en_o", nullptr,          "film_address_o",
                                     "film_write_en_o", nullptr,          "film_address_o", nullptr};
inline const MemoryPorts* const kMemories[] = {&kIndexBuffer,        &kScannedIndexBuffer, &kDepthBuffer,
                                               &kVisibilityDatabase, &kShadingDatabase,    &kMotionBuffer,
                                               &kHoleMarks,          &kKeyFrames,          &kFilmBuffer};

// Of index_pool, and of the pipeline that has one: whether a triangle found no index.
constexpr const char* kNoneLeft = "none_left_o";

struct Plan {
  struct End {
    const Stream* stream;
    std::string port;
  };
  std::vector<End> takes, sends;
  std::vector<End> loads;          // what it takes in any cycle, so that nothing else may be in flight: before a frame
  std::vector<End> registers;      // a word before a frame, which stays
  std::vector<const Port*> zeros;  // outputs of a stream that its configuration does not have
  const Stream* fills = nullptr;
  std::vector<const Stream*> keeps;  // of a film: what the passes before left in the memories that it reads

  std::vector<const Stream*> streams() const {
    std::vector<const Stream*> all;
    for (const auto* const list : {&takes, &sends, &loads, &registers}) {
      for (const End& end : *list) all.push_back(end.stream);
    }
    if (fills) all.push_back(fills);
    all.insert(all.end(), keeps.begin(), keeps.end());
    return all;
  }
};

// A port that nothing is known of, and a stream that the set lacks, are an Error.
Plan plan_of(const Model& model, const Vectors& vectors);

// ztest_index, of hs_ztest_index.
std::string unit_of(const Model& model);
const Stream& need_stream(const Vectors& vectors, const std::string& name);

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_HARNESS_PLAN_HPP_
