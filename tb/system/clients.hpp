// SPDX-License-Identifier: Apache-2.0
// The memory outside of hs_pipeline: it serves the clients of hs_memory_pkg.
//
// With a latency it is a port that gives a word a cycle and takes one, in the order of the requests. Without, it is as
// unpleasant as the contract allows: random latencies, waits and order of clients, in phases, and each read and each
// write is done as early or as late as can be. What nobody wrote is noise.
#ifndef HALFSPACE_TB_SYSTEM_CLIENTS_HPP_
#define HALFSPACE_TB_SYSTEM_CLIENTS_HPP_

#include <array>
#include <cstdint>
#include <deque>
#include <string>
#include <unordered_map>
#include <vector>

#include "tb/harness/model.hpp"
#include "tb/harness/stall.hpp"
#include "tb/system/partner.hpp"

namespace halfspace::tb {

// Of a client that reads or writes.
struct ClientCount {
  std::string name;
  std::uint64_t requests = 0, bytes = 0;
};

class Clients : public Partner {
 public:
  // Whether the model has any, and not their ports alone.
  static bool fits(const Model& model);
  // `latency`: cycles from a request to its first word, or from the last word to `written`; < 0: random.
  Clients(Model* model, std::uint64_t seed, int latency);

  void drive() override;
  void sample() override;

  const std::vector<ClientCount>& counts() const { return counts_; }

 private:
  using Word = std::array<std::uint32_t, 4>;  // up to 128 bits
  struct Request {
    int client = 0;
    std::uint64_t address = 0, due = 0, order = 0;
    int beats = 0, done = 0;
    bool early = false;  // a read, as it is asked for; a write, as its words come
    std::vector<Word> words;
  };
  Request request_of(const Port& port, int client, bool writes);
  Word& word_at(std::uint64_t address);
  std::uint64_t latency();
  bool waits();
  int pick_read();
  void note(const std::string& failure);
  void write(const Request& request);

  Model* model_;
  const Port &read_valid_, &read_ready_, &read_, &data_valid_, &data_;
  const Port &write_valid_, &write_ready_, &write_, &store_valid_, &store_ready_, &store_, &written_;
  Random random_;
  int latency_, word_bits_, reads_, writes_, wait_percent_ = 0, longest_ = 0, current_ = -1, most_ = 8;
  std::uint64_t now_ = 0, order_ = 0;
  std::vector<std::deque<Request>> asked_, written_back_;  // by client
  std::deque<Request> granted_;                            // writes whose words come, in order
  std::unordered_map<std::uint64_t, Word> memory_;
  std::vector<ClientCount> counts_;
};

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_SYSTEM_CLIENTS_HPP_
