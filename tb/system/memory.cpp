// SPDX-License-Identifier: Apache-2.0
#include "tb/system/memory.hpp"

#include <algorithm>

namespace halfspace::tb {
namespace {

constexpr std::uint64_t kIncrement = 1, kSlaveError = 2;
constexpr std::size_t kAddresses = 64;  // bursts that the memory takes before it answers the first

void set_to(const Port& port, std::uint64_t value) { std::memcpy(port.data, &value, std::size_t(port.bytes)); }

}  // namespace

AxiMemory::AxiMemory(const Model& m, Bytes* bytes, const MemoryTiming& timing)
    : model_(m),
      bytes_(bytes),
      timing_(timing),
      read_address_(m, "the read address", "axi_arvalid_o", "axi_arready_i",
                    {"axi_arid_o", "axi_araddr_o", "axi_arlen_o", "axi_arsize_o", "axi_arburst_o"}),
      write_address_(m, "the write address", "axi_awvalid_o", "axi_awready_i",
                     {"axi_awid_o", "axi_awaddr_o", "axi_awlen_o", "axi_awsize_o", "axi_awburst_o"}),
      write_data_(m, "written data", "axi_wvalid_o", "axi_wready_i", {"axi_wdata_o", "axi_wstrb_o", "axi_wlast_o"}),
      arready_(m.need("axi_arready_i")),
      arid_(m.need("axi_arid_o")),
      araddr_(m.need("axi_araddr_o")),
      arlen_(m.need("axi_arlen_o")),
      arsize_(m.need("axi_arsize_o")),
      arburst_(m.need("axi_arburst_o")),
      rvalid_(m.need("axi_rvalid_i")),
      rready_(m.need("axi_rready_o")),
      rid_(m.need("axi_rid_i")),
      rdata_(m.need("axi_rdata_i")),
      rresp_(m.need("axi_rresp_i")),
      rlast_(m.need("axi_rlast_i")),
      awready_(m.need("axi_awready_i")),
      awid_(m.need("axi_awid_o")),
      awaddr_(m.need("axi_awaddr_o")),
      awlen_(m.need("axi_awlen_o")),
      awsize_(m.need("axi_awsize_o")),
      awburst_(m.need("axi_awburst_o")),
      wvalid_(m.need("axi_wvalid_o")),
      wready_(m.need("axi_wready_i")),
      wdata_(m.need("axi_wdata_o")),
      wstrb_(m.need("axi_wstrb_o")),
      wlast_(m.need("axi_wlast_o")),
      bvalid_(m.need("axi_bvalid_i")),
      bready_(m.need("axi_bready_o")),
      bid_(m.need("axi_bid_i")),
      bresp_(m.need("axi_bresp_i")),
      ar_stall_(seed_of(timing.seed, "ar"), timing.stall),
      r_stall_(seed_of(timing.seed, "r"), timing.stall),
      aw_stall_(seed_of(timing.seed, "aw"), timing.stall),
      w_stall_(seed_of(timing.seed, "w"), timing.stall),
      b_stall_(seed_of(timing.seed, "b"), timing.stall),
      order_(seed_of(timing.seed, "order")) {
  for (const Port* port : {&arready_, &rvalid_, &awready_, &wready_, &bvalid_}) set_to(*port, 0);
}

std::uint8_t AxiMemory::byte_at(std::size_t at) {
  return at < bytes_->size() ? (*bytes_)[at] : std::uint8_t(order_.next());
}

bool AxiMemory::open() { return !timing_.refresh || cycle_ % 1024 >= 32; }

// With stalls any that is the first of its id, else the first.
std::size_t AxiMemory::oldest_of_an_id(const std::deque<Burst>& bursts) {
  if (timing_.stall == 0) return 0;
  const std::size_t chosen = order_.next() % bursts.size();
  for (std::size_t n = 0; n < chosen; ++n) {
    if (bursts[n].id == bursts[chosen].id) return n;
  }
  return chosen;
}

void AxiMemory::offer_read() {
  if (is_set(rvalid_)) return;  // the word stays
  if (reads_.empty() || !open() || r_stall_.next()) return;
  reading_ = oldest_of_an_id(reads_);
  const Burst& burst = reads_[reading_];
  if (burst.ready > cycle_) return;
  const std::size_t size = std::size_t(rdata_.bits / 8);
  std::uint8_t* const to = static_cast<std::uint8_t*>(rdata_.data);
  for (std::size_t i = 0; i < size; ++i) to[i] = is_early() ? burst.data[burst.read + i] : byte_at(burst.address + i);
  set_to(rvalid_, 1);
  set_to(rid_, burst.id);
  set_to(rlast_, burst.beats == 1);
  set_to(rresp_, burst.broken ? kSlaveError : 0);
}

void AxiMemory::offer_answer() {
  if (is_set(bvalid_)) return;
  if (answers_.empty() || b_stall_.next()) return;
  answering_ = oldest_of_an_id(answers_);
  const Burst& burst = answers_[answering_];
  if (burst.ready > cycle_) return;
  for (std::size_t i = 0; i < burst.data.size() && !burst.broken; ++i) {
    if (burst.strobes[i] && burst.address + i < bytes_->size()) (*bytes_)[burst.address + i] = burst.data[i];
  }
  set_to(bvalid_, 1);
  set_to(bid_, burst.id);
  set_to(bresp_, burst.broken ? kSlaveError : 0);
}

void AxiMemory::drive() {
  if (read_moved_) set_to(rvalid_, 0);
  if (answer_moved_) set_to(bvalid_, 0);
  set_to(arready_, reads_.size() < kAddresses && !ar_stall_.next());
  set_to(awready_, writes_.size() < kAddresses && !aw_stall_.next());
  // A word a cycle: reads and writes take turns where both have one.
  const bool writes_now = words_wait_ && (!wrote_last_ || reads_.empty());
  if (!writes_now) offer_read();
  set_to(wready_, !is_set(rvalid_) && !writes_.empty() && open() && !w_stall_.next());
  wrote_last_ = writes_now;
  offer_answer();
}

std::string AxiMemory::check_burst(const char* channel, std::uint64_t address, std::uint64_t beats, std::uint64_t size,
                                   std::uint64_t burst) const {
  const std::uint64_t bytes = std::uint64_t(rdata_.bits / 8);
  const std::string text = std::string("protocol: ") + channel;
  if (burst != kIncrement) return text + " burst is none of incrementing addresses";
  if (std::uint64_t(1) << size != bytes) return text + " burst is of words of another size than the port";
  if (address % bytes != 0) return text + " address is no multiple of a word";
  if (address / 4096 != (address + beats * bytes - 1) / 4096) return text + " burst crosses 4 KiB";
  if (address + beats * bytes > bytes_->size()) return text + " burst is outside of the memory";
  return "";
}

void AxiMemory::sample() {
  for (Offered* channel : {&read_address_, &write_address_, &write_data_}) {
    if (const std::string wrong = channel->check(); !wrong.empty()) fail(wrong);
  }
  const auto burst_at = [&](const Port& id, const Port& address, const Port& length) {
    Burst burst;
    burst.id = std::uint32_t(value_of(id));
    burst.address = std::uint32_t(value_of(address));
    burst.beats = std::uint32_t(value_of(length)) + 1;
    burst.ready = cycle_ + std::uint64_t(timing_.latency);
    return burst;
  };
  read_moved_ = is_set(rvalid_) && is_set(rready_);
  if (read_moved_) {
    Burst& burst = reads_[reading_];
    burst.address += std::uint32_t(rdata_.bits / 8);
    burst.read += std::size_t(rdata_.bits / 8);
    if (--burst.beats == 0) reads_.erase(reads_.begin() + std::ptrdiff_t(reading_));
  }
  answer_moved_ = is_set(bvalid_) && is_set(bready_);
  if (answer_moved_) answers_.erase(answers_.begin() + std::ptrdiff_t(answering_));
  if (read_address_.moves()) {
    Burst burst = burst_at(arid_, araddr_, arlen_);
    burst.broken = ++read_bursts_ == broken_read_;
    const std::string wrong = check_burst("a read", burst.address, burst.beats, value_of(arsize_), value_of(arburst_));
    if (!wrong.empty()) fail(wrong);
    for (std::size_t i = 0; i < std::size_t(burst.beats * rdata_.bits / 8) && is_early(); ++i) {
      burst.data.push_back(byte_at(burst.address + i));
    }
    reads_.push_back(burst);
  }
  if (write_data_.valid() && writes_.empty() && !write_address_.valid()) {
    fail("protocol: written data comes before its address");
  }
  if (write_data_.moves()) {
    Burst& burst = writes_.front();
    const std::size_t size = std::size_t(wdata_.bits / 8);
    const auto* const data = static_cast<const std::uint8_t*>(wdata_.data);
    burst.data.insert(burst.data.end(), data, data + size);
    for (std::size_t i = 0; i < size; ++i) burst.strobes.push_back(value_of(wstrb_) >> i & 1);
    const bool last = burst.data.size() == burst.beats * size;
    if (is_set(wlast_) != last) fail("protocol: the last word of written data is not marked, or another is");
    if (last) {
      burst.ready = cycle_ + std::uint64_t(timing_.latency);
      answers_.push_back(burst);
      writes_.pop_front();
    }
  }
  if (write_address_.moves()) {
    Burst burst = burst_at(awid_, awaddr_, awlen_);
    burst.broken = ++write_bursts_ == broken_write_;
    const std::string wrong = check_burst("a write", burst.address, burst.beats, value_of(awsize_), value_of(awburst_));
    if (!wrong.empty()) fail(wrong);
    writes_.push_back(burst);
  }
  words_wait_ = write_data_.valid();
  ++cycle_;
}

}  // namespace halfspace::tb
