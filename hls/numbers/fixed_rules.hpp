// SPDX-License-Identifier: Apache-2.0
// What the back ends of fixed.hpp have in common: the integer that carries the bits, and the widths of results.
#ifndef HALFSPACE_HLS_NUMBERS_FIXED_RULES_HPP_
#define HALFSPACE_HLS_NUMBERS_FIXED_RULES_HPP_

#include <cstdint>
#include <type_traits>

namespace halfspace {
namespace fixed_detail {

constexpr int max(int a, int b) { return a > b ? a : b; }

template <int W, bool S>
using Carrier = typename std::conditional<(W <= 32), typename std::conditional<S, std::int32_t, std::uint32_t>::type,
                                          typename std::conditional<S, std::int64_t, std::uint64_t>::type>::type;

// Keeps the low W bits of v and extends them to the carrier.
template <int W, bool S, class T>
constexpr Carrier<W, S> wrap(T v) {
  using C = Carrier<W, S>;
  using U = Carrier<W, false>;
  constexpr int kSpare = int(sizeof(C)) * 8 - W;
  return S ? C(C(U(U(v) << kSpare)) >> kSpare) : C(U(U(v) << kSpare) >> kSpare);
}

// A + B and A − B: a carry above the wider of the two, of which the unsigned one needs a sign if the other has one.
template <class A, class B>
struct Sum {
  static constexpr bool kSigned = A::kSigned || B::kSigned;
  static constexpr int kInteger =
      1 + max(A::kInteger + int(B::kSigned && !A::kSigned), B::kInteger + int(A::kSigned && !B::kSigned));
  static constexpr int kFraction = max(A::kFraction, B::kFraction);
  static constexpr int kWidth = kInteger + kFraction;
};

}  // namespace fixed_detail
}  // namespace halfspace

#endif  // HALFSPACE_HLS_NUMBERS_FIXED_RULES_HPP_
