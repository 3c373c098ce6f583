// SPDX-License-Identifier: Apache-2.0
// Where a pixel lies in its texture, and which words of the texture memory it takes. Of state and pixel alone: a tool
// may pipeline texel_fetch() as it is.
#ifndef HALFSPACE_HLS_TEXTURE_TEXEL_FETCH_HPP_
#define HALFSPACE_HLS_TEXTURE_TEXEL_FETCH_HPP_

#include "hls/formats/buffers.hpp"
#include "hls/formats/lanes.hpp"
#include "hls/texture/reciprocal_lookup.hpp"

namespace halfspace {

// Of a pixel in its texture, modulo the sides: where it lies in texels; for a bilinear filter, half a texel to the left
// and above.
template <class F>
struct TexturePosition {
  typename F::TexelPlace u, v;
};

// The bits of `scaled`, moved up by `n`, are a fraction of a repetition; those that leave it are whole ones.
template <class F, class Scaled>
typename F::TexelPlace texel_place(const Scaled& scaled, int n, const typename F::Side& log2_side) {
  using Place = typename F::TexelPlace;
  using Twice = Wider<Place, 1>;  // a bit more behind the point: it rounds
  const int side = int(raw(log2_side)), longest = Place::width() - kWeightBits;
  const Twice twice = shift_right(leading<Twice>(shift_left(scaled, n)), longest - side);
  if (!F::kBilinear) return slice<Place>(twice, 1);
  // Less half a texel, and half of the last weight, for rounding.
  const Place rounded = slice<Place>(twice - from_raw<Twice>((1 << kWeightBits) - 1), 1);
  return low_bits(rounded, side + kWeightBits);
}

template <class F>
TexturePosition<F> texture_position(const TexturePlanes<F>& planes, const TextureEntry<F>& entry, int x, int y) {
  using Coordinate = typename F::Coordinate;
  // Rounded: the starts have the ½.
  const Coordinate s = plane_at<F>(planes.start[0], planes.dx[0], planes.dy[0], x, y);
  const Coordinate t = plane_at<F>(planes.start[1], planes.dx[1], planes.dy[1], x, y);
  const int e = int(raw(planes.repeats));
  TexturePosition<F> position;
  if (F::kPerspective) {
    const Coordinate q = plane_at<F>(planes.start[2], planes.dx[2], planes.dy[2], x, y);
    const InverseCoordinate<F> inverse = reciprocal_lookup<F>(q);
    // s/q = s·y·2^k / 2^(b − 1): of the product the b − 1 + 20 bits behind that point.
    using Scaled = Wider<Coordinate, kInverseFraction - 1>;
    const int n = int(raw(inverse.shift)) + e;
    position.u = texel_place<F>(slice<Scaled>(s * inverse.inverse, 0), n, entry.log2_width);
    position.v = texel_place<F>(slice<Scaled>(t * inverse.inverse, 0), n, entry.log2_height);
  } else {
    position.u = texel_place<F>(s, e, entry.log2_width);
    position.v = texel_place<F>(t, e, entry.log2_height);
  }
  return position;
}

// What a pixel takes of the texture memory: an address in each bank, and what the odd column and the odd row weigh.
using TexelWeight = ufix<kWeightBits + 1, 1>;
template <class F>
struct TexelFetch {
  typename F::TexelAddress address[TextureMemory<F>::kBanks];
  TexelWeight odd_column, odd_row;
};

// The word of bank 0 at a position.
template <class F>
TexelFetch<F> nearest_fetch(const TexturePosition<F>& at, const TextureEntry<F>& entry) {
  using Address = typename F::TexelAddress;
  TexelFetch<F> out{};
  const Address column = slice<Address>(at.u, kWeightBits), row = slice<Address>(at.v, kWeightBits);
  out.address[0] = merged(entry.base, merged(shift_left(row, int(raw(entry.log2_width))), column));
  return out;
}

// Along an axis, of the two texels about a place: half the numbers of the even and of the odd one, and what the odd one
// weighs.
template <class F>
struct TexelPair {
  typename F::TexelAddress half[2];
  TexelWeight odd;
};
template <class F>
TexelPair<F> texel_pair(const typename F::TexelPlace& at, const typename F::Side& log2_side) {
  using Address = typename F::TexelAddress;
  const Address first = slice<Address>(at, kWeightBits);
  const Address next = low_bits(Address(first + from_raw<Address>(1)), int(raw(log2_side)));
  const TexelWeight behind = slice<ufix<kWeightBits, 0>>(at, 0);
  const TexelWeight before = from_raw<TexelWeight>(1 << kWeightBits) - behind;
  const bool is_odd = is_set(slice<Bit>(first, 0));
  TexelPair<F> out;
  out.half[0] = shift_right(select(is_odd, next, first), 1);
  out.half[1] = shift_right(select(is_odd, first, next), 1);
  out.odd = select(is_odd, before, behind);
  return out;
}

// The words of the four texels about a position. Each is in a bank of its own, as two neighbours differ in the parity
// of a column or a row.
template <class F>
TexelFetch<F> bilinear_fetch(const TexturePosition<F>& at, const TextureEntry<F>& entry) {
  using Address = typename F::TexelAddress;
  const TexelPair<F> column = texel_pair<F>(at.u, entry.log2_width), row = texel_pair<F>(at.v, entry.log2_height);
  const Address base = shift_right(entry.base, 2);
  TexelFetch<F> out;
Banks:
  for (int bank = 0; bank < TextureMemory<F>::kBanks; ++bank) {
    HS_UNROLL
    const Address line = shift_right(shift_left(row.half[bank >> 1], int(raw(entry.log2_width))), 1);
    out.address[bank] = merged(base, merged(line, column.half[bank & 1]));
  }
  out.odd_column = column.odd;
  out.odd_row = row.odd;
  return out;
}

// Where a pixel finds its texel: of state and pixel alone.
template <class F>
TexelFetch<F> texel_fetch(const TexturePlanes<F>& planes, const TextureEntry<F>& entry, int x, int y) {
  const TexturePosition<F> at = texture_position<F>(planes, entry, x, y);
  return F::kBilinear ? bilinear_fetch<F>(at, entry) : nearest_fetch<F>(at, entry);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_TEXTURE_TEXEL_FETCH_HPP_
