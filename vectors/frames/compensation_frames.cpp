// SPDX-License-Identifier: Apache-2.0
#include "vectors/frames/compensation_frames.hpp"

#include <algorithm>
#include <random>
#include <utility>

namespace halfspace::model {
namespace {

class Maker {
 public:
  Maker(const Config& config, std::uint64_t seed) : c_(config), random_(seed) {}

  int below(int n) { return int(random_() % std::uint64_t(n)); }
  bool one_in(int n) { return below(n) == 0; }
  int most_face() const { return (1 << c_.face_bits) - 1; }

  // Patches of `patch` pixels of a few faces each, with single pixels of others, and of none, in them.
  KeyFrame key(int width, int height, int patch, bool extreme) {
    KeyFrame out;
    out.width = width, out.height = height;
    const int columns = width / patch + 1;
    std::vector<int> faces(std::size_t(columns) * (height / patch + 1));
    for (int& face : faces) face = some_face();
    const int most = (1 << c_.colour_bits) - 1;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        out.face.push_back(
            std::uint32_t(one_in(12) ? some_face() : faces[std::size_t(y / patch) * columns + x / patch]));
        std::array<std::uint8_t, 3>& rgb = out.rgb.emplace_back();
        for (auto& channel : rgb) channel = std::uint8_t(extreme ? below(2) * most : below(most + 1));
      }
    }
    return out;
  }

  // A vector of up to `reach` pixels, or at an end of its range.
  int component(int reach) {
    const int one = 1 << c_.vector_fraction, most = (1 << (c_.vector_range + c_.vector_fraction)) - 1;
    if (one_in(16)) return one_in(2) ? most : -most - 1;
    if (one_in(4)) return std::clamp((below(2 * reach + 1) - reach) * one, -most - 1, most);
    return std::clamp(below(2 * reach * one + 1) - reach * one, -most - 1, most);
  }

  int difference(bool extreme) {
    const int most = (1 << (difference_bits(c_) - 1)) - 1;
    return c_.relight == 0 ? 0 : extreme || one_in(8) ? (below(3) - 1) * most : below(2 * most + 1) - most;
  }

  // A word of that place; three in four times of the face that the pixel at its place in a key shows.
  RawMotion word(const NamedCompensation& frame, int x, int y, int reach, bool extreme) {
    RawMotion out;
    out.x = x, out.y = y;
    for (RawKeyVector& v : out.key) {
      v.there = !one_in(10);
      v.x = component(reach), v.y = component(reach);
      for (int& d : v.difference) d = difference(extreme);
    }
    const KeyFrame& key = frame.key[std::size_t(below(2))];
    const RawKeyVector& v = out.key[std::size_t(below(2))];
    out.face = one_in(4) ? std::uint32_t(std::min(below(6), most_face())) : key.face[place(key, x, y, v)];
    return out;
  }

  // Of the pixel of a key frame, or the nearest, that a vector leads to.
  std::size_t place(const KeyFrame& key, int x, int y, const RawKeyVector& v) const {
    const int one = c_.samples << c_.vector_fraction, half = 1 << (c_.vector_fraction - 1);
    const int at_x = std::clamp(((2 * x + 1) * half + v.x) / one, 0, key.width - 1);
    const int at_y = std::clamp(((2 * y + 1) * half + v.y) / one, 0, key.height - 1);
    return std::size_t(at_y) * key.width + at_x;
  }

  void keys(NamedCompensation& frame, int patch, bool extreme) {
    frame.weight = below((1 << c_.weight_bits) + 1);
    const int s = c_.samples;
    for (KeyFrame& key : frame.key) {
      key = this->key((frame.width + s - 1) / s, (frame.height + s - 1) / s, patch, extreme);
    }
  }

  // Three in four vectors find the face of their word.
  void show(NamedCompensation& frame) {
    for (const RawMotion& word : frame.motion) {
      for (std::size_t k = 0; k < frame.key.size(); ++k) {
        KeyFrame& key = frame.key[k];
        if (word.key[k].there && !one_in(4)) key.face[place(key, word.x, word.y, word.key[k])] = word.face;
      }
    }
  }

  // `words` = 0: every pixel, in order; else so many anywhere.
  NamedCompensation frame(const char* note, int width, int height, int patch, int reach, int words, bool extreme) {
    NamedCompensation out;
    out.note = note;
    out.width = std::min(width, c_.width), out.height = std::min(height, c_.height);
    keys(out, patch, extreme);
    for (int n = 0; n < (words ? words : out.width * out.height); ++n) {
      const int x = words ? below(out.width) : n % out.width, y = words ? below(out.height) : n / out.width;
      out.motion.push_back(word(out, x, y, reach, extreme));
    }
    return out;
  }

 private:
  int some_face() { return one_in(6) ? 0 : one_in(8) ? most_face() : std::min(1 + below(3), most_face()); }

  const Config c_;
  std::mt19937_64 random_;
};

}  // namespace

std::vector<NamedCompensation> compensation_frames(const Config& config, std::uint64_t seed) {
  Maker make(config, seed);
  const int s = config.samples;
  std::vector<NamedCompensation> frames;
  frames.push_back(make.frame("a single pixel", 1, 1, 1, 1, 0, false));
  frames.push_back(make.frame("no pixel covered", 9 * s, 9 * s, 4, 1, 1, false));
  frames.back().motion.clear();
  frames.push_back(make.frame("one face, key 0 alone", 11 * s, 10 * s, 40, 3, 300, false));
  frames.back().weight = 1 << config.weight_bits;
  frames.push_back(make.frame("one face, key 1 alone", 10 * s, 11 * s, 40, 3, 300, false));
  frames.back().weight = 0;
  frames.push_back(make.frame("patches, in order", 27 * s / std::min(s, 2), 22 * s / std::min(s, 2), 5, 2, 0, false));
  frames.push_back(make.frame("small patches, extreme colours and differences", 21 * s, 18 * s, 2, 2, 400, true));
  frames.push_back(warm_frame(config, 1000, seed));
  frames.push_back(make.frame("anywhere", 70 * s, 50 * s, 7, 30, 120, false));
  frames.push_back(
      make.frame("the largest frame", config.width, config.height, 16, 1 << config.vector_range, 60, true));
  return frames;
}

NamedCompensation warm_frame(const Config& config, int words, std::uint64_t seed) {
  Maker make(config, seed);
  const int side = 2 * kKeyTile * config.samples;  // four tiles, which a cache holds
  return make.frame("four tiles", side, side, 6, 2, words, false);
}

NamedCompensation between_frame(const Config& config, int width, int height, std::vector<RawMotion> motion,
                                std::uint64_t seed) {
  Maker make(config, seed);
  NamedCompensation out;
  out.width = width, out.height = height;
  out.motion = std::move(motion);
  out.by_tiles = false;
  make.keys(out, 5, false);
  make.show(out);
  return out;
}

}  // namespace halfspace::model
