// SPDX-License-Identifier: Apache-2.0
// A Verilated model as the harness sees it: named ports and a way to evaluate. binding.cpp makes one of the class
// that Verilator printed, so that nothing else is compiled once a configuration.
#ifndef HALFSPACE_TB_HARNESS_MODEL_HPP_
#define HALFSPACE_TB_HARNESS_MODEL_HPP_

#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace halfspace::tb {

// CData … QData and VlWide alike: `bytes` of memory, least significant first (the host is little endian).
struct Port {
  std::string name;
  void* data = nullptr;
  int bytes = 0;
  int bits = 0;
  bool input = false;

  std::uint8_t* bit() const { return static_cast<std::uint8_t*>(data); }
};

// Cycles [first, end) in a life (Bench) of the model with this number; no model has number 0.
struct WaveRequest {
  std::string file;
  int model = 0, life = 0;
  std::uint64_t first = 0, end = 0;
};

class Model {
 public:
  virtual ~Model() = default;
  virtual void eval() = 0;
  // Writes a cycle into the waveform, if it is asked for: 10 ns, the clock high in the second half.
  void show(int life, std::uint64_t cycle, bool high) {
    if (!has_wave() || life != wave.life || cycle < wave.first || cycle >= wave.end) return;
    write_wave(10 * cycle + (high ? 5 : 0));
  }
  // Models are counted from 1.
  int number() const { return number_; }
  static inline int made = 0;
  static inline WaveRequest wave;

  const std::string& top() const { return top_; }
  const std::string& config() const { return config_; }
  int lanes_x() const { return lanes_x_; }
  int lanes_y() const { return lanes_y_; }

  // Null when there is no such port.
  const Port* find(const std::string& name) const;
  // The lack of it, or another width (0: any), is an Error.
  const Port& need(const std::string& name, int bits = 0) const;
  const std::unordered_map<std::string, Port>& ports() const { return ports_; }
  void set(const std::string& name, std::uint64_t value);
  // A number of the package; 0 if it has none of that name.
  int constant(const std::string& name) const;
  // "hs_ztest_index (middle, 2x2 lanes)"
  std::string title() const;

 protected:
  Model(std::string top, std::string config, int lanes_x, int lanes_y)
      : top_(std::move(top)), config_(std::move(config)), lanes_x_(lanes_x), lanes_y_(lanes_y) {}

  // Inputs start at 0.
  void add_port(const std::string& name, void* data, int bytes, int bits, bool input);
  // The wires of a stream inside stand beside the ports, named as those of a stream that leaves: <stream>_o,
  // <stream>_valid_o, and <stream>_ready_o, which is watched.
  void add_watch(const std::string& stream, void* valid, void* ready, void* word, int bytes, int bits);
  // Whether this is the model of the request.
  bool has_wave() const { return number_ == wave.model; }
  virtual void write_wave(std::uint64_t nanoseconds) = 0;
  void add_constant(const char* name, int value) { constants_[name] = value; }

 private:
  std::string top_, config_;
  int lanes_x_, lanes_y_;
  int number_ = ++made;
  std::unordered_map<std::string, Port> ports_;
  std::unordered_map<std::string, int> constants_;
};

// How registers and memories start that a reset has not reached yet.
enum class Start { kZeros = 0, kOnes = 1, kRandom = 2 };
// A model of this program; random values are drawn from `seed`.
std::unique_ptr<Model> make_model(std::uint64_t seed, Start start);
// Its top module, known without making it.
std::string model_top();

// How a model of the same RTL that writes waves is built: the words of tb/model.py, but for --out.
struct TracedBuild {
  bool is_this = false;  // this one writes waves itself
  std::vector<std::string> command;
};
TracedBuild traced_build();

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_HARNESS_MODEL_HPP_
