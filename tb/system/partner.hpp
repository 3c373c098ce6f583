// SPDX-License-Identifier: Apache-2.0
// What stands at ports of hs_system that are no stream of the set: it drives and looks in every cycle of a Bench, and
// says what was wrong. And the rule of every such channel: what is offered stays until it is taken.
#ifndef HALFSPACE_TB_SYSTEM_PARTNER_HPP_
#define HALFSPACE_TB_SYSTEM_PARTNER_HPP_

#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "tb/harness/model.hpp"

namespace halfspace::tb {

class Partner {
 public:
  virtual ~Partner() = default;
  // Before the model is evaluated with the clock low, and after that.
  virtual void drive() = 0;
  virtual void sample() = 0;

  // What was wrong in this cycle; the bench tells each sentence once.
  std::vector<std::string> take_failures() { return std::move(failures_); }

 protected:
  void fail(const std::string& what) { failures_.push_back(what); }

 private:
  std::vector<std::string> failures_;
};

inline std::uint64_t value_of(const Port& port) {
  std::uint64_t value = 0;
  std::memcpy(&value, port.data, std::size_t(port.bytes < 8 ? port.bytes : 8));
  return value;
}
inline bool is_set(const Port& port) { return *port.bit() != 0; }

// A channel that the model sends on: `payload` are its ports beside valid and ready.
class Offered {
 public:
  Offered(const Model& model, std::string name, const std::string& valid, const std::string& ready,
          const std::vector<std::string>& payload)
      : name_(std::move(name)), valid_(model.need(valid, 1)), ready_(model.need(ready, 1)) {
    for (const std::string& port : payload) payload_.push_back(&model.need(port));
  }

  bool valid() const { return is_set(valid_); }
  bool moves() const { return is_set(valid_) && is_set(ready_); }
  // What is wrong, or "".
  std::string check() {
    std::string now;
    for (const Port* port : payload_) now.append(static_cast<const char*>(port->data), std::size_t(port->bytes));
    std::string wrong;
    if (waits_ && !valid()) wrong = "protocol: " + name_ + " dropped valid before ready";
    else if (waits_ && now != held_) wrong = "protocol: " + name_ + " changed its payload while valid and not ready";
    waits_ = valid() && !is_set(ready_);
    held_ = now;
    return wrong;
  }

 private:
  std::string name_;
  const Port &valid_, &ready_;
  std::vector<const Port*> payload_;
  std::string held_;
  bool waits_ = false;
};

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_SYSTEM_PARTNER_HPP_
