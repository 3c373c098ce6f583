// SPDX-License-Identifier: Apache-2.0
#include "hls/motion/hole_find.hpp"

#include "hls/top/tops.hpp"

using namespace halfspace;

extern "C" void hole_find_top(MemoryWord<FoundPixel> film[frame_words<TopFormats>()],
                              MemoryWord<HoleStamp> holes[HoleMarks<TopFormats>::kWords], Port<Motion>& ordered,
                              Port<Compensated>& compensated, Port<Asked>& asked) {
  HS_MEMORY_PORT(film)
  HS_MEMORY_PORT(holes)
  HS_STREAM_PORT(ordered)
  HS_STREAM_PORT(compensated)
  HS_STREAM_PORT(asked)
  HS_STARTED
  using F = TopFormats;
  static_assert(F::kUpConverts, "hole_find is of configurations that make films");
  View<Motion> ordered_words(ordered);
  View<Compensated> compensated_words(compensated);
  View<Asked> asked_words(asked);
  FilmBuffer<F> film_view = {Words<FoundPixel<F>>(film)};
  HoleMarks<F> holes_view = {Words<HoleStamp<F>>(holes)};
  hole_find_frame(ordered_words, compensated_words, film_view, holes_view, asked_words);
}
