// SPDX-License-Identifier: Apache-2.0
// The reciprocal of a length, from its square q, a number of an even count T of bits:
//
//   k places as far as q·4^k < 2^T,  m = q·4^k / 2^(T−2) in [1, 4),  y = 1/√m in (½, 1)
//
// 1/√q = y·2^k / 2^(T/2−1). The field of m after its leading one, cut to 19 bits, names one of 128 segments an octave
// and a place x in it; on a segment 1/√m is the line v − s·x, which lies as far above the curve in its middle as below
// at its ends. The line alone is off by 3/4 · 2^−14 / 16 of y at most; with the cut, the last places of v and s and the
// one rounding to 18 bits,
//
//   |y·√m − 1| < 2^−17      for every m (lighting_test tries all fields, at both ends of what the cut takes away).
//
// q = 0 gives some y and k.
#ifndef HALFSPACE_HLS_SHADE_RECIPROCAL_SQRT_HPP_
#define HALFSPACE_HLS_SHADE_RECIPROCAL_SQRT_HPP_

#include "hls/formats/formats.hpp"
#include "hls/numbers/arithmetic.hpp"

namespace halfspace {

// Bits that name a segment of an octave, and a place in it; fraction bits of v and s, which are a word of 32 bits
// together.
constexpr int kRootIndexBits = 7, kRootOffsetBits = 12, kRootValueFraction = 20, kRootSlopeBits = 12;
constexpr int kRootSegments = 2 << kRootIndexBits;  // of m in [1, 2), then of m in [2, 4)

struct RootTable {
  std::uint32_t value[kRootSegments], slope[kRootSegments];  // v, s
};

// floor(√n)
constexpr std::uint64_t integer_sqrt(std::uint64_t n) {
  std::uint64_t root = 0;
  for (int bit = 31; bit >= 0; --bit) {
    const std::uint64_t next = root | std::uint64_t(1) << bit;
    if (next * next <= n) root = next;
  }
  return root;
}

// 2^28 / √m at m = 2^octave · (256 + i) / 256.
constexpr std::int64_t root_sample(int octave, int i) {
  return std::int64_t(integer_sqrt((~std::uint64_t(0) >> octave) / std::uint64_t(kRootSegments + i)));
}

constexpr RootTable root_table() {
  RootTable table{};
  const int places = 28 - kRootValueFraction;
  const std::int64_t half = std::int64_t(1) << (places - 1);
  // Rounded to kRootFraction bits, v is less than 1.
  const std::int64_t largest = (std::int64_t(1) << kRootValueFraction) - 3;
  for (int segment = 0; segment < kRootSegments; ++segment) {
    const int octave = segment >> kRootIndexBits, at = 2 * (segment % (1 << kRootIndexBits));
    const std::int64_t left = root_sample(octave, at), middle = root_sample(octave, at + 1),
                       right = root_sample(octave, at + 2);
    const std::int64_t sag = (left + right) / 2 - middle;
    const std::int64_t value = (left - sag / 2 + half) >> places;
    table.value[segment] = std::uint32_t(value < largest ? value : largest);
    table.slope[segment] = std::uint32_t((left - right + half) >> places);
  }
  return table;
}

// The words of the table have room for v and s, and a line, rounded, stays below 1.
constexpr bool root_table_fits() {
  const RootTable table = root_table();
  const int places = kRootValueFraction + kRootOffsetBits - kRootFraction;
  for (int i = 0; i < kRootSegments; ++i) {
    const std::uint64_t line = (std::uint64_t(table.value[i]) << kRootOffsetBits) + (std::uint64_t(1) << (places - 1));
    if (table.value[i] >> kRootValueFraction != 0 || table.slope[i] >> kRootSlopeBits != 0) return false;
    if (line >> (kRootValueFraction + kRootOffsetBits) != 0) return false;
  }
  return true;
}
static_assert(root_table_fits(), "an entry of the table of the reciprocal root is wider than its word");

template <class F>
struct ReciprocalRoot {
  typename F::RootShift shift;  // k
  typename F::Root root;        // y
};

template <class F>
ReciprocalRoot<F> reciprocal_sqrt(const typename F::SquaredLength& length) {
  using Length = typename F::SquaredLength;
  static constexpr RootTable kTable = root_table();
  const int top = Length::width() - 1;
  Length q = length;
  int shift = 0;
Normalize:
  for (int step = 16; step > 0; step /= 2) {
    HS_UNROLL
    if (2 * step <= top) {
      const bool shifts = is_zero(shift_right(q, top + 1 - 2 * step));
      q = select(shifts, shift_left(q, 2 * step), q);
      shift += shifts ? step : 0;
    }
  }
  const bool octave = !is_zero(shift_right(q, top));
  // The leading one at `top`, and the field below it.
  const Length m = select(octave, q, shift_left(q, 1));
  const auto index = slice<ufix<kRootIndexBits, kRootIndexBits>>(m, top - kRootIndexBits);
  const int segment = int(octave) << kRootIndexBits | int(raw(index));
  const auto offset = slice<ufix<kRootOffsetBits, kRootOffsetBits>>(m, top - kRootIndexBits - kRootOffsetBits);
  const auto slope = from_raw<ufix<kRootSlopeBits, kRootSlopeBits>>(kTable.slope[segment]);
  // The slope is of 2^−kRootValueFraction, and a place in a segment of 2^−kRootOffsetBits.
  using Fall = ufix<kRootValueFraction + kRootOffsetBits, 0>;
  const auto line = from_raw<ufix<kRootValueFraction, 0>>(kTable.value[segment]) - slice<Fall>(slope * offset, 0);

  ReciprocalRoot<F> result;
  result.shift = from_raw<typename F::RootShift>(shift);
  result.root = round_to<typename F::Root>(line);
  return result;
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_SHADE_RECIPROCAL_SQRT_HPP_
