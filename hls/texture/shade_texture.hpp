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
// One pixel after the other goes through one set of planes. Cycles of a stamp in the RTL: its covered lanes, one at
// least. Multipliers there: two for each plane of s, t, q, one in the reciprocal, two with it; a channel three for a
// bilinear filter, which steps from the even column and row to the odd ones, and one for the product.
#ifndef HALFSPACE_HLS_TEXTURE_SHADE_TEXTURE_HPP_
#define HALFSPACE_HLS_TEXTURE_SHADE_TEXTURE_HPP_

#include "hls/formats/buffers.hpp"
#include "hls/formats/lanes.hpp"
#include "hls/texture/reciprocal_lookup.hpp"

namespace halfspace {

// Stores what texture_setup sends, one entry a call. Returns whether it was the last of the frame.
template <class F>
bool store_planes(Stream<TexturePlanes<F>>& planes, TextureDatabase<F>& database) {
  const TexturePlanes<F> in = planes.read();
  if (!raw(in.empty)) database.planes[int(raw(in.index)) - 1] = in;
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

// Of a pixel in its texture, modulo the sides: where it lies in texels; for a bilinear filter, half a texel to the left
// and above.
template <class F>
struct TexturePosition {
  typename F::TexelPlace u, v;
};

// `scaled` · 2^(k + e + log2 side − point) texels, modulo the side.
template <class F>
typename F::TexelPlace texel_place(std::uint64_t scaled, int k, int e, const typename F::Side& log2_side, int point) {
  const int side = int(raw(log2_side));
  // Modulo 2^64: the side of a texture and the fraction are 63 bits at most.
  std::uint64_t place = (scaled << k) << (e + side);
  // Less half a texel, and half of the last weight, for rounding.
  if (F::kBilinear) place += (std::uint64_t(1) << (point - kWeightBits - 1)) - (std::uint64_t(1) << (point - 1));
  const std::uint64_t mask = (std::uint64_t(1) << (side + kWeightBits)) - 1;
  return from_raw<typename F::TexelPlace>(place >> (point - kWeightBits) & mask);
}

template <class F>
TexturePosition<F> texture_position(const TexturePlanes<F>& planes, const TextureEntry<F>& entry, int x, int y) {
  using Coordinate = typename F::Coordinate;
  // Rounded: the starts have the ½.
  const Coordinate s = plane_at<F>(planes.start[0], planes.dx[0], planes.dy[0], x, y);
  const Coordinate t = plane_at<F>(planes.start[1], planes.dx[1], planes.dy[1], x, y);
  const int e = int(raw(planes.repeats)), b = Coordinate::width();
  TexturePosition<F> position;
  if (F::kPerspective) {
    const Coordinate q = plane_at<F>(planes.start[2], planes.dx[2], planes.dy[2], x, y);
    const InverseCoordinate<F> inverse = reciprocal_lookup<F>(q);
    const int k = int(raw(inverse.shift)), point = b - 1 + kInverseFraction;
    const std::uint64_t by = raw(inverse.inverse);
    position.u = texel_place<F>(raw(s) * by, k, e, entry.log2_width, point);
    position.v = texel_place<F>(raw(t) * by, k, e, entry.log2_height, point);
  } else {
    position.u = texel_place<F>(raw(s), 0, e, entry.log2_width, b);
    position.v = texel_place<F>(raw(t), 0, e, entry.log2_height, b);
  }
  return position;
}

template <class F>
struct FilteredTexel {
  typename F::Filtered channel[3];
};

// The texel at a position.
template <class F>
FilteredTexel<F> nearest_texel(const TexturePosition<F>& at, const TextureEntry<F>& entry,
                               const TextureMemory<F>& memory) {
  const int i = int(raw(at.u)) >> kWeightBits, j = int(raw(at.v)) >> kWeightBits;
  const TexelColour<F>& texel = memory.bank[0][int(raw(entry.base)) | j << int(raw(entry.log2_width)) | i];
  FilteredTexel<F> out;
  out.channel[0] = texel.r;
  out.channel[1] = texel.g;
  out.channel[2] = texel.b;
  return out;
}

// Of the four texels about a position, weighted: exact, then rounded once, half up. Each is in a bank of its own, as
// two neighbours differ in the parity of a column or a row.
template <class F>
FilteredTexel<F> bilinear_texel(const TexturePosition<F>& at, const TextureEntry<F>& entry,
                                const TextureMemory<F>& memory) {
  const int one = 1 << kWeightBits, width = int(raw(entry.log2_width)), height = int(raw(entry.log2_height));
  const int left = int(raw(at.u)) >> kWeightBits, top = int(raw(at.v)) >> kWeightBits;
  const int right = (left + 1) & ((1 << width) - 1), bottom = (top + 1) & ((1 << height) - 1);
  const int a = int(raw(at.u)) & (one - 1), b = int(raw(at.v)) & (one - 1);
  std::uint32_t sum[3] = {0, 0, 0};
Banks:
  for (int bank = 0; bank < 4; ++bank) {
    HS_UNROLL
    const bool is_left = (left & 1) == (bank & 1), is_top = (top & 1) == bank >> 1;
    const int column = (is_left ? left : right) >> 1, row = (is_top ? top : bottom) >> 1;
    const TexelColour<F>& texel =
        memory.bank[bank & (TextureMemory<F>::kBanks - 1)][int(raw(entry.base)) >> 2 | row << width >> 1 | column];
    const std::uint32_t weight = std::uint32_t(is_left ? one - a : a) * std::uint32_t(is_top ? one - b : b);
    sum[0] += weight * std::uint32_t(raw(texel.r));
    sum[1] += weight * std::uint32_t(raw(texel.g));
    sum[2] += weight * std::uint32_t(raw(texel.b));
  }
  const int places = 2 * kWeightBits - kFilteredFraction;
  FilteredTexel<F> out;
Channels:
  for (int c = 0; c < 3; ++c) {
    HS_UNROLL
    out.channel[c] = from_raw<typename F::Filtered>((sum[c] + (std::uint32_t(1) << (places - 1))) >> places);
  }
  return out;
}

// lit · texel / (2^c − 1). With 1/(2^c − 1) = 2^−c·(1 + 2^−c + …) cut after its second term the quotient P·2^−c is too
// small by 0 to 2^−c LSB, half of which is added with the ½: of a texel without fraction it is rounded right, as no
// quotient is nearer to a half than ½/(2^c − 1); any other is off by 2^−(c+1) + 2^−(c+8) before rounding.
template <class F>
typename F::Colour textured(const typename F::Colour& lit, const typename F::Filtered& texel) {
  const int c = F::kColourBits, places = c + kFilteredFraction;
  const std::uint32_t product = std::uint32_t(raw(lit)) * std::uint32_t(raw(texel));
  const std::uint32_t half = (std::uint32_t(1) << (places - 1)) + (std::uint32_t(1) << (kFilteredFraction - 1));
  return from_raw<typename F::Colour>((product + (product >> c) + half) >> places);
}

template <class F>
bool shade_texture(Stream<Scan<F>>& scan, Stream<Pixel<F>>& lit, const TextureDatabase<F>& database,
                   const TextureTable<F>& textures, const TextureMemory<F>& memory, Stream<Pixel<F>>& pixel) {
  const Scan<F> in = scan.read();
  Pixel<F> out = lit.read();
  const int x = int(raw(in.x)) << F::kLog2LanesX, y = int(raw(in.y)) << F::kLog2LanesY;
Lanes:
  for (int l = 0; l < F::kLanes; ++l) {
    HS_PIPELINE(1)
    if (raw(in.index[l]) == 0) continue;
    const TexturePlanes<F>& planes = database.planes[int(raw(in.index[l])) - 1];
    if (raw(planes.texture) == 0) continue;
    const TextureEntry<F>& entry = textures.entry[int(raw(planes.texture))];
    const TexturePosition<F> at = texture_position<F>(planes, entry, x + l % F::kLanesX, y + l / F::kLanesX);
    const FilteredTexel<F> texel =
        F::kBilinear ? bilinear_texel<F>(at, entry, memory) : nearest_texel<F>(at, entry, memory);
    out.r[l] = textured<F>(out.r[l], texel.channel[0]);
    out.g[l] = textured<F>(out.g[l], texel.channel[1]);
    out.b[l] = textured<F>(out.b[l], texel.channel[2]);
  }
  pixel.write(out);
  return is_set(in.last);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_TEXTURE_SHADE_TEXTURE_HPP_
