// SPDX-License-Identifier: Apache-2.0
#include "tb/system/ports.hpp"

#include "tb/harness/words.hpp"

namespace halfspace::tb {
namespace {

constexpr int kPatience = 10000;

void set_to(const Port& port, std::uint64_t value) { std::memcpy(port.data, &value, std::size_t(port.bytes)); }

}  // namespace

RegisterPort::RegisterPort(const Model& m, std::uint64_t seed, int stall, std::function<void()> step)
    : step_(std::move(step)),
      read_data_(m, "the value of a register", "axil_rvalid_o", "axil_rready_i", {"axil_rdata_o", "axil_rresp_o"}),
      answer_(m, "the answer to a write of a register", "axil_bvalid_o", "axil_bready_i", {"axil_bresp_o"}),
      awvalid_(m.need("axil_awvalid_i")),
      awready_(m.need("axil_awready_o")),
      awaddr_(m.need("axil_awaddr_i")),
      wvalid_(m.need("axil_wvalid_i")),
      wready_(m.need("axil_wready_o")),
      wdata_(m.need("axil_wdata_i")),
      wstrb_(m.need("axil_wstrb_i")),
      bready_(m.need("axil_bready_i")),
      bresp_(m.need("axil_bresp_o")),
      arvalid_(m.need("axil_arvalid_i")),
      arready_(m.need("axil_arready_o")),
      araddr_(m.need("axil_araddr_i")),
      rready_(m.need("axil_rready_i")),
      rdata_(m.need("axil_rdata_o")),
      rresp_(m.need("axil_rresp_o")),
      stall_(seed_of(seed, "registers"), stall) {
  for (const Port* port : {&awvalid_, &wvalid_, &bready_, &arvalid_, &rready_}) set_to(*port, 0);
}

void RegisterPort::drive() {
  for (const Port* port : moved_) set_to(*port, 0);
  moved_.clear();
  // Address and data of a write come in any order.
  if (address_waits_ && !is_set(reading_ ? arvalid_ : awvalid_) && !stall_.next()) {
    set_to(reading_ ? arvalid_ : awvalid_, 1);
  }
  if (data_waits_ && !is_set(wvalid_) && !stall_.next()) set_to(wvalid_, 1);
  set_to(rready_, !stall_.next());
  set_to(bready_, !stall_.next());
}

void RegisterPort::sample() {
  for (Offered* channel : {&read_data_, &answer_}) {
    if (const std::string wrong = channel->check(); !wrong.empty()) fail(wrong);
  }
  if (read_data_.moves()) {
    if (!reading_) fail("protocol: the value of a register comes and none was asked for");
    value_ = std::uint32_t(value_of(rdata_));
    refused_ = value_of(rresp_) != 0;
    reading_ = false;
  }
  if (answer_.moves()) {
    if (!writing_) fail("protocol: an answer to a write of a register comes and none was written");
    refused_ = value_of(bresp_) != 0;
    writing_ = false;
  }
  if (is_set(arvalid_) && is_set(arready_)) moved_.push_back(&arvalid_), address_waits_ = false;
  if (is_set(awvalid_) && is_set(awready_)) moved_.push_back(&awvalid_), address_waits_ = false;
  if (is_set(wvalid_) && is_set(wready_)) moved_.push_back(&wvalid_), data_waits_ = false;
}

void RegisterPort::wait(const bool& busy) {
  for (int n = 0; busy && n < kPatience; ++n) step_();
  if (busy) fail("hang: a register is not answered");
}

std::uint32_t RegisterPort::read(std::uint32_t address) {
  set_to(araddr_, address);
  reading_ = address_waits_ = true;
  wait(reading_);
  return value_;
}

void RegisterPort::write(std::uint32_t address, std::uint32_t value) {
  set_to(awaddr_, address);
  set_to(wdata_, value);
  set_to(wstrb_, 15);
  writing_ = address_waits_ = data_waits_ = true;
  wait(writing_);
}

VideoPort::VideoPort(const Model& m, std::uint64_t seed, int stall)
    : beat_(m, "a beat of video", "video_tvalid_o", "video_tready_i",
            {"video_tdata_o", "video_tkeep_o", "video_tuser_o", "video_tlast_o"}),
      ready_(m.need("video_tready_i")),
      data_(m.need("video_tdata_o")),
      keep_(m.need("video_tkeep_o")),
      user_(m.need("video_tuser_o")),
      last_beat_(m.need("video_tlast_o")),
      lanes_(data_.bits / 24),
      stall_(seed_of(seed, "video"), stall) {
  set_to(ready_, 0);
}

void VideoPort::drive() { set_to(ready_, !stall_.next()); }

void VideoPort::sample() {
  if (const std::string wrong = beat_.check(); !wrong.empty()) fail(wrong);
  if (beat_.moves()) take_beat();
  ++cycle_;
}

void VideoPort::give_up() {
  expected_.clear();
  any_ = true;
  x_ = y_ = 0;
}

void VideoPort::take_beat() {
  ++beats_;
  if (any_ && (expected_.empty() || !is_set(user_))) return;
  any_ = false;
  if (expected_.empty()) {
    fail("surplus: a beat of video when no frame is expected");
    return;
  }
  const Picture& picture = expected_.front();
  if (is_set(user_) != (x_ == 0 && y_ == 0)) {
    fail("video: the first beat of a frame is not marked, or another is");
  }
  if (x_ == 0 && y_ == 0) {
    shown_ = {picture.width, picture.height, {}};
    shown_.pixels.assign(std::size_t(picture.width) * picture.height, 0);
  }
  std::uint32_t words[16] = {};
  std::memcpy(words, data_.data, std::size_t(data_.bytes));
  for (int lane = 0; lane < lanes_; ++lane) {
    const std::uint32_t x = x_ + std::uint32_t(lane);
    const bool kept = x < picture.width;
    if ((value_of(keep_) >> (3 * lane) & 7) != (kept ? 7 : 0)) {
      fail("video: the pixels of a beat that count are not those of the line");
    }
    if (!kept) continue;
    const std::size_t at = std::size_t(y_) * picture.width + x;
    shown_.pixels[at] = std::uint32_t(extract(words, 24 * lane, 24));
    if (shown_.pixels[at] == picture.pixels[at]) continue;
    if (wrong_pixels_++ != 0) continue;
    fail("video: a pixel differs (the first one: frame " + std::to_string(frames_) + ", pixel (" + std::to_string(x) +
         ", " + std::to_string(y_) + "))");
  }
  x_ += std::uint32_t(lanes_);
  const bool line_ends = x_ >= picture.width;
  if (is_set(last_beat_) != line_ends) fail("video: the end of a line is not marked, or another beat is");
  if (!line_ends) return;
  x_ = 0;
  if (++y_ != picture.height) return;
  y_ = 0;
  ++frames_;
  ends_.push_back(cycle_);
  last_ = shown_;
  expected_.pop_front();
}

}  // namespace halfspace::tb
