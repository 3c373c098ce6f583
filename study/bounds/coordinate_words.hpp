// SPDX-License-Identifier: Apache-2.0
// Coordinates to measure texture and motion on: of a square, from end to end of what the words hold.
#ifndef HALFSPACE_STUDY_BOUNDS_COORDINATE_WORDS_HPP_
#define HALFSPACE_STUDY_BOUNDS_COORDINATE_WORDS_HPP_

#include <cstdint>
#include <random>

#include "hls/formats/config.hpp"

namespace halfspace::model {

// s, t and, in perspective, q of vertex v, with s and t of 0 … q and q of least … most. `kind`, one of four for a
// triangle: 0 has all of them near the least q, with s and t near q.
template <class Words>
void draw_coordinates(Words& words, std::size_t v, std::uint64_t kind, const Config& config, std::int64_t least,
                      std::int64_t most, std::mt19937_64& random) {
  const std::int64_t any = least + std::int64_t(random() % std::uint64_t(most - least + 1));
  const std::int64_t q = !has_perspective(config) ? most
                         : kind == 0              ? least
                         : kind == 1              ? any
                         : random() % 2           ? least + std::int64_t(random() % 3)
                                                  : most;
  for (auto* to : {&words.s, &words.t}) {
    (*to)[v] = int(kind == 0      ? q - std::int64_t(random() % 4)
                   : random() % 2 ? std::int64_t(random() % 2) * q
                                  : std::int64_t(random() % std::uint64_t(q + 1)));
  }
  if (has_perspective(config)) words.q[v] = int(q);
}

}  // namespace halfspace::model

#endif  // HALFSPACE_STUDY_BOUNDS_COORDINATE_WORDS_HPP_
