// SPDX-License-Identifier: Apache-2.0
#include "hls/motion/film_scan.hpp"

#include "hls/top/tops.hpp"

using namespace halfspace;

extern "C" void film_scan_top(int width, int height, int red, int green, int blue, int of_key, int slot,
                              MemoryWord<KeyPixel> keys[TopFilmKeys::kWords],
                              MemoryWord<FoundPixel> film[frame_words<TopFormats>()], Port<FilmPixel>& shown) {
  HS_REGISTER_PORT(width)
  HS_REGISTER_PORT(height)
  HS_REGISTER_PORT(red)
  HS_REGISTER_PORT(green)
  HS_REGISTER_PORT(blue)
  HS_REGISTER_PORT(of_key)
  HS_REGISTER_PORT(slot)
  HS_MEMORY_PORT(keys)
  HS_MEMORY_PORT(film)
  HS_STREAM_PORT(shown)
  HS_STARTED
  using F = TopFormats;
  static_assert(F::kUpConverts, "film_scan is of configurations that make films");
  constexpr int kSide = key_side(F::kFilter);
  using Keys = FilmKeys<F, kSide>;
  Frame<F> frame = background_frame(red, green, blue);
  frame.width = from_raw<F::X>(width);
  frame.height = from_raw<F::Y>(height);
  View<FilmPixel> shown_words(shown);
  Keys keys_view = {WordRows<KeyPixel<F>, Keys::kBankWords>(keys)};
  FilmBuffer<F> film_view = {Words<FoundPixel<F>>(film)};
  film_scan<F, kSide>(frame, of_key != 0, slot, keys_view, film_view, shown_words);
}
