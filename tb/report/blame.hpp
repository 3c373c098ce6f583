// SPDX-License-Identifier: Apache-2.0
// Which unit a failure is of: what it sends is wrong first, and what units behind it send follows from that.
#ifndef HALFSPACE_TB_REPORT_BLAME_HPP_
#define HALFSPACE_TB_REPORT_BLAME_HPP_

#include "tb/harness/bench.hpp"

namespace halfspace::tb {

// Sorts the failures of the streams into `failures` and `follows`, and sets `first_wrong`.
//
// A unit that sends a wrong word is to blame unless one before it, along the streams, is; words that lack then follow.
// Where words only lack, it is the first unit that has its input and sends nothing: those before it cannot send, those
// behind it have nothing to take.
void blame(const Vectors& vectors, Result* result);

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_REPORT_BLAME_HPP_
