// SPDX-License-Identifier: Apache-2.0
#include "tb/system/clients.hpp"

#include <algorithm>

#include "tb/harness/words.hpp"

namespace halfspace::tb {
namespace {

constexpr int kAddressBits = 32, kBeatsBits = 8, kRequestBits = kAddressBits + kBeatsBits;
// As hs_memory_pkg numbers them; each buffer has its own gigabyte.
const char* const kReads[] = {"index read", "depth read", "scan read", "planes read"};
const char* const kWrites[] = {"index write", "depth write", "planes write"};
constexpr int kReadBuffer[] = {1, 2, 1, 3}, kWriteBuffer[] = {1, 2, 3};
constexpr std::uint64_t kPage = 4096;
constexpr std::uint64_t kPhase = 3000;  // cycles

std::uint32_t field(const Port& port, int lsb, int bits) {
  std::uint32_t value = 0;
  copy_bits(&value, 0, static_cast<const std::uint32_t*>(port.data), lsb, bits);
  return value;
}

bool bit(const Port& port, int n) { return *port.bit() >> n & 1; }

}  // namespace

bool Clients::fits(const Model& model) {
  const Port* const port = model.find("memory_read_valid_o");
  return port != nullptr && port->bits > 1;
}

Clients::Clients(Model* model, std::uint64_t seed, int latency)
    : model_(model),
      read_valid_(model->need("memory_read_valid_o")),
      read_ready_(model->need("memory_read_ready_i")),
      read_(model->need("memory_read_o")),
      data_valid_(model->need("memory_data_valid_i")),
      data_(model->need("memory_data_i")),
      write_valid_(model->need("memory_write_valid_o")),
      write_ready_(model->need("memory_write_ready_i")),
      write_(model->need("memory_write_o")),
      store_valid_(model->need("memory_store_valid_o")),
      store_ready_(model->need("memory_store_ready_i")),
      store_(model->need("memory_store_o")),
      written_(model->need("memory_written_i")),
      random_(seed),
      latency_(latency),
      word_bits_(data_.bits / read_valid_.bits),
      reads_(read_valid_.bits),
      writes_(write_valid_.bits),
      asked_(std::size_t(reads_)),
      written_back_(std::size_t(writes_)) {
  std::uint32_t* const bases = static_cast<std::uint32_t*>(model->need("memory_bases_i", 96).data);
  for (int n = 0; n < 3; ++n) bases[2 - n] = std::uint32_t(n + 1) << 30 | (random_.next() % 256) * kPage;
  for (int n = 0; n < reads_; ++n) counts_.push_back({kReads[n]});
  for (int n = 0; n < writes_; ++n) counts_.push_back({kWrites[n]});
}

void Clients::note(const std::string& failure) { fail("memory: " + failure); }

std::uint64_t Clients::latency() {
  return latency_ >= 0 ? std::uint64_t(latency_) : 1 + random_.next() % std::uint32_t(longest_);
}

bool Clients::waits() { return wait_percent_ != 0 && random_.next() % 100 < std::uint32_t(wait_percent_); }

Clients::Word& Clients::word_at(std::uint64_t address) {
  const auto found = memory_.find(address);
  if (found != memory_.end()) return found->second;
  Word& word = memory_[address];
  for (std::uint32_t& part : word) part = random_.next();
  return word;
}

Clients::Request Clients::request_of(const Port& port, int client, bool writes) {
  Request request;
  request.client = client;
  request.address = field(port, client * kRequestBits + kBeatsBits, kAddressBits);
  request.beats = int(field(port, client * kRequestBits, kBeatsBits));
  request.due = now_ + latency();
  request.order = order_++;
  request.early = latency_ < 0 && random_.next() % 2 != 0;
  const std::string name = writes ? kWrites[client] : kReads[client];
  const std::uint64_t bytes = std::uint64_t(request.beats * word_bits_ / 8);
  if (request.beats == 0) note(name + " of no word");
  if (request.address % std::uint64_t(word_bits_ / 8) != 0) note(name + " at no word's address");
  if (int(request.address >> 30) != (writes ? kWriteBuffer : kReadBuffer)[client]) note(name + " in another buffer");
  ClientCount& count = counts_[std::size_t(writes ? reads_ + client : client)];
  ++count.requests;
  count.bytes += bytes;
  return request;
}

int Clients::pick_read() {
  if (waits()) return -1;
  if (latency_ >= 0 && current_ >= 0) return current_;
  int picked = -1;
  std::uint64_t best = 0;
  for (int client = 0; client < reads_; ++client) {
    const auto& queue = asked_[std::size_t(client)];
    if (queue.empty() || queue.front().due > now_) continue;
    const std::uint64_t rank = latency_ >= 0 ? queue.front().order : random_.next();
    if (picked < 0 || rank < best) {
      picked = client;
      best = rank;
    }
  }
  return picked;
}

void Clients::write(const Request& request) {
  for (int n = 0; n < request.beats; ++n) {
    memory_[request.address + std::uint64_t(n * word_bits_ / 8)] = request.words[std::size_t(n)];
  }
}

void Clients::drive() {
  if (latency_ < 0 && now_ % kPhase == 0) {
    const int waits[] = {0, 25, 60}, longest[] = {1, 40, 200};
    wait_percent_ = waits[random_.next() % 3];
    longest_ = longest[random_.next() % 3];
    most_ = waits[random_.next() % 3] / 8 + 1;
  }
  ++now_;
  const int client = pick_read();
  *data_valid_.bit() = client < 0 ? 0 : std::uint8_t(1 << client);
  std::uint32_t* const data = static_cast<std::uint32_t*>(data_.data);
  for (int n = 0; n < data_.bits / 32; ++n) data[n] = random_.next();
  current_ = -1;
  if (client >= 0) {
    auto& queue = asked_[std::size_t(client)];
    Request& request = queue.front();
    const Word word = request.early ? request.words[std::size_t(request.done)]
                                    : word_at(request.address + std::uint64_t(request.done * word_bits_ / 8));
    copy_bits(data, client * word_bits_, word.data(), 0, word_bits_);
    if (++request.done == request.beats) queue.pop_front();
    else current_ = client;
  }
  std::uint8_t ready = 0;
  for (int n = 0; n < reads_; ++n) ready = std::uint8_t(ready | !waits() << n);
  *read_ready_.bit() = ready;
  ready = 0;
  for (int n = 0; n < writes_; ++n) {
    std::size_t under_way = written_back_[std::size_t(n)].size();
    for (const Request& request : granted_) under_way += request.client == n;
    ready = std::uint8_t(ready | (int(under_way) < most_ && !waits()) << n);
  }
  *write_ready_.bit() = ready;
  *store_ready_.bit() = granted_.empty() || waits() ? 0 : std::uint8_t(1 << granted_.front().client);
  std::uint8_t written = 0;
  for (int n = 0; n < writes_; ++n) {
    auto& queue = written_back_[std::size_t(n)];
    if (queue.empty() || queue.front().due > now_) continue;
    if (!queue.front().early) write(queue.front());
    queue.pop_front();
    written = std::uint8_t(written | 1 << n);
  }
  *written_.bit() = written;
}

void Clients::sample() {
  // What comes in this cycle is not among the words of this cycle.
  if (*store_ready_.bit() != 0) {
    Request& request = granted_.front();
    if (!bit(store_valid_, request.client)) {
      note(std::string(kWrites[request.client]) + " without its words");
    } else {
      Word word{};
      copy_bits(word.data(), 0, static_cast<const std::uint32_t*>(store_.data), request.client * word_bits_,
                word_bits_);
      request.words.push_back(word);
      if (int(request.words.size()) == request.beats) {
        request.due = now_ + latency();
        if (request.early) write(request);
        auto& queue = written_back_[std::size_t(request.client)];
        if (!queue.empty()) request.due = std::max(request.due, queue.back().due + 1);
        queue.push_back(request);
        granted_.pop_front();
      }
    }
  }
  for (int n = 0; n < reads_; ++n) {
    if (!bit(read_valid_, n) || !bit(read_ready_, n)) continue;
    Request request = request_of(read_, n, false);
    if (request.early) {
      for (int beat = 0; beat < request.beats; ++beat) {
        request.words.push_back(word_at(request.address + std::uint64_t(beat * word_bits_ / 8)));
      }
    }
    asked_[std::size_t(n)].push_back(request);
  }
  for (int n = 0; n < writes_; ++n) {
    if (bit(write_valid_, n) && bit(write_ready_, n)) granted_.push_back(request_of(write_, n, true));
  }
}

}  // namespace halfspace::tb
