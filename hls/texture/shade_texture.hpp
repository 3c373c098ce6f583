// SPDX-License-Identifier: Apache-2.0
// Texture at scan-out (index rendering): what a pixel looks like without it, times the texel that it shows. Textures
// repeat, and their sides are powers of two.
//
//   perspective   (U, V) = (s·W, t·H)·2^e / q      affine   (U, V) = (s·W, t·H)·2^e / 2^b      in texels, modulo W, H
//
// s, t, q are the planes at the pixel, rounded to whole numbers. The product with the reciprocal of q is kept whole,
// and shifted by k, e and log2 of the side until its whole part is that of texels. It is then cut: at whole texels, for
// the nearest; or half a texel to the left, rounded to 8 bits, which are the weights of the two texels on either side.
// Where a pixel lies among texels is derived, with its bound, in docs/numerics.md.
//
// One pixel after the other goes through one set of planes. Multipliers of the RTL: two for each plane of s, t, q, one
// in the reciprocal, two with it; a channel three for a bilinear filter, which steps from the even column and row to
// the odd ones, and one for the product.
//
// Interval: a cycle a covered lane; one for a stamp of background.
#ifndef HALFSPACE_HLS_TEXTURE_SHADE_TEXTURE_HPP_
#define HALFSPACE_HLS_TEXTURE_SHADE_TEXTURE_HPP_

#include "hls/formats/scan_pixels.hpp"
#include "hls/texture/texel_fetch.hpp"
#include "hls/texture/texel_filter.hpp"

namespace halfspace {

// Stores what texture_setup sends, one entry a call. Returns whether it was the last of the frame.
template <class F>
bool store_planes(Stream<TexturePlanes<F>>& planes, TextureDatabase<F>& database) {
  const TexturePlanes<F> in = planes.read();
  if (!is_set(in.empty)) database.planes[int(raw(in.index)) - 1] = in;
  return is_set(in.last);
}
template <class F>
void store_texture(Stream<TextureEntry<F>>& textures, TextureTable<F>& table) {
  const TextureEntry<F> in = textures.read();
  table.entry[int(raw(in.texture))] = in;
}
template <class F>
void store_texel(Stream<Texel<F>>& texels, TextureMemory<F>& memory) {
  const Texel<F> in = texels.read();
  const int address = int(raw(in.address));
  TexelColour<F> colour;
  colour.r = in.r;
  colour.g = in.g;
  colour.b = in.b;
  constexpr int kBanks = TextureMemory<F>::kBanks;
  if (F::kBilinear) memory.bank[address & (kBanks - 1)][address >> 2] = colour;
  else memory.bank[0][address] = colour;
}

// Lane l of a stamp.
template <class F>
void texture_lane(const Scan<F>& in, int l, const TextureDatabase<F>& database, const TextureTable<F>& textures,
                  const TextureMemory<F>& memory, Pixel<F>& pixel) {
  constexpr int kBanks = TextureMemory<F>::kBanks;
  if (!is_set(in.index[l])) return;
  const TexturePlanes<F>& planes = database.planes[int(raw(in.index[l])) - 1];
  if (!is_set(planes.texture)) return;
  const TextureEntry<F>& entry = textures.entry[int(raw(planes.texture))];
  const PixelPlace at = lane_place(in, l);
  const TexelFetch<F> fetch = texel_fetch<F>(planes, entry, at.x, at.y);
  TexelColour<F> texel[kBanks];
Banks:
  for (int bank = 0; bank < (F::kBilinear ? kBanks : 1); ++bank) {
    HS_UNROLL
    texel[bank] = memory.bank[bank][int(raw(fetch.address[bank]))];
  }
  TexelColour<F> colour;
  colour.r = pixel.r[l];
  colour.g = pixel.g[l];
  colour.b = pixel.b[l];
  colour = textured_pixel<F>(colour, fetch, texel);
  pixel.r[l] = colour.r;
  pixel.g[l] = colour.g;
  pixel.b[l] = colour.b;
}

template <class F>
bool shade_texture(Stream<Scan<F>>& scan, Stream<Pixel<F>>& lit, const TextureDatabase<F>& database,
                   const TextureTable<F>& textures, const TextureMemory<F>& memory, Stream<Pixel<F>>& pixel) {
  const Scan<F> in = scan.read();
  Pixel<F> out = lit.read();
Pixels:
  for (int l = 0; l < F::kLanes; ++l) {
    HS_PIPELINE(1)
    texture_lane(in, l, database, textures, memory, out);
  }
  pixel.write(out);
  return is_set(in.last);
}

// All stamps. A turn takes a covered lane, or a stamp without one: the first of a stamp reads it, and the last writes
// its pixels.
template <class F>
void shade_texture_frame(Stream<Scan<F>>& scan, Stream<Pixel<F>>& lit, const TextureDatabase<F>& database,
                         const TextureTable<F>& textures, const TextureMemory<F>& memory, Stream<Pixel<F>>& pixel) {
  Scan<F> in{};
  Pixel<F> out{};
  int lane = 0;
  bool starts = true, done = false;
Turns:
  while (!done) {
    HS_PIPELINE(1)
    if (starts) {
      in = scan.read();
      out = lit.read();
      lane = covered_lane(in, 0);
    }
    if (lane < F::kLanes) texture_lane(in, lane, database, textures, memory, out);
    lane = covered_lane(in, lane + 1);
    starts = lane == F::kLanes;
    if (starts) pixel.write(out);
    done = starts && is_set(in.last);
  }
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_TEXTURE_SHADE_TEXTURE_HPP_
