// SPDX-License-Identifier: Apache-2.0
// A memory behind the AXI4 port of hs_system, and the rules of its channels.
#ifndef HALFSPACE_TB_SYSTEM_MEMORY_HPP_
#define HALFSPACE_TB_SYSTEM_MEMORY_HPP_

#include <cstdint>
#include <cstdlib>
#include <deque>
#include <memory>
#include <vector>

#include "tb/harness/stall.hpp"
#include "tb/system/partner.hpp"

namespace halfspace::tb {

// Zeros that take no memory until they are written.
class Bytes {
 public:
  explicit Bytes(std::size_t size) : size_(size), data_(static_cast<std::uint8_t*>(std::calloc(size, 1)), &std::free) {}
  std::size_t size() const { return size_; }
  std::uint8_t* data() { return data_.get(); }
  std::uint8_t& operator[](std::size_t at) { return data_.get()[at]; }

 private:
  std::size_t size_;
  std::unique_ptr<std::uint8_t, decltype(&std::free)> data_;
};

struct MemoryTiming {
  int latency = 40;     // cycles from an address to its first word, and from a last word to the answer
  int stall = 0;        // percent of the cycles in which a channel waits; with some, ids overtake each other
  bool refresh = true;  // 32 cycles of 1024 without a word
  std::uint64_t seed = 1;
};

// A word of data a cycle moves, read or written. What is written is in memory when it is answered, not before. What is
// read is there when its word goes out; with odd seeds when the address is taken.
class AxiMemory : public Partner {
 public:
  AxiMemory(const Model& model, Bytes* bytes, const MemoryTiming& timing);
  void drive() override;
  void sample() override;

  // The burst with this number, from 1 on, is answered with an error; of reads, or of writes. 0: none.
  void break_read(std::uint64_t number) { broken_read_ = number; }
  void break_write(std::uint64_t number) { broken_write_ = number; }
  std::uint64_t read_bursts() const { return read_bursts_; }
  std::uint64_t write_bursts() const { return write_bursts_; }
  // Nothing is under way.
  bool idle() const { return reads_.empty() && writes_.empty() && answers_.empty(); }

 private:
  struct Burst {
    std::uint32_t id = 0, address = 0, beats = 0;
    bool broken = false;
    std::uint64_t ready = 0;  // the cycle of its first word or its answer
    std::size_t read = 0;     // bytes of `data`
    std::vector<std::uint8_t> data, strobes;
  };

  std::string check_burst(const char* channel, std::uint64_t address, std::uint64_t beats, std::uint64_t size,
                          std::uint64_t burst) const;
  void offer_read();
  void offer_answer();
  bool open();
  bool is_early() const { return timing_.seed % 2 == 1; }
  std::uint8_t byte_at(std::size_t at);
  std::size_t oldest_of_an_id(const std::deque<Burst>& bursts);

  const Model& model_;
  Bytes* bytes_;
  MemoryTiming timing_;
  Offered read_address_, write_address_, write_data_;
  const Port &arready_, &arid_, &araddr_, &arlen_, &arsize_, &arburst_;
  const Port &rvalid_, &rready_, &rid_, &rdata_, &rresp_, &rlast_;
  const Port &awready_, &awid_, &awaddr_, &awlen_, &awsize_, &awburst_;
  const Port &wvalid_, &wready_, &wdata_, &wstrb_, &wlast_;
  const Port &bvalid_, &bready_, &bid_, &bresp_;
  Stall ar_stall_, r_stall_, aw_stall_, w_stall_, b_stall_;
  Random order_;
  std::uint64_t cycle_ = 0, read_bursts_ = 0, write_bursts_ = 0, broken_read_ = 0, broken_write_ = 0;
  std::deque<Burst> reads_, writes_, answers_;
  std::size_t reading_ = 0;  // of reads_, whose word is offered
  std::size_t answering_ = 0;
  bool wrote_last_ = false, words_wait_ = false, read_moved_ = false, answer_moved_ = false;
};

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_SYSTEM_MEMORY_HPP_
