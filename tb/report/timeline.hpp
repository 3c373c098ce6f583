// SPDX-License-Identifier: Apache-2.0
// What each stream does over time: a word moves, the taker waits for a word, or a word waits for the taker.
#ifndef HALFSPACE_TB_REPORT_TIMELINE_HPP_
#define HALFSPACE_TB_REPORT_TIMELINE_HPP_

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace halfspace::tb {

class Timeline {
 public:
  using Counts = std::array<std::uint32_t, 3>;  // cycles: moved, waited for the sender, waited for the taker
  struct Row {
    std::string stream;
    std::vector<Counts> buckets;
  };

  void add(const std::string& stream) { rows_.push_back({stream, {}}); }
  // A cycle: begin(), and then a state of each row, in their order.
  void begin(std::uint64_t cycle) {
    if (rows_.empty() || rows_[0].buckets.empty()) first_ = cycle;
    const std::uint64_t bucket = (cycle - first_) / step_;
    if (bucket >= kMost) halve();
    const std::size_t need = std::size_t((cycle - first_) / step_) + 1;
    for (Row& row : rows_) row.buckets.resize(need);
    at_ = 0;
  }
  void note(bool valid, bool ready) {
    Row& row = rows_[at_++];
    ++row.buckets.back()[!valid ? 1 : ready ? 0 : 2];
  }

  std::uint64_t first() const { return first_; }
  std::uint64_t step() const { return step_; }  // cycles of a bucket
  const std::vector<Row>& rows() const { return rows_; }

 private:
  static constexpr std::uint64_t kMost = 512;

  // Two buckets become one.
  void halve() {
    step_ *= 2;
    for (Row& row : rows_) {
      std::vector<Counts> halved((row.buckets.size() + 1) / 2);
      for (std::size_t n = 0; n < row.buckets.size(); ++n) {
        for (std::size_t c = 0; c < 3; ++c) halved[n / 2][c] += row.buckets[n][c];
      }
      row.buckets = std::move(halved);
    }
  }

  std::vector<Row> rows_;
  std::size_t at_ = 0;
  std::uint64_t first_ = 0, step_ = 1;
};

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_REPORT_TIMELINE_HPP_
