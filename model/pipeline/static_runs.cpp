// SPDX-License-Identifier: Apache-2.0
#include "model/pipeline/static_runs.hpp"

#include <fmt/format.h>

#include <optional>

#include "hls/pipeline/static_frames.hpp"
#include "model/formats/recorder.hpp"
#include "model/formats/runtime_formats.hpp"
#include "model/formats/stamps.hpp"
#include "model/objects/merge_impl.hpp"
#include "ref/error.hpp"

namespace halfspace::model {

class StaticRuns::Machine {
 public:
  virtual ~Machine() = default;
  virtual StaticRunResult run(const RawCommand&, const std::vector<RawEntry>* pass, std::vector<StreamWords>*) = 0;
  virtual std::vector<Layout> layouts() const = 0;
};

namespace {

// The buffers, stamp by stamp, and what is asked of them.
template <class F>
class StampMemory {
 public:
  StampMemory(int stamps_x, int stamps_y) : stamps_x_(stamps_x), pixels_(kMostBuffers) {
    for (auto& buffer : pixels_) buffer.resize(std::size_t(stamps_x) * std::size_t(stamps_y));
  }

  void watch(StaticStreams<F>* streams) { streams_ = streams; }
  StampPixels<F> read_stored(const BufferPlace<F>& place) {
    const StampPixels<F> out = at(place);
    streams_->stored_place.write(place), streams_->stored_pixels.write(out);
    return out;
  }
  StampPixels<F> read_drawn(const BufferPlace<F>& place) {
    const StampPixels<F> out = at(place);
    streams_->drawn_place.write(place), streams_->drawn_pixels.write(out);
    return out;
  }
  void keep(const KeptStamp<F>& stamp) {
    at(stamp.place) = stamp.pixels;
    streams_->kept.write(stamp);
  }

 private:
  StampPixels<F>& at(const BufferPlace<F>& place) {
    const std::size_t stamp = std::size_t(raw(place.y)) * std::size_t(stamps_x_) + std::size_t(raw(place.x));
    return pixels_[std::size_t(raw(place.buffer))].at(stamp);
  }

  int stamps_x_;
  std::vector<std::vector<StampPixels<F>>> pixels_;
  StaticStreams<F>* streams_ = nullptr;
};

template <class S>
class MachineOf : public StaticRuns::Machine {
  using F = RuntimeFormats<S>;

 public:
  MachineOf(const Config& config, int width, int height)
      : config_(config),
        width_(width),
        height_(height),
        stamps_x_(stamps_for(width, S::kX)),
        stamps_y_(stamps_for(height, S::kY)) {
    activate();
    buffers_.emplace(stamps_x_, stamps_y_);
  }

  StaticRunResult run(const RawCommand& in, const std::vector<RawEntry>* pass,
                      std::vector<StreamWords>* words) override {
    activate();
    StaticStreams<F> s;
    std::optional<Recorder> recorder;
    if (words) recorder.emplace(s);
    buffers_->watch(&s);
    s.command.write(command(in));
    if (in.passes) send(*pass, in, s.entry);
    static_frames(s, *buffers_);

    StaticRunResult out;
    if (in.sends && in.shows) {
      out.shown.assign(std::size_t(width_) * std::size_t(height_),
                       {ref::full_depth(config_.depth_bits), 0, in.background});
    }
    while (!s.shown.empty()) put_entry<F>(s.shown.read(), width_, height_, out.shown);
    out.count = std::uint64_t(raw(s.found.read().count));
    if (words) *words = recorder->words();
    return out;
  }

  std::vector<Layout> layouts() const override {
    activate();
    StaticStreams<F> s;
    return stream_layouts(s);
  }

 private:
  void activate() const { F::activate(config_, format_table(config_)); }

  static StaticCommand<F> command(const RawCommand& in) {
    const auto bit = [](bool b) { return from_raw<Bit>(b); };
    StaticCommand<F> out;
    out.passes = bit(in.passes), out.anew = bit(in.anew), out.shows = bit(in.shows);
    out.stored = from_raw<BufferNumber<F>>(in.stored);
    out.drawn = from_raw<BufferNumber<F>>(in.drawn);
    out.kept = from_raw<BufferNumber<F>>(in.kept);
    out.x_first = from_raw<typename F::X>(in.box.x0 / F::kLanesX);
    out.x_last = from_raw<typename F::X>((in.box.x1 - 1) / F::kLanesX);
    out.y_first = from_raw<typename F::Y>(in.box.y0 / F::kLanesY);
    out.y_last = from_raw<typename F::Y>((in.box.y1 - 1) / F::kLanesY);
    out.merges = bit(in.merges), out.sends = bit(in.sends);
    out.first = from_raw<typename F::Object>(in.first);
    out.last = from_raw<typename F::Object>(in.last);
    out.r = from_raw<typename F::Colour>(in.background[0]);
    out.g = from_raw<typename F::Colour>(in.background[1]);
    out.b = from_raw<typename F::Colour>(in.background[2]);
    return out;
  }

  // All stamps of a pass.
  void send(const std::vector<RawEntry>& pass, const RawCommand& in, Stream<Entry<F>>& entry) const {
    MergeInput frame;
    frame.width = width_, frame.height = height_, frame.background = in.background;
    for (int y = 0; y < stamps_y_; ++y) {
      for (int x = 0; x < stamps_x_; ++x)
        entry.write(entry_record<F>(pass, frame, x, y, x + 1 == stamps_x_ && y + 1 == stamps_y_));
    }
  }

  const Config config_;
  const int width_, height_, stamps_x_, stamps_y_;
  std::optional<StampMemory<F>> buffers_;
};

}  // namespace

StaticRuns::StaticRuns(const Configuration& configuration, int lanes, int width, int height) {
  if (!has_objects(configuration.config())) {
    throw ref::Error(fmt::format("configuration {} knows no objects: take one with object_bits", configuration.name()));
  }
  machine_ = with_stamp<std::unique_ptr<Machine>>(lanes, [&](auto stamp) -> std::unique_ptr<Machine> {
    return std::make_unique<MachineOf<decltype(stamp)>>(configuration.config(), width, height);
  });
}
StaticRuns::~StaticRuns() = default;

StaticRunResult StaticRuns::run(const RawCommand& command, const std::vector<RawEntry>* pass,
                                std::vector<StreamWords>* streams) {
  return machine_->run(command, pass, streams);
}

std::vector<Layout> StaticRuns::layouts() const { return machine_->layouts(); }

}  // namespace halfspace::model
