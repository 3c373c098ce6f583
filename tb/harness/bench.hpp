// SPDX-License-Identifier: Apache-2.0
// A clocked model with Senders and Receivers on its streams, and what a run of it gave.
#ifndef HALFSPACE_TB_HARNESS_BENCH_HPP_
#define HALFSPACE_TB_HARNESS_BENCH_HPP_

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "tb/harness/channel.hpp"
#include "tb/harness/memory.hpp"
#include "tb/harness/model.hpp"
#include "tb/harness/options.hpp"
#include "tb/report/accesses.hpp"
#include "tb/report/rates.hpp"
#include "tb/report/timeline.hpp"
#include "tb/system/clients.hpp"
#include "tb/system/partner.hpp"

namespace halfspace::tb {

struct StreamResult {
  std::string name, from, to;
  std::size_t words = 0, mismatches = 0, missing = 0;
  std::vector<std::string> failures;
  std::vector<WrongWord> wrong;
};

// The wires of a stream when the run ended.
struct StreamState {
  bool valid = false, ready = false;
};

// max(setup, stamps, pixels, merges) cycles, pixels being what the shader takes, is what the units' own rates allow for
// a frame; setup 0: not known.
struct Bound {
  std::uint64_t setup = 0, stamps = 0, pixels = 0;
  std::uint64_t merges = 0;  // stamps of ztest_merge; of hs_static_frames alone
  std::uint64_t cycles() const { return std::max({setup, stamps, pixels, merges}); }
};

// Of a film: cycles that its units take by their own rates, over all passes. One pass is under way at a time, so that
// `passes` is what there is to reach: of each pass drawing, scan-out and the words of motion, one after the other.
struct FilmBound {
  std::uint64_t frames = 0, setup = 0, stamps = 0, shader = 0, motion = 0, film = 0, passes = 0;
  std::uint64_t cycles() const { return std::max({setup, stamps, shader, motion, film}); }
};

struct Result {
  std::string unit;  // or "pipeline", or "up_convert"
  std::vector<StreamResult> streams;
  // Sentences, of the unit that is wrong first and then `follows`, of those that only pass on what is wrong.
  std::vector<std::string> failures, follows;
  std::string first_wrong;                  // that unit; "": not known
  std::int64_t first_cycle = -1;            // of the first failure, of a hang that of the last word; < 0: none
  int first_life = 0, first_model = 0;      // the bench and the model, by number, in which that is
  std::map<std::string, StreamState> ends;  // by stream
  std::uint64_t cycles = 0;
  std::string cycles_of;              // what `cycles` measures
  std::vector<std::size_t> repeated;  // frames that were sent twice
  std::uint64_t simulated = 0;
  double seconds = 0, processor_seconds = 0;
  Bound bound;
  FilmBound film;
  // Of the pipeline, the last frame's.
  Rates rates;
  std::vector<Accesses> accesses;
  Timeline timeline;
  std::vector<std::uint64_t> frame_ends;  // cycles
  std::vector<ClientCount> clients;       // of memory outside, over all cycles

  std::size_t words() const;
  std::size_t mismatches() const;
  std::size_t missing() const;
  bool passed() const { return failures.empty(); }
};

// Wall and processor time since it was made; on a machine that others use the second one tells the model's speed.
class Stopwatch {
 public:
  void stop(Result* result) const {
    result->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    result->processor_seconds = double(std::clock() - clock_) / CLOCKS_PER_SEC;
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::clock_t clock_ = std::clock();
};

class Bench {
 public:
  // `name`: of the unit, or "pipeline". clk_i and rst_ni are the model's.
  Bench(Model* model, const Vectors* vectors, const Options* options, std::string name);

  // `port`: what the stream's ports are called, if not as the stream.
  Sender& add_sender(const Stream& stream, const std::string& port = "");
  Sender& add_sender(const Wires& wires, const std::string& name);
  Receiver& add_receiver(const Stream& stream, const std::string& port = "");
  Memory& add_memory(const MemoryPorts& ports);
  // It is driven and looks in every cycle, and lives as long as the bench.
  void add_partner(Partner* partner) { partners_.push_back(partner); }

  // Outputs that have to be 0 in each cycle.
  void keep_zero(std::vector<const Port*> ports) { zeros_ = std::move(ports); }
  // Looks at the model in each cycle, the clock low, and says what is wrong with it, or "".
  void on_cycle(std::function<std::string()> look) { looks_.push_back(std::move(look)); }
  // From the first word on; all streams are there.
  void keep_timeline();
  void reset();
  void set_frame(const Frame& frame);
  // Steps until done() holds; `patience` cycles without a word that was expected are a hang: told, and false. So are
  // more cycles than the slowest unit needs for the words that moved.
  bool run(const std::function<bool()>& done, std::uint64_t patience);
  bool all_done() const;
  // Whether the first `frames` of what was sent and expected are through.
  bool done(std::size_t frames) const;
  bool all_taken() const;
  void idle(int cycles);
  // Tells what is wrong, once.
  void fail(const std::string& what);
  // Collects the streams' results, and refuses streams without words.
  void finish(Result* result);
  // Collects what was wrong until now, and nothing that is missing: the bench ends before its words do.
  void abandon(const std::string& note, Result* result);

  // Benches that were made: each is a life of a model, from its reset on, whose cycles count from 0.
  static inline int lives = 0;

  std::uint64_t cycle() const { return cycle_; }
  // Cycles in which an end of a stream made the model wait, or may have.
  std::uint64_t stalled() const { return stalled_; }
  // Words that were not offered at once.
  std::uint64_t late() const;
  std::uint64_t first_move() const { return first_move_; }
  const std::string& name() const { return name_; }
  Model& model() const { return *model_; }

 private:
  bool step();
  bool is_wrong() const;
  void look();
  void note_streams();
  void tell_progress();
  std::string waiting() const;
  void check_none_left();

  Model* model_;
  const Vectors* vectors_;
  const Options* options_;
  std::uint64_t seed_for(const std::string& part) const;
  void note_cycle(const Receiver& receiver, Result* result) const;
  void note_life(Result* result) const;

  std::string name_;
  int life_;
  Timeline timeline_;
  bool has_timeline_ = false;
  std::uint8_t* clock_;
  std::deque<Sender> senders_;
  std::deque<Receiver> receivers_;
  std::deque<Memory> memories_;
  std::vector<const Port*> zeros_;
  std::vector<std::function<std::string()>> looks_;
  bool looked_wrong_ = false;
  std::vector<Partner*> partners_;
  std::vector<std::string> failures_;
  std::uint64_t cycle_ = 0, first_move_ = 0, last_move_ = 0, moves_ = 0, stalled_ = 0;
  std::chrono::steady_clock::time_point told_ = std::chrono::steady_clock::now();
};

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_HARNESS_BENCH_HPP_
