// SPDX-License-Identifier: Apache-2.0
// The bench of hls/top/bench on several tops of a configuration: HALFSPACE_TOP_LIST is a file with a line X(top) for
// each.
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "hls/top/bench/composed_frames.hpp"
#include "hls/top/bench/film_frames.hpp"
#include "hls/top/bench/frames.hpp"

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: %s TOP VECTORS\n", argv[0]);
    return 2;
  }
#define X(top)                                             \
  if (std::strcmp(argv[1], #top) == 0) {                   \
    halfspace::Bench bench(#top, argv[2], 0);              \
    while (bench.next()) halfspace::frame_of_##top(bench); \
    return bench.close();                                  \
  }
#include HALFSPACE_TOP_LIST
#undef X
  std::fprintf(stderr, "%s has no top %s\n", argv[0], argv[1]);
  return 2;
}
