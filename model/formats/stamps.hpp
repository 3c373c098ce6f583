// SPDX-License-Identifier: Apache-2.0
// From a number of lanes to the stamp that has them.
#ifndef HALFSPACE_MODEL_FORMATS_STAMPS_HPP_
#define HALFSPACE_MODEL_FORMATS_STAMPS_HPP_

#include <string>

#include "hls/formats/formats.hpp"
#include "ref/error.hpp"

namespace halfspace::model {

// make(stamp) for the stamp of this many lanes. Throws ref::Error if there is none.
template <class Result, class Make>
Result with_stamp(int lanes, Make make) {
  switch (lanes) {
    case 1: return make(Stamp1());
    case 2: return make(Stamp2());
    case 4: return make(Stamp4());
    case 8: return make(Stamp8());
    case 16: return make(Stamp16());
  }
  throw ref::Error("there is no stamp of " + std::to_string(lanes) + " lanes: use 1, 2, 4, 8 or 16");
}

// A stamp, in pixels. Throws ref::Error for a number of lanes that none has.
struct StampSize {
  int x, y;
};
inline StampSize stamp_size(int lanes) {
  return with_stamp<StampSize>(lanes, [](auto stamp) { return StampSize{stamp.kX, stamp.kY}; });
}

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_FORMATS_STAMPS_HPP_
