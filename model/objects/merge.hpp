// SPDX-License-Identifier: Apache-2.0
// ztest_merge as a driver sees it, for any configuration with objects: buffers of the size of a frame, and runs over a
// box of them.
#ifndef HALFSPACE_MODEL_OBJECTS_MERGE_HPP_
#define HALFSPACE_MODEL_OBJECTS_MERGE_HPP_

#include <array>
#include <cstdint>
#include <vector>

#include "hls/formats/formats.hpp"
#include "model/formats/configuration.hpp"
#include "model/formats/layout.hpp"
#include "model/objects/object_words.hpp"
#include "ref/objects/object_buffer.hpp"

namespace halfspace::model {

// Buffers are row by row, width × height.
struct MergeInput {
  int width = 0, height = 0;
  ref::Box box;  // in pixels: the stamps that it meets are those of the run; not empty
  const std::vector<RawEntry>* stored = nullptr;
  const std::vector<RawEntry>* drawn = nullptr;  // merged with it, unless null
  bool sends = true;                             // else nothing is made of it, and objects are only looked for
  std::uint32_t first = 1, last = 0;             // objects that are looked for, and erased
  std::array<std::uint8_t, 3> background{};
};

struct MergeResult {
  std::vector<RawEntry> merged;  // as stored outside the stamps of the run; empty if nothing is sent
  std::uint64_t count = 0;       // pixels of the run's stamps that showed an object of the range
  ref::Box box;                  // of the stamps that have one, in pixels of the frame
  std::uint64_t cycles = 0;      // of hs_ztest_merge, where nothing makes it wait, to its next run
};

class Merger {
 public:
  // `lanes` is 1, 2, 4, 8 or 16. Throws ref::Error without objects.
  Merger(const Configuration& configuration, int lanes);
  // `table` may differ from the one that follows from the configuration.
  Merger(const Configuration& configuration, const FormatTable& table, int lanes);

  // Throws ref::Error for what does not fit the configuration.
  MergeResult run(const MergeInput& input) const;
  // The words of its streams as well, in flow order.
  MergeResult capture(const MergeInput& input, std::vector<StreamWords>& streams) const;
  // Of those streams.
  std::vector<Layout> layouts() const;

 private:
  MergeResult run(const MergeInput& input, std::vector<StreamWords>* streams) const;

  Configuration configuration_;
  FormatTable table_;
  int lanes_;
};

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_OBJECTS_MERGE_HPP_
