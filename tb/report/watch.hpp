// SPDX-License-Identifier: Apache-2.0
// What a bench looks at in each cycle beside the words: of the Z-test its accesses to memories, of index_pool its
// level.
#ifndef HALFSPACE_TB_REPORT_WATCH_HPP_
#define HALFSPACE_TB_REPORT_WATCH_HPP_

#include <cstdint>
#include <string>

#include "tb/harness/model.hpp"
#include "tb/harness/vectors.hpp"

namespace halfspace::tb {

// Each stamp is read once, behind the cycle that takes it: another read may be of the bank that the scan reads. A write
// is at the place of the stamp: a unit that reads and writes one wrong place finds again what it wrote. TdbV is written
// once a triangle, with the first pixel that is nearer.
class ZtestWatch {
 public:
  ZtestWatch(const Model& model, const Vectors& vectors);
  std::string wrong();

 private:
  const Port &stamp_valid_, &stamp_ready_, &read_, &visible_, &updates_, &update_, &address_;
  const Port* store_;
  Field x_, y_;
  std::uint32_t stamps_x_;
  int unread_ = 0;
  bool stored_ = false;
};

// none_left_o is 1 behind a triangle that went without an index, and not before.
class NoneLeftWatch {
 public:
  // With index_pool in the model, or in a part of it.
  static bool fits(const Model& model, const Vectors& vectors);
  NoneLeftWatch(const Model& model, const Vectors& vectors);
  std::string wrong();

 private:
  const Port &none_left_, &valid_, &ready_, &word_;
  Field index_;
  bool had_none_ = false;
};

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_REPORT_WATCH_HPP_
