// SPDX-License-Identifier: Apache-2.0
// A number whose width is read from a format table while the program runs. Values do not know their width; an operation
// gives an exact integer with its binary point, and a conversion wraps to what the table says of the target.
#ifndef HALFSPACE_MODEL_FORMATS_RUNTIME_FIXED_HPP_
#define HALFSPACE_MODEL_FORMATS_RUNTIME_FIXED_HPP_

#include <cstdint>
#include <type_traits>

#include "hls/formats/format_table.hpp"

namespace halfspace {

// The thread's.
inline thread_local FormatTable runtime_table{};

// What an operation gives: bits · 2^−fraction_bits, no wider than 64 bits (refusal() sees to it).
struct RuntimeResult {
  std::int64_t bits;
  int fraction_bits;

  int fraction() const { return fraction_bits; }
};

constexpr std::int64_t runtime_scale(std::int64_t bits, int by) {
  return by >= 0 ? std::int64_t(std::uint64_t(bits) << by) : bits >> -by;
}

template <NumberFormat FormatTable::*Entry, bool Signed>
struct RuntimeFixed {
  static constexpr bool kSigned = Signed;
  using Carrier = std::conditional_t<Signed, std::int64_t, std::uint64_t>;

  static int width() { return (runtime_table.*Entry).width; }
  static int fraction() { return (runtime_table.*Entry).width - (runtime_table.*Entry).integer; }

  Carrier bits;

  RuntimeFixed() = default;
  template <class Other, class = decltype(std::declval<const Other&>().fraction())>
  RuntimeFixed(const Other& other)
      : bits(wrap(std::uint64_t(runtime_scale(std::int64_t(other.bits), fraction() - other.fraction())))) {}

  template <class Int>
  static RuntimeFixed from_bits(Int bits) {
    RuntimeFixed x;
    x.bits = wrap(std::uint64_t(bits));
    return x;
  }

 private:
  static Carrier wrap(std::uint64_t v) {
    const int spare = 64 - width();
    return Carrier(v << spare) >> spare;
  }
};

template <class T>
struct IsRuntimeNumber : std::false_type {};
template <NumberFormat FormatTable::*E, bool S>
struct IsRuntimeNumber<RuntimeFixed<E, S>> : std::true_type {};
template <>
struct IsRuntimeNumber<RuntimeResult> : std::true_type {};
template <class A, class B, class R>
using IfRuntime = std::enable_if_t<IsRuntimeNumber<A>::value && IsRuntimeNumber<B>::value, R>;

template <NumberFormat FormatTable::*E, bool S>
typename RuntimeFixed<E, S>::Carrier raw(const RuntimeFixed<E, S>& x) {
  return x.bits;
}

// Both operands on the finer grid of the two.
struct RuntimePair {
  std::int64_t a, b;
  int fraction;

  template <class A, class B>
  RuntimePair(const A& x, const B& y) : fraction(x.fraction() > y.fraction() ? x.fraction() : y.fraction()) {
    a = runtime_scale(std::int64_t(x.bits), fraction - x.fraction());
    b = runtime_scale(std::int64_t(y.bits), fraction - y.fraction());
  }
};

template <class A, class B>
IfRuntime<A, B, RuntimeResult> operator+(const A& x, const B& y) {
  const RuntimePair p(x, y);
  return {p.a + p.b, p.fraction};
}
template <class A, class B>
IfRuntime<A, B, RuntimeResult> operator-(const A& x, const B& y) {
  const RuntimePair p(x, y);
  return {p.a - p.b, p.fraction};
}
template <class A, class B>
IfRuntime<A, B, RuntimeResult> operator*(const A& x, const B& y) {
  return {std::int64_t(x.bits) * std::int64_t(y.bits), x.fraction() + y.fraction()};
}
template <class A>
IfRuntime<A, A, RuntimeResult> operator-(const A& x) {
  return {-std::int64_t(x.bits), x.fraction()};
}
#define HS_RUNTIME_COMPARE(op)                                \
  template <class A, class B>                                 \
  IfRuntime<A, B, bool> operator op(const A& x, const B& y) { \
    const RuntimePair p(x, y);                                \
    return p.a op p.b;                                        \
  }
HS_RUNTIME_COMPARE(<)
HS_RUNTIME_COMPARE(<=)
HS_RUNTIME_COMPARE(>)
HS_RUNTIME_COMPARE(>=)
HS_RUNTIME_COMPARE(==)
HS_RUNTIME_COMPARE(!=)
#undef HS_RUNTIME_COMPARE

}  // namespace halfspace

#endif  // HALFSPACE_MODEL_FORMATS_RUNTIME_FIXED_HPP_
