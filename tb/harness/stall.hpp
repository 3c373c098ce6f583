// SPDX-License-Identifier: Apache-2.0
// When a stream's partner is not ready: at random, in phases, so that queues run full, run empty and flow freely.
#ifndef HALFSPACE_TB_HARNESS_STALL_HPP_
#define HALFSPACE_TB_HARNESS_STALL_HPP_

#include <algorithm>
#include <cstdint>
#include <string>

namespace halfspace::tb {

// splitmix64: small, and the same everywhere.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint32_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return std::uint32_t((z ^ (z >> 31)) >> 32);
  }

 private:
  std::uint64_t state_;
};

// The same seed gives each name its own sequence, whatever other streams there are.
inline std::uint64_t seed_of(std::uint64_t seed, const std::string& name) {
  std::uint64_t hash = 0xcbf29ce484222325u ^ (seed * 0x9e3779b97f4a7c15u);
  for (const char c : name) hash = (hash ^ std::uint8_t(c)) * 0x100000001b3u;
  return hash;
}

class Stall {
 public:
  Stall(std::uint64_t seed, int percent) : random_(seed), percent_(percent) {}

  // Whether this cycle is a stall: `percent` of the cycles in the long run.
  bool next() {
    if (percent_ == 0) return false;
    if (left_-- == 0) start_phase();
    return random_.next() % 100 < std::uint32_t(rate_);
  }

  // Of a receiver: whether ready waits for valid in this phase. The contract allows it, and a unit whose valid waits
  // for ready hangs on it.
  bool shy() const { return shy_; }

 private:
  void start_phase() {
    left_ = int(16 + random_.next() % 256);
    const int heavy = std::min(95, 2 * percent_);
    const int rates[4] = {0, percent_, percent_, heavy};
    rate_ = rates[random_.next() % 4];
    shy_ = random_.next() % 8 == 0;
  }

  Random random_;
  int percent_, rate_ = 0, left_ = 0;
  bool shy_ = false;
};

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_HARNESS_STALL_HPP_
