// SPDX-License-Identifier: Apache-2.0
// A pass of a film through each top that films alone have.
#ifndef HALFSPACE_HLS_TOP_BENCH_FILM_FRAMES_HPP_
#define HALFSPACE_HLS_TOP_BENCH_FILM_FRAMES_HPP_

#include "hls/top/bench/bench.hpp"
#include "hls/top/bench/memories.hpp"
#include "hls/top/tops.hpp"

namespace halfspace {

// What is in the memories of a film, of its words so far.
struct FilmState {
  using F = TopFormats;
  static constexpr int kSide = key_side(F::kFilter);
  using Keys = FilmKeys<F, kSide>;

  // The next pass, but for what it does to holes and found pixels.
  template <class B>
  void begin(B& bench) {
    fills = asks;
    asks = false;
    for (const Asked<F>& word : bench.template records<Asked<F>>("asked")) asks = is_set(word.face);
    const std::vector<ShownPixel<F>> shown = bench.template records<ShownPixel<F>>("shown");
    is_key = !shown.empty() && !fills;
    if (is_key) ++key;
    for (const ShownPixel<F>& word : shown) {
      const int x = int(raw(word.x)), y = int(raw(word.y));
      KeyPixel<F> pixel;
      pixel.r = word.r, pixel.g = word.g, pixel.b = word.b, pixel.face = word.face;
      const int bank = key_bank<kSide>(x, y), address = key_address<F, kSide>(key % kKeySlots, x, y);
      if (is_key) keys[bank * Keys::kBankWords + address] = packed(pixel);
      else if (is_set(word.shown)) find(x, y, word.r, word.g, word.b);
    }
  }
  // What hole_find makes of a frame in between.
  template <class B>
  void find_holes(B& bench) {
    const std::vector<Motion<F>> ordered = bench.template records<Motion<F>>("ordered");
    const std::vector<Compensated<F>> made = bench.template records<Compensated<F>>("compensated");
    for (std::size_t n = 0; n < made.size(); ++n) {
      const int x = int(raw(made[n].x)), y = int(raw(made[n].y));
      if (is_set(made[n].keys)) find(x, y, made[n].r, made[n].g, made[n].b);
      else if (is_set(ordered[n].face)) mark(x, y);
    }
  }
  void find(int x, int y, const F::Colour& r, const F::Colour& g, const F::Colour& b) {
    FoundPixel<F> pixel;
    pixel.shown = from_raw<Bit>(1);
    pixel.r = r, pixel.g = g, pixel.b = b;
    film[pixel_address<F>(x, y)] = packed(pixel);
  }
  void mark(int x, int y) {
    const auto stamp_x = from_raw<F::X>(x >> F::kLog2LanesX);
    const auto stamp_y = from_raw<F::Y>(y >> F::kLog2LanesY);
    MemoryWord<HoleStamp>& word = holes[stamp_address<F>(stamp_x, stamp_y)];
    HoleStamp<F> stamp = unpacked<HoleStamp<F>>(word);
    stamp.lane[(y % F::kLanesY << F::kLog2LanesX) + x % F::kLanesX] = from_raw<Bit>(1);
    word = packed(stamp);
  }
  void clear_holes() {
    for (MemoryWord<HoleStamp>& word : holes) word = packed(HoleStamp<F>{});
  }
  void clear_found() {
    for (MemoryWord<FoundPixel>& word : film) word = packed(FoundPixel<F>{});
  }

  FilmState() {
    clear_holes(), clear_found();
    for (MemoryWord<KeyPixel>& word : keys) word = packed(KeyPixel<F>{});
  }

  bool fills = false, asks = false, is_key = false;  // of this pass; asks: the next one fills
  int key = -1;                                      // number of the last key frame
  MemoryWord<HoleStamp> holes[HoleMarks<F>::kWords];
  MemoryWord<FoundPixel> film[frame_words<F>()];
  MemoryWord<KeyPixel> keys[TopFilmKeys::kWords];
};

template <class B>
void frame_of_pixel_store(B& bench) {
  using F = TopFormats;
  static MemoryWord<FaceEntry> faces[FaceTable<F>::kWords];
  for (const Triangle<F>& triangle : bench.template records<Triangle<F>>("triangle")) {
    if (!is_set(triangle.index)) continue;
    FaceEntry<F> entry;
    entry.face = triangle.face;
    faces[int(raw(triangle.index)) - 1] = packed(entry);
  }
  if (bench.template records<Pixel<F>>("pixel").empty()) return;
  Port<Scan> scan;
  Port<Pixel> pixel;
  Port<ShownPixel> shown;
  bench.template send<Scan<F>>("masked", scan);
  bench.template send<Pixel<F>>("pixel", pixel);
  pixel_store_top(bench.size().width, bench.size().height, faces, scan, pixel, shown);
  bench.template expect<ShownPixel<F>>("shown", shown);
}

template <class B>
void frame_of_motion_order(B& bench) {
  using F = TopFormats;
  static MemoryWord<Motion> buffer[frame_words<F>()], empty[frame_words<F>()];
  static bool begins = true;
  const Motion<F> none{};
  for (int n = 0; begins && n < frame_words<F>(); ++n) buffer[n] = empty[n] = packed(none);
  begins = false;
  if (bench.template records<Motion<F>>("motion").empty()) return;
  Port<Motion> motion, ordered;
  bench.template send<Motion<F>>("motion", motion);
  motion_order_top(bench.size().width, bench.size().height, buffer, motion, ordered);
  bench.template expect<Motion<F>>("ordered", ordered);
  bench.expect("motion buffer", buffer, empty);
}

template <class B>
void frame_of_hole_find(B& bench) {
  using F = TopFormats;
  static FilmState got, expected;
  if (bench.template records<Motion<F>>("ordered").empty()) return;
  for (FilmState* state : {&got, &expected}) state->clear_holes(), state->clear_found();
  expected.find_holes(bench);
  Port<Motion> ordered;
  Port<Compensated> compensated;
  Port<Asked> asked;
  bench.template send<Motion<F>>("ordered", ordered);
  bench.template send<Compensated<F>>("compensated", compensated);
  hole_find_top(got.film, got.holes, ordered, compensated, asked);
  bench.template expect<Asked<F>>("asked", asked);
  bench.expect("film buffer", got.film, expected.film);
  bench.expect("hole marks", got.holes, expected.holes);
}

template <class B>
void frame_of_hole_scan(B& bench) {
  using F = TopFormats;
  static FilmState state, cleared;
  state.begin(bench);
  Port<Scan> scan, masked;
  bench.template send<Scan<F>>("scan", scan);
  hole_scan_top(state.fills, state.holes, scan, masked);
  bench.template expect<Scan<F>>("masked", masked);
  bench.expect("hole marks", state.holes, cleared.holes);
  state.find_holes(bench);
}

// As many frames of the film as come out behind the pass.
template <class B>
void frame_of_film_scan(B& bench) {
  using F = TopFormats;
  static FilmState state;
  state.begin(bench);
  state.find_holes(bench);
  const std::size_t words = bench.template records<FilmPixel<F>>("film").size();
  const int width = bench.size().width, height = bench.size().height;
  const int frames = int(words) / (width * height);
  const int(&background)[3] = bench.size().background;
  Port<FilmPixel> film;
  for (int n = 0; n < frames; ++n) {
    film_scan_top(width, height, background[0], background[1], background[2], state.is_key || n == 1,
                  state.key % kKeySlots, state.keys, state.film, film);
  }
  bench.template expect<FilmPixel<F>>("film", film);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_TOP_BENCH_FILM_FRAMES_HPP_
