// SPDX-License-Identifier: Apache-2.0
// The bench of a top: HALFSPACE_BENCH names it. The vector set is the first argument, or HALFSPACE_BENCH_VECTORS where
// a tool calls it without; the second is how many of its frames, or HALFSPACE_BENCH_FRAMES.
#include <cstdio>
#include <cstdlib>

#include "hls/top/bench/composed_frames.hpp"
#include "hls/top/bench/film_frames.hpp"
#include "hls/top/bench/frames.hpp"

#ifndef HALFSPACE_BENCH_VECTORS
#define HALFSPACE_BENCH_VECTORS nullptr
#endif
#ifndef HALFSPACE_BENCH_FRAMES
#define HALFSPACE_BENCH_FRAMES 0
#endif
#define HS_TEXT_OF(name) #name
#define HS_TEXT(name) HS_TEXT_OF(name)
#define HS_JOIN_OF(a, b) a##b
#define HS_JOIN(a, b) HS_JOIN_OF(a, b)

int main(int argc, char** argv) {
  const char* const vectors = argc > 1 ? argv[1] : HALFSPACE_BENCH_VECTORS;
  if (!vectors) {
    std::fprintf(stderr, "usage: %s VECTORS [FRAMES]: a folder that `halfspace vectors` wrote\n", argv[0]);
    return 2;
  }
  const int frames = argc > 2 ? std::atoi(argv[2]) : HALFSPACE_BENCH_FRAMES;
  halfspace::Bench bench(HS_TEXT(HALFSPACE_BENCH), vectors, frames);
  while (bench.next()) halfspace::HS_JOIN(frame_of_, HALFSPACE_BENCH)(bench);
  return bench.close();
}
