// SPDX-License-Identifier: Apache-2.0
// The numbers that this program is compiled with against the native ones: 256 random formats in pairs, and every
// operator and conversion between the two of a pair, on extreme and on random values.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "hls/numbers/fixed.hpp"
#include "hls/numbers/fixed_native.hpp"

namespace halfspace::tests {
namespace {

struct Format {
  int width, integer;
  bool is_signed;
};

constexpr int kPairs = 128;

// Two of three formats are short enough for every operator; the others have up to 64 bits.
constexpr std::array<Format, 2 * kPairs> random_formats() {
  std::array<Format, 2 * kPairs> formats{};
  std::uint64_t state = 1;
  auto below = [&state](int n) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return int((state >> 33) % std::uint64_t(n));
  };
  for (int k = 0; k < 2 * kPairs; ++k) {
    const int width = 1 + below(k / 2 % 3 == 2 ? 64 : 32);
    formats[k] = {width, below(width + 1), below(2) != 0};
  }
  return formats;
}
constexpr auto kFormats = random_formats();

// Bits of a number of this format, the extreme ones first.
constexpr int kValues = 18;
std::vector<std::int64_t> values(const Format& format, std::mt19937_64& random) {
  const std::uint64_t top = std::uint64_t(1) << (format.width - 1);
  std::vector<std::int64_t> bits = {0, 1, -1, std::int64_t(top), std::int64_t(top - 1), std::int64_t(top / 3)};
  while (bits.size() < kValues) bits.push_back(std::int64_t(random()));
  return bits;
}

struct Result {
  const char* what;
  int width, integer;
  bool is_signed;
  std::int64_t bits;

  bool operator==(const Result& other) const {
    return width == other.width && integer == other.integer && is_signed == other.is_signed && bits == other.bits;
  }
};
std::ostream& operator<<(std::ostream& out, const Result& r) {
  const char* const sign = r.is_signed ? " signed" : " unsigned";
  return out << r.what << " = " << r.bits << " in " << r.width << ", " << r.integer << sign;
}

// What pair K gives on numbers of one kind.
template <template <int, int, bool> class Number, int K>
std::vector<Result> evaluate(std::int64_t bits_a, std::int64_t bits_b) {
  constexpr Format f = kFormats[2 * K], g = kFormats[2 * K + 1];
  using A = Number<f.width, f.integer, f.is_signed>;
  using B = Number<g.width, g.integer, g.is_signed>;
  constexpr bool kSum = fixed_detail::Sum<A, B>::kWidth <= 64;

  std::vector<Result> results;
  auto add = [&](const char* what, const auto& x) {
    using T = std::decay_t<decltype(x)>;
    results.push_back({what, T::kWidth, T::kInteger, T::kSigned, std::int64_t(raw(x))});
  };
  auto add_order = [&](const char* what, bool x) { results.push_back({what, 1, 1, false, x}); };

  const A a = from_raw<A>(bits_a);
  const B b = from_raw<B>(bits_b);
  add("a", a);
  add("b", b);
  const A a_of_b = b;
  add("A(b)", a_of_b);
  B assigned = b;
  assigned = a;
  add("B(a)", assigned);
  if constexpr (kSum) {
    add("a + b", a + b);
    add("a - b", a - b);
    add("b - a", b - a);
    add("A(a + b)", A(a + b));
    add("B(a - b)", B(a - b));
  }
  if constexpr (f.width + g.width <= 64) {
    add("a * b", a * b);
    add("A(a * b)", A(a * b));
  }
  if constexpr (f.is_signed && f.width < 64) add("-a", -a);
  if constexpr (kSum && f.is_signed == g.is_signed) {
    add_order("a < b", a < b);
    add_order("a <= b", a <= b);
    add_order("a > b", a > b);
    add_order("a >= b", a >= b);
    add_order("a == b", a == b);
    add_order("A(b) == b", a_of_b == b);
    add_order("A(b) != b", a_of_b != b);
  }
  return results;
}

using Counts = std::map<std::string, int>;

void expect_equal(const std::vector<Result>& native, const std::vector<Result>& here, Counts& counts) {
  EXPECT_EQ(native, here);
  for (const Result& result : here) ++counts[result.what];
}

template <int K>
void expect_pair(std::mt19937_64& random, Counts& counts) {
  const auto bits_a = values(kFormats[2 * K], random), bits_b = values(kFormats[2 * K + 1], random);
  for (const std::int64_t a : bits_a) {
    for (const std::int64_t b : bits_b) {
      expect_equal(evaluate<native::Fixed, K>(a, b), evaluate<Fixed, K>(a, b), counts);
    }
  }
}

template <int... K>
void expect_pairs(std::mt19937_64& random, Counts& counts, std::integer_sequence<int, K...>) {
  (expect_pair<K>(random, counts), ...);
}

TEST(Types, AgreeWithTheNativeOnes) {
  std::mt19937_64 random(1);
  Counts counts;
  expect_pairs(random, counts, std::make_integer_sequence<int, kPairs>{});
  // No operator is left out by formats that are too wide for it.
  const int values_a_pair = kValues * kValues;
  EXPECT_EQ(counts["a"], kPairs * values_a_pair);
  for (const char* what : {"A(b)", "B(a)", "a + b", "a - b", "a * b", "-a", "a < b", "a == b"}) {
    EXPECT_GE(counts[what], 50 * values_a_pair) << what;
  }
}

}  // namespace
}  // namespace halfspace::tests
