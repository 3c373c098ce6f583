// SPDX-License-Identifier: Apache-2.0
// The layout of a record as a packed word, read from its visit(), and of a stream's.
#ifndef HALFSPACE_MODEL_FORMATS_LAYOUT_HPP_
#define HALFSPACE_MODEL_FORMATS_LAYOUT_HPP_

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "hls/formats/streams.hpp"
#include "hls/numbers/fixed.hpp"

namespace halfspace::model {

struct Field {
  std::string name;
  int lsb;    // of lane 0
  int width;  // of one lane
  int count;  // lanes; 1 for a field that comes once
  bool is_signed;
  int fraction;
};

struct Layout {
  std::string stream;  // its name; "" of a record alone
  StreamRow row{};     // what else the table says of it
  int bits = 0;
  int head_bits = 0;          // the fields that come once, above the lanes
  std::vector<Field> fields;  // the most significant first
};

constexpr int kMaxWordBits = 2304;
using Word = std::array<std::uint64_t, kMaxWordBits / 64>;  // bit 0 is bit 0 of element 0

namespace detail {

class LayoutVisitor {
 public:
  explicit LayoutVisitor(Layout& layout) : layout_(layout) {}

  template <class T>
  void operator()(const char* name, const T&) {
    add(name, T::width(), 1, T::kSigned, T::fraction());
    layout_.head_bits += T::width();
  }
  template <class T, std::size_t N>
  void lanes(const char* name, const T (&)[N]) {
    add(name, T::width(), int(N), T::kSigned, T::fraction());
  }

 private:
  void add(const char* name, int width, int count, bool is_signed, int fraction) {
    for (Field& field : layout_.fields) field.lsb += width * count;
    layout_.fields.push_back({name, 0, width, count, is_signed, fraction});
    layout_.bits += width * count;
  }

  Layout& layout_;
};

class PackVisitor {
 public:
  PackVisitor(Word& word, int bits) : word_(word), at_(bits) {}

  template <class T>
  void operator()(const char*, const T& value) {
    const int width = T::width();
    at_ -= width;
    put(at_, width, static_cast<std::uint64_t>(raw(value)));
  }
  template <class T, std::size_t N>
  void lanes(const char*, const T (&values)[N]) {
    const int width = T::width();
    at_ -= width * int(N);
    for (std::size_t l = 0; l < N; ++l) put(at_ + width * int(l), width, static_cast<std::uint64_t>(raw(values[l])));
  }

 private:
  void put(int lsb, int width, std::uint64_t value) {
    if (width < 64) value &= (std::uint64_t(1) << width) - 1;
    word_[lsb / 64] |= value << (lsb % 64);
    if (lsb % 64 + width > 64) word_[lsb / 64 + 1] |= value >> (64 - lsb % 64);
  }

  Word& word_;
  int at_;
};

}  // namespace detail

template <class Record>
Layout layout() {
  Layout result;
  Record record{};
  record.visit(detail::LayoutVisitor(result));
  return result;
}

template <class Record>
Layout layout(const StreamRow& row) {
  Layout result = layout<Record>();
  result.stream = row.name;
  result.row = row;
  return result;
}

template <class Record>
Word pack(Record record, int bits) {
  Word word{};
  record.visit(detail::PackVisitor(word, bits));
  return word;
}

struct StreamWords {
  Layout layout;
  std::vector<Word> words;
};

// Receives the words of one stream of one frame, in order.
using WordSink = std::function<void(const Layout&, const Word*, std::size_t count)>;

// Lower-case hexadecimal digits, as many as `bits` need, most significant first.
inline void append_hex(std::string& text, const Word& word, int bits) {
  for (int digit = (bits + 3) / 4 - 1; digit >= 0; --digit) {
    text += "0123456789abcdef"[word[digit / 16] >> (digit % 16 * 4) & 15];
  }
}

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_FORMATS_LAYOUT_HPP_
