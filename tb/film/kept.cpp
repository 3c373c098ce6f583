// SPDX-License-Identifier: Apache-2.0
#include "tb/film/kept.hpp"

#include <algorithm>
#include <initializer_list>

#include "tb/harness/channel.hpp"
#include "tb/harness/plan.hpp"

namespace halfspace::tb {
namespace {

constexpr int kTile = 8;  // pixels, each way

// Calls put(x, y, word) for the words of a pass whose flag is set.
template <class Put>
void each_pixel(const Vectors& vectors, const char* name, const char* flag, std::size_t frame, Put put) {
  const Stream& stream = need_stream(vectors, name);
  const char* const purpose = "the bench of a film's memories";
  const Field &x = stream.need("x", purpose), &y = stream.need("y", purpose), &set = stream.need(flag, purpose);
  const Segment words = segment_of(stream, frame);
  for (std::size_t n = words.begin; n < words.end; ++n) {
    const std::uint32_t* const word = stream.words[n];
    if (set.raw(word)) put(std::size_t(x.raw(word)), std::size_t(y.raw(word)), word);
  }
}

// Fields of a word side by side, the first one on top.
class Joined {
 public:
  Joined(const Stream& stream, std::initializer_list<const char*> names) {
    for (const char* const name : names) fields_.insert(fields_.begin(), &stream.need(name, "the bench of a film"));
  }
  const std::uint32_t* operator()(const std::uint32_t* word, bool on_top = false) {
    std::uint64_t value = 0;
    int at = 0;
    for (const Field* const field : fields_) {
      value |= field->raw(word) << at;
      at += field->width;
    }
    value |= std::uint64_t(on_top) << at;
    parts_[0] = std::uint32_t(value);
    parts_[1] = std::uint32_t(value >> 32);
    return parts_;
  }

 private:
  std::vector<const Field*> fields_;
  std::uint32_t parts_[2] = {0, 0};
};

// A key frame has whole tiles, in blocks of side × side.
std::size_t block_of(const Model& model, std::size_t x, std::size_t y, std::size_t side) {
  const std::size_t tiles = std::size_t(model.constant("MaxWidth") + kTile - 1) / kTile;
  return y / side * (tiles * kTile / side) + x / side;
}

// Of the key frame that was drawn last.
int slot_of(const Vectors& vectors, std::size_t frame) {
  const auto end = vectors.frames.begin() + std::ptrdiff_t(frame) + 1;
  return int(std::count_if(vectors.frames.begin(), end, [](const Frame& pass) { return pass.pass == "key"; }) - 1) % 2;
}

}  // namespace

void Kept::prepare(const Model& model, const Vectors& vectors, std::size_t frame) {
  if (!begun_) {
    if (marks_) marks_->clear(0);
    if (film_) film_->clear(0);
    // Of frames in between and their holes nothing is left but of this one.
    const auto stays = [&](std::size_t pass) {
      return vectors.frames[pass].pass == "key" || (pass + 1 == frame && vectors.frames[frame].pass == "fill");
    };
    for (std::size_t pass = 0; film_ && pass < frame; ++pass) {
      if (stays(pass)) store(model, vectors, pass);
    }
    begun_ = true;
  }
  const std::size_t width = std::size_t(model.constant("MaxWidth"));
  if (marks_ && frame > 0) {
    const std::size_t lanes_x = std::size_t(vectors.lanes_x), lanes_y = std::size_t(vectors.lanes_y);
    const std::uint32_t set = 1;
    each_pixel(vectors, "between", "hole", frame - 1, [&](std::size_t x, std::size_t y, const std::uint32_t*) {
      const std::size_t lane = y % lanes_y * lanes_x + x % lanes_x;
      marks_->write(0, y / lanes_y * ((width + lanes_x - 1) / lanes_x) + x / lanes_x, std::uint64_t(1) << lane,
                    vectors.lanes(), &set, false);
    });
  }
  if (film_) store(model, vectors, frame);
}

void Kept::store(const Model& model, const Vectors& vectors, std::size_t frame) const {
  const std::size_t width = std::size_t(model.constant("MaxWidth"));
  const Frame& pass = vectors.frames[frame];
  const Stream& shown = need_stream(vectors, "shown");
  Joined key(shown, {"r", "g", "b", "face"}), filled(shown, {"r", "g", "b"});
  Joined between(need_stream(vectors, "between"), {"r", "g", "b"});
  if (pass.pass == "key") {
    const std::size_t side = std::size_t(model.constant("KeySide"));
    const Segment words = segment_of(shown, frame);
    const Field &x = shown.need("x", "a film"), &y = shown.need("y", "a film");
    for (std::size_t n = words.begin; n < words.end; ++n) {
      const std::uint32_t* const word = shown.words[n];
      const std::size_t px = std::size_t(x.raw(word)), py = std::size_t(y.raw(word));
      keys_->write(slot_of(vectors, frame), block_of(model, px, py, side),
                   std::uint64_t(1) << (py % side * side + px % side), int(side * side), key(word), false);
    }
  } else if (pass.pass == "fill") {
    each_pixel(vectors, "shown", "shown", frame, [&](std::size_t x, std::size_t y, const std::uint32_t* word) {
      film_->write(0, y * width + x, 1, 1, filled(word, true), true);
    });
  } else {
    each_pixel(vectors, "between", "shown", frame, [&](std::size_t x, std::size_t y, const std::uint32_t* word) {
      film_->write(0, y * width + x, 1, 1, between(word, true), true);
    });
  }
}

std::vector<std::uint32_t> Kept::shows(const Vectors& vectors, std::size_t frame) const {
  const Stream& stream = need_stream(vectors, "film");
  const Field& last = stream.need("last", "the bench of film_scan");
  const Segment words = segment_of(stream, frame);
  std::vector<std::uint32_t> tokens;
  for (std::size_t n = words.begin; n < words.end; ++n) {
    if (!last.raw(stream.words[n])) continue;
    // Of a frame in between the film buffer, and then the second key of its interval.
    const bool from_film = vectors.frames[frame].pass != "key" && tokens.empty();
    tokens.push_back(from_film ? 2 : std::uint32_t(slot_of(vectors, frame)));
  }
  return tokens;
}

}  // namespace halfspace::tb
