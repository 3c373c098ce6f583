// SPDX-License-Identifier: Apache-2.0
// Where a pixel of a frame in between lies in a key frame, and which of its pixels a filter takes there.
#ifndef HALFSPACE_HLS_MOTION_KEY_PLACE_HPP_
#define HALFSPACE_HLS_MOTION_KEY_PLACE_HPP_

#include "hls/formats/key_records.hpp"
#include "hls/numbers/arithmetic.hpp"
#include "hls/numbers/stream.hpp"

namespace halfspace {

constexpr int kLog2KeyTile = exact_log2(kKeyTile);

// The number of a column or a row of pixels of a key frame: some before the first, some behind the last.
template <class F>
using KeyNumber = Wider<Whole<typename F::KeyPlace>, 2>;

// Pixels of a key frame for so many in between.
template <class F, class Size>
KeyNumber<F> key_pixels(const Size& size) {
  using Number = KeyNumber<F>;
  return shift_right(Number(size + from_raw<Number>((1 << F::kLog2Samples) - 1)), F::kLog2Samples);
}

// Along an axis, the pixels of a filter: N from the first one on, of which some lie inside the frame. The tiles of the
// first and the last of these are the same or neighbours.
template <class Tile, int N>
struct KeyAxis {
  int first;        // the last bits of the first one's number, which tell its tile and its pixel in that apart
  bool inside[N];   // nearest: that of pixel 0 alone
  bool any_inside;  // else the tiles mean nothing
  Tile first_tile, last_tile;
  int fraction;  // of the place, between the centres of two pixels
};

// `size` of the frame, in pixels of it; `pixel` of the frame in between. Of its arguments alone: a tool may pipeline it
// as it is.
template <class F, class Tile, int N, class Pixel>
KeyAxis<Tile, N> key_axis(const KeyNumber<F>& size, const Pixel& pixel, const typename F::Vector& v) {
  using Place = typename F::KeyPlace;
  using Number = KeyNumber<F>;
  using Vector = typename F::Vector;
  const bool nearest = F::kFilter == KeyFilter::kNearest;
  const int g = Place::fraction();
  const Number zero = from_raw<Number>(0), one = from_raw<Number>(1);
  // From where a pixel begins to its centre; of a filter that weighs, less half a pixel of the key frame, which makes
  // the whole part the number of the one whose centre is before the place. In pixels in between, whose point moves.
  const Vector centre = from_raw<Vector>((1 << (F::kVectorFraction - 1)) - (nearest ? 0 : 1 << (g - 1)));
  const Place place = slice<Place>(pixel + v + centre, 0);
  const Whole<Place> before = place;
  const Number first = N == 4 ? Number(before - one) : Number(before);
  const Number last = nearest ? first : Number(first + from_raw<Number>(N - 1));
  const Number from = select(is_negative(first), zero, first), to = select(last < size, last, Number(size - one));

  KeyAxis<Tile, N> axis;
  axis.first = int(raw(slice<ufix<kLog2KeyTile + 1, kLog2KeyTile + 1>>(first, 0)));
  Number at = first;
Inside:
  for (int i = 0; i < N; ++i) {
    HS_UNROLL
    axis.inside[i] = !is_negative(at) && at < size && (i == 0 || !nearest);
    at = at + one;
  }
  axis.any_inside = from <= to;
  axis.first_tile = slice<Tile>(from, kLog2KeyTile);
  axis.last_tile = slice<Tile>(to, kLog2KeyTile);
  axis.fraction = int(raw(low_bits(slice<typename Place::Unsigned>(place, 0), g)));
  return axis;
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_MOTION_KEY_PLACE_HPP_
