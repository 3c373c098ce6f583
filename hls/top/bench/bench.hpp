// SPDX-License-Identifier: Apache-2.0
// What a bench of tops does with a vector set: the words of a frame into channels, and those that come out against the
// set's, to the bit. The set is a folder as `halfspace vectors` writes it. Of a program that runs natively, or that a
// tool runs beside its own simulation.
#ifndef HALFSPACE_HLS_TOP_BENCH_BENCH_HPP_
#define HALFSPACE_HLS_TOP_BENCH_BENCH_HPP_

#include <map>
#include <string>
#include <vector>

#include "hls/top/ports/ports.hpp"

namespace halfspace {

// Words of a frame as a .hex file has them, one a line.
using HexWords = std::vector<std::string>;

class Bench {
 public:
  struct Size {
    int width, height;  // in pixels
    int background[3];  // red, green, blue
  };

  // The first `frames` of the set, or all with 0. Ends the program with a sentence where it is no such set.
  Bench(const char* top, const char* folder, int frames);

  // The next frame; false behind the last one.
  bool next();
  const Size& size() const { return sizes_[frame_ - 1]; }

  // The words of this frame.
  template <class R>
  std::vector<R> records(const char* stream) {
    std::vector<R> out;
    for (const std::string& line : words(stream)) out.push_back(unpacked<R>(word_of<R>(line)));
    return out;
  }
  template <class R>
  void send(const char* stream, Channel<R>& channel) {
    for (const std::string& line : words(stream)) channel.write(word_of<R>(line));
  }
  // Before a composed top is called: its argument `argument`, from 0, is a channel that gets so many words. Processes
  // of Bambu's dataflow do not end; its simulation does when each output has its words.
  void announce(int argument, std::size_t words);
  template <class R>
  void expect(const char* stream, Channel<R>& channel) {
    HexWords got;
    while (has_word(channel)) got.push_back(hex_of<R>(channel.read()));
    compare(stream, got, words(stream));
  }
  // Against what stands in other words of the set.
  template <class R>
  void expect(const char* what, Channel<R>& channel, const std::vector<R>& records) {
    HexWords got, expected;
    while (has_word(channel)) got.push_back(hex_of<R>(channel.read()));
    for (const R& record : records) expected.push_back(hex_of<R>(packed(record)));
    compare(what, got, expected);
  }
  template <class W, std::size_t N>
  void expect(const char* memory, const W (&got)[N], const W (&expected)[N]) {
    compared_ += long(N);
    for (std::size_t a = 0; a < N; ++a) {
      if (!(got[a] == expected[a])) mismatch(memory, a, "another word", "that of the set");
    }
  }

  // The closing line. Returns the exit status: 0 if words were compared and none is wrong.
  int close() const;

 private:
  template <class Any>
  static bool has_word(Any& channel) {
#ifdef HALFSPACE_STREAM_AC
    return channel.available(1);
#else
    return !channel.empty();
#endif
  }
  template <class R>
  static Packed<R> word_of(const std::string& line) {
    Packed<R> word = zero_word<PackedBits<R>::kWordBits>();
    for (int i = 0; i < PackedBits<R>::kBits; ++i) {
      const std::size_t digit = std::size_t(i / 4);
      const int value = digit < line.size() ? nibble(line[line.size() - 1 - digit]) : 0;
      set_bits<1>(word, i, std::uint64_t(value >> i % 4 & 1));
    }
    return word;
  }
  template <class R>
  static std::string hex_of(const Packed<R>& word) {
    constexpr int kDigitsOf = (PackedBits<R>::kBits + 3) / 4;
    std::string line(std::size_t(PackedBits<R>::kWordBits + 3) / 4, '0');
    for (int i = 0; i < PackedBits<R>::kWordBits; ++i) {
      char& digit = line[line.size() - 1 - std::size_t(i / 4)];
      digit = kDigits[nibble(digit) | int(bits<1>(word, i)) << i % 4];
    }
    const std::size_t padding = line.size() - kDigitsOf;
    return line.find_first_not_of('0') < padding ? line : line.substr(padding);
  }
  static constexpr const char* kDigits = "0123456789abcdef";
  static int nibble(char digit) { return digit <= '9' ? digit - '0' : digit - 'a' + 10; }

  const HexWords& words(const std::string& stream);
  void compare(const char* stream, const HexWords& got, const HexWords& expected);
  void mismatch(const char* stream, std::size_t word, const std::string& got, const std::string& expected);

  std::string top_, folder_;
  std::vector<Size> sizes_;
  std::map<std::string, std::vector<HexWords>> streams_;  // of each frame
  std::size_t frame_ = 0, frames_;                        // 1 and up while one is shown
  long compared_ = 0, wrong_ = 0;
};

}  // namespace halfspace

#endif  // HALFSPACE_HLS_TOP_BENCH_BENCH_HPP_
