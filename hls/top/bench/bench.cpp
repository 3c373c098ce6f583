// SPDX-License-Identifier: Apache-2.0
#include "hls/top/bench/bench.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#ifdef __BAMBU_SIM__
#include <mdpi/mdpi_user.h>
#endif

namespace halfspace {
namespace {

constexpr long kShown = 5;  // mismatches that are printed

[[noreturn]] void fail(const std::string& file, const char* what) {
  std::fprintf(stderr, "%s: %s; `halfspace vectors --out FOLDER` writes a set\n", file.c_str(), what);
  std::exit(2);
}

// The number behind the next `key` of a manifest.
int number_after(const std::string& text, const char* key, std::size_t& at) {
  at = text.find(key, at);
  if (at == std::string::npos) return 0;
  at = text.find_first_of("0123456789", at + std::string(key).size());
  return at == std::string::npos ? 0 : std::atoi(text.c_str() + at);
}

}  // namespace

constexpr const char* Bench::kDigits;

Bench::Bench(const char* top, const char* folder, int frames) : top_(top), folder_(folder) {
  const std::string name = folder_ + "/manifest.json";
  std::ifstream file(name);
  if (!file) fail(name, "cannot be read");
  std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const std::size_t begin = text.find("\"frames\""), end = text.find("\"streams\"");
  if (begin == std::string::npos || end == std::string::npos || end < begin) fail(name, "is no manifest of vectors");
  text = text.substr(begin, end - begin);
  for (std::size_t at = 0;;) {
    Size size = {};
    size.width = number_after(text, "\"width\"", at);
    if (at == std::string::npos) break;
    size.height = number_after(text, "\"height\"", at);
    const std::size_t next = text.find("\"width\"", at), background = text.find("\"background\"", at);
    if (background < next) {
      at = background;
      for (int& channel : size.background) {
        channel = number_after(text, "", at);
        at = text.find_first_not_of("0123456789", at);
      }
    }
    sizes_.push_back(size);
  }
  if (sizes_.empty()) fail(name, "has no frames");
  frames_ = frames > 0 ? std::min(std::size_t(frames), sizes_.size()) : sizes_.size();
}

bool Bench::next() { return frame_++ < frames_; }

const HexWords& Bench::words(const std::string& stream) {
  std::vector<HexWords>& frames = streams_[stream];
  if (frames.empty()) {
    const std::string name = folder_ + "/" + stream + ".hex";
    std::ifstream file(name);
    if (!file) fail(name, "cannot be read");
    for (std::string line; std::getline(file, line);) {
      if (line.compare(0, 9, "// frame ") == 0) frames.emplace_back();
      else if (!line.empty() && line[0] != '/' && !frames.empty()) frames.back().push_back(line);
    }
    if (frames.size() != sizes_.size()) fail(name, "has not the frames of the manifest");
  }
  return frames[frame_ - 1];
}

void Bench::announce(int argument, std::size_t words) {
#ifdef __BAMBU_SIM__
  m_param_alloc(std::uint8_t(argument), words);
#else
  (void)argument, (void)words;
#endif
}

void Bench::mismatch(const char* stream, std::size_t word, const std::string& got, const std::string& expected) {
  if (++wrong_ > kShown) return;
  std::printf("%s: frame %d, %s, word %d: %s, expected %s\n", top_.c_str(), int(frame_ - 1), stream, int(word),
              got.c_str(), expected.c_str());
  std::fflush(stdout);  // a simulator may end the program as it likes
}

void Bench::compare(const char* stream, const HexWords& got, const HexWords& expected) {
  const std::size_t count = std::max(got.size(), expected.size());
  compared_ += long(count);
  for (std::size_t n = 0; n < count; ++n) {
    const std::string& a = n < got.size() ? got[n] : "nothing";
    const std::string& b = n < expected.size() ? expected[n] : "nothing";
    if (a != b) mismatch(stream, n, a, b);
  }
}

int Bench::close() const {
  std::printf("%s: %d frames, %ld words compared, %ld wrong\n", top_.c_str(), int(frames_), compared_, wrong_);
  std::fflush(stdout);
  return compared_ > 0 && wrong_ == 0 ? 0 : 1;
}

}  // namespace halfspace
