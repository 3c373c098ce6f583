// SPDX-License-Identifier: Apache-2.0
// Which index a triangle has, where those of invisible triangles are used again (index rendering).
#ifndef HALFSPACE_REF_RASTER_INDEX_POOL_HPP_
#define HALFSPACE_REF_RASTER_INDEX_POOL_HPP_

#include <fmt/format.h>

#include <cstdint>
#include <deque>
#include <utility>

#include "ref/error.hpp"

namespace halfspace::ref {

// Indices: triangle n takes the one of triangle n − window if that turned out invisible, else a new one. So a
// triangle's result may take `window` triangles to arrive, no list of free indices is kept, and as many indices are
// used as triangles passed the test, and `window` more at most. 0: no index is used twice.
struct IndexReuse {
  std::uint32_t window = 0;
  std::uint32_t largest = 0xffffffff;  // index value
};

// Gives each triangle of a frame its index.
class IndexPool {
 public:
  explicit IndexPool(const IndexReuse& rule) : rule_(rule) {}

  // Whether there is one for the next triangle.
  bool has_one() const {
    const bool full = rule_.window != 0 && in_flight_.size() == rule_.window;
    return (full && in_flight_.front().first != 0 && !in_flight_.front().second) || used_ != rule_.largest;
  }
  std::uint32_t take() {
    if (!has_one()) {
      throw Error(fmt::format("more than {} triangles are visible at once: take a configuration with more index bits",
                              rule_.largest));
    }
    return take_or_none();
  }
  // 0: there is none. Its triangle must not be drawn.
  std::uint32_t take_or_none() {
    std::uint32_t index = 0;
    if (rule_.window != 0 && in_flight_.size() == rule_.window) {
      const auto [earlier, visible] = in_flight_.front();
      in_flight_.pop_front();
      if (!visible) index = earlier;
    }
    if (index == 0 && used_ != rule_.largest) index = ++used_;
    return index;
  }
  void done(std::uint32_t index, bool visible) {
    if (rule_.window != 0) in_flight_.emplace_back(index, visible);
  }
  std::uint32_t largest() const { return used_; }

 private:
  const IndexReuse rule_;
  std::uint32_t used_ = 0;
  std::deque<std::pair<std::uint32_t, bool>> in_flight_;
};

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_RASTER_INDEX_POOL_HPP_
