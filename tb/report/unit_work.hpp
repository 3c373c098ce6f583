// SPDX-License-Identifier: Apache-2.0
// The cycles that a unit may take for a frame, by its interval (docs/cycles.md) and the words that come and go.
#ifndef HALFSPACE_TB_REPORT_UNIT_WORK_HPP_
#define HALFSPACE_TB_REPORT_UNIT_WORK_HPP_

#include <cstddef>
#include <cstdint>
#include <string>

#include "tb/harness/model.hpp"
#include "tb/harness/vectors.hpp"

namespace halfspace::tb {

// A unit is a row of stages, each of which takes its interval for a word and waits for the one before it and for room
// in the one behind it. So a frame that nothing keeps waiting takes the intervals of its words one after the other, and
// once the way of a word through all stages. A cycle in which an end of a stream makes the unit wait puts every later
// word off by one cycle at most, so that with stalls it is those cycles more.
struct UnitWork {
  std::uint64_t intervals = 0;  // of the words of the frame
  std::uint64_t latency = 0;    // from the first word in to the last word out, the intervals not counted
  std::uint64_t restart = 0;    // for a word that comes late, besides the cycles that it is late
  bool known = false;           // the set tells what it takes
};

// The streams of the unit are loaded. `cycle`: from the reset to the first word.
UnitWork unit_work(const Model& model, const Vectors& vectors, std::size_t frame, std::uint64_t cycle);

// Until now: cycles, those in which an end of a stream made the unit wait, and words that came late.
struct Waits {
  std::uint64_t cycle = 0, stalled = 0, late = 0;
};

// What a unit was sent since it was idle, and what that may take.
class DueWork {
 public:
  // `follows`: all frames are sent at once, so that one latency is all.
  void add(std::size_t frame, const UnitWork& work, bool follows, const Waits& now);
  // All is through: why that took too long, or "".
  std::string slow(const Waits& now);

 private:
  std::size_t frames_ = 0, first_ = 0;
  UnitWork work_;
  Waits from_;
};

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_REPORT_UNIT_WORK_HPP_
