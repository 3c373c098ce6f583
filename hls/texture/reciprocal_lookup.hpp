// SPDX-License-Identifier: Apache-2.0
// The reciprocal of a number q of b bits, for a division a pixel:
//
//   k places as far as q·2^k < 2^b,  m = q·2^k / 2^(b−1) in [1, 2),  y = 1/m in (½, 1)
//
// 1/q = y·2^k / 2^(b−1). The field of m after its leading one, cut to 20 bits, names one of 256 segments and a place x
// in it; on a segment 1/m is the line v − s·x, which lies as far above the curve at its ends as below in its middle.
// The line alone is off by (2^−8)²/8 = 2^−19 of y at most, where m is 1; with the cut (2^−20), the last places of v and
// s and the one rounding to 20 bits,
//
//   |y·m − 1| < 2^−18      for every m (texture_kernel_test tries all fields, at both ends of what the cut takes away).
//
// q = 0 gives some y and k.
#ifndef HALFSPACE_HLS_TEXTURE_RECIPROCAL_LOOKUP_HPP_
#define HALFSPACE_HLS_TEXTURE_RECIPROCAL_LOOKUP_HPP_

#include "hls/formats/formats.hpp"
#include "hls/numbers/arithmetic.hpp"

namespace halfspace {

// Bits that name a segment, and a place in it; fraction bits of v and bits of s, which are a word of 36 bits together.
constexpr int kInverseIndexBits = 8, kInverseOffsetBits = 12, kInverseValueFraction = 22, kInverseSlopeBits = 14;
constexpr int kInverseSegments = 1 << kInverseIndexBits;

struct InverseTable {
  std::uint32_t value[kInverseSegments], slope[kInverseSegments];  // v, s
};

// 2^40 / m at m = (512 + i) / 512.
constexpr std::int64_t inverse_sample(int i) {
  const std::int64_t denominator = 2 * kInverseSegments + i;
  return ((std::int64_t(2 * kInverseSegments) << 40) + denominator / 2) / denominator;
}

constexpr InverseTable inverse_table() {
  InverseTable table{};
  const int places = 40 - kInverseValueFraction;
  const std::int64_t half = std::int64_t(1) << (places - 1);
  for (int segment = 0; segment < kInverseSegments; ++segment) {
    const std::int64_t left = inverse_sample(2 * segment), right = inverse_sample(2 * segment + 2);
    const std::int64_t sag = (left + right) / 2 - inverse_sample(2 * segment + 1);
    table.value[segment] = std::uint32_t((left - sag / 2 + half) >> places);
    table.slope[segment] = std::uint32_t((left - right + half) >> places);
  }
  return table;
}

// The words of the table have room for v and s, and a line, rounded, stays below 1.
constexpr bool inverse_table_fits() {
  const InverseTable table = inverse_table();
  const int places = kInverseValueFraction + kInverseOffsetBits - kInverseFraction;
  for (int i = 0; i < kInverseSegments; ++i) {
    const std::uint64_t line =
        (std::uint64_t(table.value[i]) << kInverseOffsetBits) + (std::uint64_t(1) << (places - 1));
    if (table.value[i] >> kInverseValueFraction != 0 || table.slope[i] >> kInverseSlopeBits != 0) return false;
    if (line >> (kInverseValueFraction + kInverseOffsetBits) != 0) return false;
  }
  return true;
}
static_assert(inverse_table_fits(), "an entry of the table of the reciprocal is wider than its word");

template <class F>
struct InverseCoordinate {
  typename F::InverseShift shift;  // k
  typename F::Inverse inverse;     // y
};

template <class F>
InverseCoordinate<F> reciprocal_lookup(const typename F::Coordinate& coordinate) {
  static constexpr InverseTable kTable = inverse_table();
  using Field = ufix<1 + kInverseIndexBits + kInverseOffsetBits, 1 + kInverseIndexBits>;  // with the leading one
  using Segment = ufix<kInverseIndexBits, kInverseIndexBits>;
  using Offset = ufix<kInverseOffsetBits, 0>;  // of a segment
  using Value = ufix<kInverseValueFraction, kInverseValueFraction>;
  using Slope = ufix<kInverseSlopeBits, kInverseSlopeBits>;
  constexpr int kPlaces = kInverseValueFraction + kInverseOffsetBits - kInverseFraction;
  using Half = ufix<kPlaces, kPlaces - kInverseOffsetBits>;

  const Normalized<typename F::Coordinate> normalized = normalize(coordinate);
  const Field field = leading<Field>(normalized.number);
  const int segment = int(raw(slice<Segment>(field, kInverseOffsetBits)));
  const auto line =
      from_raw<Value>(kTable.value[segment]) - from_raw<Slope>(kTable.slope[segment]) * slice<Offset>(field, 0);

  InverseCoordinate<F> result;
  result.shift = from_raw<typename F::InverseShift>(normalized.zeros);
  result.inverse = slice<typename F::Inverse>(line + from_raw<Half>(1 << (kPlaces - 1)), kPlaces);
  return result;
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_TEXTURE_RECIPROCAL_LOOKUP_HPP_
