// SPDX-License-Identifier: Apache-2.0
// The memories beside the tops, as a bench fills them from the words of a set.
#ifndef HALFSPACE_HLS_TOP_BENCH_MEMORIES_HPP_
#define HALFSPACE_HLS_TOP_BENCH_MEMORIES_HPP_

#include "hls/top/bench/bench.hpp"
#include "hls/top/composed/key_memory.hpp"

namespace halfspace {

// I-buffer and Z-buffer.
struct Drawn {
  using F = TopFormats;

  void clear() {
    for (MemoryWord<IndexStamp>& word : index) word = packed(IndexStamp<F>{});
    for (MemoryWord<DepthStamp>& word : depth) word = packed(DepthStamp<F>{});
  }
  void draw(const std::vector<Update<F>>& updates) {
    for (const Update<F>& update : updates) {
      const int address = stamp_address<F>(update.x, update.y);
      IndexStamp<F> stamp = unpacked<IndexStamp<F>>(index[address]);
      for (int l = 0; l < F::kLanes; ++l) {
        if (is_set(update.mask[l])) stamp.lane[l] = update.index;
      }
      index[address] = packed(stamp);
      if (!F::kStoresDepth) continue;
      DepthStamp<F> depths = unpacked<DepthStamp<F>>(depth[address]);
      for (int l = 0; l < F::kLanes; ++l) {
        if (is_set(update.mask[l])) depths.lane[l] = update.depth[l];
      }
      depth[address] = packed(depths);
    }
  }

  MemoryWord<IndexStamp> index[IndexBuffer<F>::kWords];
  MemoryWord<DepthStamp> depth[DepthBuffer<F>::kWords];
};

// Lights and materials; a set has words where they change.
struct Lights {
  using F = TopFormats;

  template <class B>
  void load(B& bench) {
    for (const Light<F>& word : bench.template records<Light<F>>("light")) light[int(raw(word.light))] = packed(word);
    for (const Material<F>& word : bench.template records<Material<F>>("material")) {
      material[int(raw(word.material)) * kMostLights + int(raw(word.light))] = packed(word);
    }
  }

  MemoryWord<Light> light[LightTable<F>::kWords];
  MemoryWord<Material> material[MaterialTable<F>::kWords];
};

struct Textures {
  using F = TopFormats;

  template <class B>
  void load(B& bench) {
    using Memory = TextureMemory<F>;
    for (const TextureEntry<F>& word : bench.template records<TextureEntry<F>>("texture")) {
      table[int(raw(word.texture))] = packed(word);
    }
    for (const Texel<F>& word : bench.template records<Texel<F>>("texel")) {
      const int address = int(raw(word.address));
      TexelColour<F> texel;
      texel.r = word.r;
      texel.g = word.g;
      texel.b = word.b;
      texels[address % Memory::kBanks * Memory::kBankWords + address / Memory::kBanks] = packed(texel);
    }
  }

  MemoryWord<TextureEntry> table[TextureTable<F>::kWords];
  MemoryWord<TexelColour> texels[TextureMemory<F>::kWords];
};

// The tiles of key frames that a set asks for; no other is read.
struct KeyFrames {
  using F = TopFormats;

  template <class B>
  void load(B& bench) {
    load(bench, "key_request_0", "key_block_0", key_0);
    load(bench, "key_request_1", "key_block_1", key_1);
  }

  MemoryWord<TopKeyBlock> key_0[KeyMemory<F>::kWords], key_1[KeyMemory<F>::kWords];

 private:
  template <class B>
  void load(B& bench, const char* requests, const char* blocks, MemoryWord<TopKeyBlock> (&key)[KeyMemory<F>::kWords]) {
    const std::vector<TopKeyBlock<F>> words = bench.template records<TopKeyBlock<F>>(blocks);
    std::size_t n = 0;
    for (const KeyRequest<F>& tile : bench.template records<KeyRequest<F>>(requests)) {
      const int number = int(raw(tile.tile_y)) * key_tiles<F>(bench.size().width) + int(raw(tile.tile_x));
      for (int block = 0; block < KeyMemory<F>::kBlocks; ++block)
        key[number * KeyMemory<F>::kBlocks + block] = packed(words[n++]);
    }
  }
};

// What a set has of TdbS.
template <class R, std::size_t N, class B>
void store_planes(B& bench, const char* stream, Packed<R> (&database)[N]) {
  for (const R& word : bench.template records<R>(stream)) {
    if (!is_set(word.empty)) database[int(raw(word.index)) - 1] = packed(word);
  }
}

// The object of each triangle.
template <std::size_t N, class B>
void store_objects(B& bench, MemoryWord<ObjectEntry> (&objects)[N]) {
  using F = TopFormats;
  for (const Triangle<F>& triangle : bench.template records<Triangle<F>>("triangle")) {
    if (is_set(triangle.index)) objects[int(raw(triangle.index)) - 1] = packed(ObjectEntry<F>{triangle.object});
  }
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
