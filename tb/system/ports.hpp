// SPDX-License-Identifier: Apache-2.0
// The processor's end of the registers, and what takes the video.
#ifndef HALFSPACE_TB_SYSTEM_PORTS_HPP_
#define HALFSPACE_TB_SYSTEM_PORTS_HPP_

#include <cstdint>
#include <deque>
#include <functional>
#include <vector>

#include "tb/harness/stall.hpp"
#include "tb/system/partner.hpp"

namespace halfspace::tb {

// Registers by AXI4-Lite. read() and write() step the bench until they are answered.
class RegisterPort : public Partner {
 public:
  // `step`: a cycle of the bench.
  RegisterPort(const Model& model, std::uint64_t seed, int stall, std::function<void()> step);
  void drive() override;
  void sample() override;

  std::uint32_t read(std::uint32_t address);
  void write(std::uint32_t address, std::uint32_t value);
  // Whether the last one was answered with an error.
  bool refused() const { return refused_; }

 private:
  void wait(const bool& busy);

  std::function<void()> step_;
  Offered read_data_, answer_;
  const Port &awvalid_, &awready_, &awaddr_, &wvalid_, &wready_, &wdata_, &wstrb_, &bready_, &bresp_;
  const Port &arvalid_, &arready_, &araddr_, &rready_, &rdata_, &rresp_;
  Stall stall_;
  std::vector<const Port*> moved_;  // that were taken in the last cycle
  bool reading_ = false, address_waits_ = false, writing_ = false, data_waits_ = false, refused_ = false;
  std::uint32_t value_ = 0;
};

// A picture's pixels, {r, g, b} of 8 bits, row 0 on top.
struct Picture {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint32_t> pixels;
};

// Takes the video and holds it against the pictures that are expected.
class VideoPort : public Partner {
 public:
  VideoPort(const Model& model, std::uint64_t seed, int stall);
  void drive() override;
  void sample() override;

  void expect(Picture picture) { expected_.push_back(std::move(picture)); }
  bool done() const { return expected_.empty(); }
  // What comes is held against nothing, until the next first beat of a frame: a frame was given up.
  void give_up();
  std::uint64_t frames() const { return frames_; }
  std::uint64_t beats() const { return beats_; }
  std::uint64_t wrong_pixels() const { return wrong_pixels_; }
  const Picture& last() const { return last_; }
  // The cycle of each frame's last beat.
  const std::vector<std::uint64_t>& ends() const { return ends_; }

 private:
  void take_beat();

  Offered beat_;
  const Port &ready_, &data_, &keep_, &user_, &last_beat_;
  int lanes_;
  Stall stall_;
  std::deque<Picture> expected_;
  Picture shown_, last_;
  bool any_ = false;  // nothing is expected
  std::uint32_t x_ = 0, y_ = 0;
  std::vector<std::uint64_t> ends_;
  std::uint64_t cycle_ = 0, frames_ = 0, beats_ = 0, wrong_pixels_ = 0;
};

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_SYSTEM_PORTS_HPP_
