// SPDX-License-Identifier: Apache-2.0
// A number whose width is read from a format table while the program runs. Values do not know their width; an operation
// gives an exact integer with its binary point, and a conversion wraps to what the table says of the target. The other
// operand may be a number that is compiled.
#ifndef HALFSPACE_MODEL_FORMATS_RUNTIME_FIXED_HPP_
#define HALFSPACE_MODEL_FORMATS_RUNTIME_FIXED_HPP_

#include <cstdint>
#include <type_traits>

#include "hls/formats/format_table.hpp"
#include "hls/numbers/fixed_native.hpp"

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

// Of none.
constexpr NumberFormat FormatTable::*kNoEntry = nullptr;

// More: bits before the point that the table's number does not have. Behind: the number whose bits behind the point it
// has.
template <NumberFormat FormatTable::*Entry, bool Signed, int More = 0, NumberFormat FormatTable::*Behind = Entry>
struct RuntimeFixed {
  static constexpr bool kSigned = Signed;
  static constexpr NumberFormat FormatTable::*kBehind = Behind;
  using Carrier = std::conditional_t<Signed, std::int64_t, std::uint64_t>;
  template <int Bits>
  using Wider = RuntimeFixed<Entry, Signed, More + Bits, Behind>;
  using Whole = RuntimeFixed<Entry, Signed, More, kNoEntry>;
  template <class X>
  using Refined = RuntimeFixed<Entry, Signed, More, X::kBehind>;
  using Unsigned = RuntimeFixed<Entry, false, More, Behind>;

  static int width() {
    if constexpr (Behind == Entry) return (runtime_table.*Entry).width + More;
    else return (runtime_table.*Entry).integer + More + fraction();
  }
  static int fraction() {
    if constexpr (Behind == kNoEntry) return 0;
    else return (runtime_table.*Behind).width - (runtime_table.*Behind).integer;
  }

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
  template <class A, class B>
  static RuntimeFixed from_product(const A& a, const B& b) {
    return from_bits(std::uint64_t(a.bits) * std::uint64_t(b.bits));
  }

 private:
  static Carrier wrap(std::uint64_t v) {
    const int spare = 64 - width();
    return Carrier(v << spare) >> spare;
  }
};

template <class T>
struct IsRuntimeNumber : std::false_type {};
template <NumberFormat FormatTable::*E, bool S, int M, NumberFormat FormatTable::*X>
struct IsRuntimeNumber<RuntimeFixed<E, S, M, X>> : std::true_type {};
template <>
struct IsRuntimeNumber<RuntimeResult> : std::true_type {};
template <class T>
struct IsNumber : IsRuntimeNumber<T> {};
template <int W, int I, bool S>
struct IsNumber<native::Fixed<W, I, S>> : std::true_type {};
template <class A, class B, class R>
using IfRuntime = std::enable_if_t<
    (IsRuntimeNumber<A>::value || IsRuntimeNumber<B>::value) && IsNumber<A>::value && IsNumber<B>::value, R>;

template <NumberFormat FormatTable::*E, bool S, int M, NumberFormat FormatTable::*X>
typename RuntimeFixed<E, S, M, X>::Carrier raw(const RuntimeFixed<E, S, M, X>& x) {
  return x.bits;
}
inline std::int64_t raw(const RuntimeResult& x) { return x.bits; }

// Both operands on the finer grid of the two.
struct RuntimePair {
  std::int64_t a, b;
  int fraction;

  template <class A, class B>
  RuntimePair(const A& x, const B& y) : fraction(x.fraction() > y.fraction() ? x.fraction() : y.fraction()) {
    a = std::int64_t(std::uint64_t(x.bits) << (fraction - x.fraction()));
    b = std::int64_t(std::uint64_t(y.bits) << (fraction - y.fraction()));
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

// What hls/numbers/arithmetic.hpp leaves to each kind of numbers.
template <class T>
IfRuntime<T, T, T> select(bool which, const T& a, const T& b) {
  T result = a;
  result.bits = which ? a.bits : b.bits;
  return result;
}
template <class T>
IfRuntime<T, T, typename T::template Wider<3>> multiple(const T& x, int n) {
  return T::template Wider<3>::from_bits(x.bits * typename T::Carrier(n));
}
template <class T>
IfRuntime<T, T, T> shift_left(const T& x, int n) {
  return T::from_bits(std::uint64_t(x.bits) << n);
}
template <class T>
IfRuntime<T, T, T> shift_right(const T& x, int n) {
  return T::from_bits(x.bits >> n);
}
inline RuntimeResult shift_right(const RuntimeResult& x, int n) { return {x.bits >> n, x.fraction_bits}; }
template <class T>
T round_to(const RuntimeResult& x) {
  return RuntimeResult{x.bits + (std::int64_t(1) << (x.fraction() - T::fraction() - 1)), x.fraction()};
}
template <class T, class A, class B>
IfRuntime<A, B, T> rounded_product(const A& a, const B& b, int n) {
  const __int128 twice = 2 * (__int128(a.bits) * __int128(b.bits));
  return T::from_bits(std::uint64_t(((twice >> n) + 1) >> 1));
}

}  // namespace halfspace

#endif  // HALFSPACE_MODEL_FORMATS_RUNTIME_FIXED_HPP_
