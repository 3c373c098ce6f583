// SPDX-License-Identifier: Apache-2.0
// A stream of so many words, between two processes on threads of their own: a test of what unbounded queues hide. For
// tests alone; HALFSPACE_STREAM_BOUNDED chooses it, in a program that names configurations of its own.
//
// A write to a full stream waits, and so does a read from an empty one. All streams share a Schedule, which counts the
// processes that can go on. When the last one waits, no word will ever move again: that is known at once and exactly,
// not after a time. Everything that waits is then thrown out, as at the end of a frame.
#ifndef HALFSPACE_HLS_NUMBERS_STREAM_BOUNDED_HPP_
#define HALFSPACE_HLS_NUMBERS_STREAM_BOUNDED_HPP_

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace halfspace {
namespace bounded {

// What a process that waits in vain is thrown out with.
struct Stopped {};

// The processes of a phase.
class Schedule {
 public:
  // A process that runs for ever, and one that comes to an end: the phase is over when all of those have.
  void add_endless(const char* name, std::function<void()> step) {
    processes_.push_back({name,
                          [step = std::move(step)] {
                            for (;;) step();
                          },
                          true});
  }
  void add(const char* name, std::function<void()> run) { processes_.push_back({name, std::move(run), false}); }

  // Runs them until none can go on. Returns "", or if one has not come to its end what each process waits for.
  std::string run() {
    running_ = processes_.size();
    to_end_ = 0;
    for (const Process& process : processes_) to_end_ += process.is_endless ? 0 : 1;
    std::vector<std::thread> threads;
    for (const Process& process : processes_) threads.emplace_back([this, &process] { run_one(process); });
    for (std::thread& thread : threads) thread.join();
    if (failure_) std::rethrow_exception(failure_);
    return report_;
  }

 private:
  template <class T>
  friend class Stream;

  struct Process {
    const char* name;
    std::function<void()> run;
    bool is_endless;
  };
  struct Wait {
    const char *process, *stream;
    bool is_full;  // else it is empty
    std::size_t depth;
    std::condition_variable* moved;
    std::function<bool()> can_go_on;
  };

  static const char*& this_process() {
    thread_local const char* name = "";
    return name;
  }

  void run_one(const Process& process) {
    this_process() = process.name;
    std::exception_ptr failure;
    try {
      process.run();
    } catch (const Stopped&) {
    } catch (...) {
      failure = std::current_exception();
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    if (failure) {
      failure_ = failure;
      stop();
    } else if (!process.is_endless && !stopped_) {
      --to_end_;
    }
    --running_;
    stop_if_stuck();
  }

  // Waits under `lock` until it can go on, which another process brings about.
  void wait(std::unique_lock<std::mutex>& lock, const Wait& wait) {
    if (wait.can_go_on()) return;
    waits_.push_back(&wait);
    stop_if_stuck();
    wait.moved->wait(lock, [&] { return stopped_ || wait.can_go_on(); });
    waits_.erase(std::find(waits_.begin(), waits_.end(), &wait));
    if (!wait.can_go_on()) throw Stopped();
  }

  // One that has been told, and has not woken yet, can go on.
  void stop_if_stuck() {
    if (stopped_ || waits_.size() != running_) return;
    for (const Wait* wait : waits_) {
      if (wait->can_go_on()) return;
    }
    if (to_end_ != 0) {
      for (const Wait* wait : waits_) {
        report_ += std::string(wait->process) + " waits: " + wait->stream + " is " +
                   (wait->is_full ? "full, depth " + std::to_string(wait->depth) : "empty") + "\n";
      }
    }
    stop();
  }

  void stop() {
    stopped_ = true;
    for (const Wait* wait : waits_) wait->moved->notify_all();
  }

  std::vector<Process> processes_;
  std::mutex mutex_;
  std::size_t running_ = 0, to_end_ = 0;  // processes; those of them that come to an end
  std::vector<const Wait*> waits_;
  bool stopped_ = false;
  std::string report_;
  std::exception_ptr failure_;
};

// First in, first out, of one writer and one reader. One that is not bound is of one thread, and takes all: what loads
// a memory before a frame has such.
template <class T>
class Stream {
 public:
  void bind(Schedule& schedule, const char* name, int depth) {
    schedule_ = &schedule;
    name_ = name;
    depth_ = std::size_t(depth);
  }

  void write(const T& value) {
    std::unique_lock<std::mutex> lock = locked();
    if (schedule_ && queue_.size() == depth_) wait(lock, true, [this] { return queue_.size() < depth_; });
    queue_.push_back(value);
    if (tap_) tap_->push_back(value);
    moved_.notify_one();
  }

  T read() {
    std::unique_lock<std::mutex> lock = locked();
    if (schedule_ && queue_.empty()) wait(lock, false, [this] { return !queue_.empty(); });
    const T value = queue_.front();
    queue_.pop_front();
    moved_.notify_one();
    return value;
  }

  // Between two phases.
  bool empty() const { return queue_.empty(); }
  void tap(std::vector<T>* sink) { tap_ = sink; }

 private:
  std::unique_lock<std::mutex> locked() const {
    return schedule_ ? std::unique_lock<std::mutex>(schedule_->mutex_) : std::unique_lock<std::mutex>();
  }
  void wait(std::unique_lock<std::mutex>& lock, bool is_full, std::function<bool()> can_go_on) {
    schedule_->wait(lock, {Schedule::this_process(), name_, is_full, depth_, &moved_, std::move(can_go_on)});
  }

  Schedule* schedule_ = nullptr;
  const char* name_ = "";
  std::size_t depth_ = 0;
  std::deque<T> queue_;
  std::condition_variable moved_;  // one waits at most: a queue is not full and empty
  std::vector<T>* tap_ = nullptr;
};

}  // namespace bounded

using bounded::Stream;

}  // namespace halfspace

#endif  // HALFSPACE_HLS_NUMBERS_STREAM_BOUNDED_HPP_
