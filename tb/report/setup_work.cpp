// SPDX-License-Identifier: Apache-2.0
#include "tb/report/setup_work.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <string>

namespace halfspace::tb {
namespace {

constexpr const char* kPurpose = "the cycles of triangle_setup";

// A coordinate of the three vertices of a triangle.
struct Coordinate {
  std::array<const Field*, 3> field;
  int size;  // of the frame, pixels

  Coordinate(const Stream& stream, const char* name, int pixels) : size(pixels) {
    for (int v = 0; v < 3; ++v) field[v] = &stream.need(std::string(name) + char('0' + v), kPurpose);
  }
  std::array<std::int64_t, 3> of(const std::uint32_t* word) const {
    std::array<std::int64_t, 3> at{};
    for (int v = 0; v < 3; ++v) {
      const int unused = 64 - field[v]->width;
      at[v] = std::int64_t(field[v]->raw(word) << unused) >> unused;
    }
    return at;
  }
  bool holds_centre(const std::array<std::int64_t, 3>& at) const {
    const auto [low, high] = std::minmax_element(at.begin(), at.end());
    const int f = field[0]->fraction, half = 1 << (f - 1);
    return std::max<std::int64_t>((*low + half - 1) >> f, 0) <= std::min<std::int64_t>((*high - half) >> f, size - 1);
  }
};

}  // namespace

SetupWork setup_work(const Vectors& vectors, const Words& setup, std::size_t from, std::size_t frame,
                     std::uint64_t interval) {
  SetupWork work;
  const Stream* const numbered = vectors.find("numbered");
  const Stream* const triangle = numbered ? numbered : vectors.find("triangle");
  const Stream* const stream = vectors.find("setup");
  if (!triangle || !stream) return work;
  const Field& empty = stream->need("empty", kPurpose);
  const Frame& size = vectors.frames[frame];
  const Coordinate column(*triangle, "x", int(size.width)), row(*triangle, "y", int(size.height));
  const auto first = triangle->frame_words.begin();
  const std::size_t begin = std::accumulate(first, first + std::ptrdiff_t(frame), std::size_t(0));
  const std::size_t count = std::min(triangle->frame_words[frame], setup.size() - from);
  for (std::size_t n = 0; n < count; ++n) {
    if (!empty.raw(setup[from + n])) {
      work.cycles += interval;
      continue;
    }
    const std::uint32_t* const word = triangle->words[begin + n];
    const auto x = column.of(word), y = row.of(word);
    const bool inside = column.holds_centre(x) && row.holds_centre(y);
    work.cycles += std::min<std::uint64_t>(inside ? 7 : 3, interval);
    work.culled += inside && (x[1] - x[0]) * (y[2] - y[0]) != (y[1] - y[0]) * (x[2] - x[0]);
  }
  return work;
}

}  // namespace halfspace::tb
