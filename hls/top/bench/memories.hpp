// SPDX-License-Identifier: Apache-2.0
// The memories beside the tops, as a bench fills them from the words of a set and reads them.
#ifndef HALFSPACE_HLS_TOP_BENCH_MEMORIES_HPP_
#define HALFSPACE_HLS_TOP_BENCH_MEMORIES_HPP_

#include "hls/top/bench/bench.hpp"

namespace halfspace {

// I-buffer and Z-buffer.
struct Drawn {
  using F = TopFormats;

  void clear() {
    for (auto& stamp : index.index) {
      for (F::Index& pixel : stamp) pixel = from_raw<F::Index>(0);
    }
    for (auto& stamp : depth.depth) {
      for (F::Depth& pixel : stamp) pixel = from_raw<F::Depth>(0);
    }
  }
  void draw(const std::vector<Update<F>>& updates) {
    for (const Update<F>& update : updates) {
      const int address = int(raw(update.y)) * F::kStampsX + int(raw(update.x));
      for (int l = 0; l < F::kLanes; ++l) {
        if (!is_set(update.mask[l])) continue;
        index.index[address][l] = update.index;
        if (F::kStoresDepth) depth.depth[address][l] = update.depth[l];
      }
    }
  }

  TopIndexBuffer index;
  TopDepthBuffer depth;
};

// Lights and materials; a set has words where they change.
struct Lights {
  using F = TopFormats;

  template <class B>
  void load(B& bench) {
    for (const Light<F>& word : bench.template records<Light<F>>("light")) light.light[int(raw(word.light))] = word;
    for (const Material<F>& word : bench.template records<Material<F>>("material")) {
      material.entry[int(raw(word.material))][int(raw(word.light))] = word;
    }
  }

  TopLightTable light;
  TopMaterialTable material;
};

struct Textures {
  using F = TopFormats;

  template <class B>
  void load(B& bench) {
    constexpr int kBanks = TextureMemory<F>::kBanks;
    for (const TextureEntry<F>& word : bench.template records<TextureEntry<F>>("texture")) {
      table.entry[int(raw(word.texture))] = word;
    }
    for (const Texel<F>& word : bench.template records<Texel<F>>("texel")) {
      const int address = int(raw(word.address));
      TexelColour<F>& texel = texels.bank[address % kBanks][address / kBanks];
      texel.r = word.r;
      texel.g = word.g;
      texel.b = word.b;
    }
  }

  TopTextureTable table;
  TopTextureMemory texels;
};

// An entry of TdbS, where there is one.
template <class Record, std::size_t N>
void store(const Record& word, Record (&entries)[N]) {
  if (!is_set(word.empty)) entries[int(raw(word.index)) - 1] = word;
}

template <class F>
ObjectPixel<F> objects_of(const Entry<F>& entry) {
  ObjectPixel<F> out;
  out.last = entry.last;
  out.x = entry.x;
  out.y = entry.y;
  for (int l = 0; l < F::kLanes; ++l) {
    out.depth[l] = entry.depth[l];
    out.object[l] = entry.object[l];
  }
  return out;
}

// The colours of the frame are words of `pixel` or, with objects, of `entry`.
template <class B>
void expect_shown(B& bench, Port<Pixel>& pixel) {
  using F = TopFormats;
  if (!F::kHasObjects) return bench.template expect<Pixel<F>>("pixel", pixel);
  std::vector<Pixel<F>> expected;
  for (const Entry<F>& entry : bench.template records<Entry<F>>("entry")) expected.push_back(entry);
  bench.template expect<Pixel<F>>("entry, colours", pixel, expected);
}
template <class B>
void expect_shaded(B& bench, Port<Pixel>& pixel) {
  using F = TopFormats;
  if (F::kHasTexture) bench.template expect<Pixel<F>>("lit", pixel);
  else expect_shown(bench, pixel);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_TOP_BENCH_MEMORIES_HPP_
