// SPDX-License-Identifier: Apache-2.0
// A key frame in a memory beside a composed top: the blocks of a tile together, row by row, and tiles row by row of as
// many as the frame has.
#ifndef HALFSPACE_HLS_TOP_COMPOSED_KEY_MEMORY_HPP_
#define HALFSPACE_HLS_TOP_COMPOSED_KEY_MEMORY_HPP_

#include "hls/motion/key_cache.hpp"
#include "hls/top/ports/ports.hpp"

namespace halfspace {

// Tiles of a key frame for so many pixels in between.
template <class F>
constexpr int key_tiles(int pixels) {
  return (((pixels - 1) >> F::kLog2Samples) >> kLog2KeyTile) + 1;
}

// As fill_cache asks it.
template <class F>
struct KeyMemory {
  static constexpr int kBlocks = blocks_a_tile(key_side(F::kFilter));
  static constexpr int kWords = key_tiles<F>(F::kWidth) * key_tiles<F>(F::kHeight) * kBlocks;

  HS_INLINE void request(const KeyRequest<F>& tile) {
    at = (int(raw(tile.tile_y)) * tiles_x + int(raw(tile.tile_x))) * kBlocks;
  }
  HS_INLINE TopKeyBlock<F> read() {
    const TopKeyBlock<F> block = blocks[at];
    at = at + 1;
    return block;
  }

  const Words<TopKeyBlock<F>> blocks;
  int tiles_x;
  int at;
};

}  // namespace halfspace

#endif  // HALFSPACE_HLS_TOP_COMPOSED_KEY_MEMORY_HPP_
