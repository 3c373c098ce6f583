// SPDX-License-Identifier: Apache-2.0
// Extremes of motion_compensate: places at both ends of a frame and of vectors, weights at their ends, and what a sum
// of weighted colours can come to.
#include <algorithm>
#include <string>

#include "hls/motion/key_weights.hpp"
#include "vectors/frames/features/feature_extremes.hpp"

namespace halfspace::model {
namespace {

class Maker {
 public:
  explicit Maker(const Config& config) : c_(config) {}

  std::uint32_t last_face() const { return (1u << c_.face_bits) - 1; }
  std::uint8_t full() const { return std::uint8_t((1 << c_.colour_bits) - 1); }
  int vector_end() const { return 1 << (c_.vector_range + c_.vector_fraction); }
  int difference_end() const { return c_.relight == 0 ? 0 : (1 << (difference_bits(c_) - 1)) - 1; }

  // Keys of one face, of channels at their ends.
  NamedCompensation frame(const std::string& note, int width, int height, int weight) const {
    NamedCompensation out;
    out.note = "extreme: " + note;
    out.width = std::min(width, c_.width), out.height = std::min(height, c_.height), out.weight = weight;
    for (std::size_t k = 0; k < out.key.size(); ++k) {
      KeyFrame& key = out.key[k];
      key.width = (out.width + c_.samples - 1) / c_.samples, key.height = (out.height + c_.samples - 1) / c_.samples;
      for (int n = 0; n < key.width * key.height; ++n) {
        // No two tiles alike.
        const std::uint32_t bits = std::uint32_t(n + 1 + int(k)) * 2654435761u;
        key.rgb.push_back({std::uint8_t(bits >> 31 ? full() : 0), std::uint8_t(bits >> 30 & 1 ? full() : 0),
                           std::uint8_t(bits >> 20 & full())});
        key.face.push_back(last_face());
      }
    }
    return out;
  }
  RawMotion word(int x, int y, int vector_x, int vector_y) const {
    RawMotion out;
    out.x = x, out.y = y, out.face = last_face();
    for (RawKeyVector& v : out.key) v.there = true, v.x = vector_x, v.y = vector_y;
    return out;
  }
  // Of a place so far from the centre of pixel (at, at), in units of a vector: of the pixel next to it, so that it
  // fits.
  RawMotion near_word(int at, int right, int down) const {
    const int f = c_.vector_fraction, mask = (1 << f) - 1;
    return word(at + (right >> f), at + (down >> f), right & mask, down & mask);
  }
  void add(NamedCompensation& frame, const RawMotion& word) const {
    bool fits = word.x < frame.width && word.y < frame.height;
    for (const RawKeyVector& v : word.key)
      fits = fits && std::max(v.x, v.y) < vector_end() && std::min(v.x, v.y) >= -vector_end();
    if (fits) frame.motion.push_back(word);
  }

 private:
  const Config c_;
};

// The corners of a frame, where tiles, places and vectors end.
NamedCompensation corners(const Config& c, const Maker& make) {
  NamedCompensation frame =
      make.frame("corners of the largest frame: the last tiles and places; vectors at their ends lead out of it",
                 c.width, c.height, 1 << (c.weight_bits - 1));
  const int end = make.vector_end(), one = 1 << c.vector_fraction, last_x = frame.width - 1, last_y = frame.height - 1;
  for (const int x : {0, 1, frame.width / 2, last_x - 1, last_x}) {
    for (const int y : {0, frame.height / 2, last_y}) {
      make.add(frame, make.word(std::max(x, 0), y, 0, 0));
      for (const int way : {-end, end - 1, one / 2, -one / 2}) {
        make.add(frame, make.word(std::max(x, 0), y, way, 0));
        make.add(frame, make.word(std::max(x, 0), y, 0, way));
      }
    }
  }
  // As far over the frame as a vector leads, and still inside.
  for (const int far : {std::min(end - 1, last_x * one), -std::min(end, last_x * one)})
    make.add(frame, make.word(far < 0 ? last_x : 0, last_y, far, 0));
  return frame;
}

// A place at every eighth of the way between pixels, or as many as there are, and where weights end, with differences
// at both ends.
NamedCompensation fractions(const Config& c, const Maker& make, int weight) {
  NamedCompensation frame = make.frame("weights of pixels and differences at their ends, the first key weighs " +
                                           std::to_string(weight) + " of " + std::to_string(1 << c.weight_bits),
                                       12 * c.samples, 12 * c.samples, weight);
  const int one = c.samples << c.vector_fraction, step = std::max(one / 8, 1), d = make.difference_end();
  const int at = 6 * c.samples;
  if (at >= frame.width || at >= frame.height) return frame;
  std::vector<int> ways;
  for (int t = 0; t < one; t += step) ways.push_back(t);
  ways.push_back(one - 1);
  // Where the pixel behind the place weighs most: 1, if that is a weight at all.
  int heaviest = 0;
  const auto behind = [&](int t) { return axis_weights(c.filter, t, exact_log2(one), c.weight_bits).tap[2]; };
  for (int t = 1; t < one; ++t) heaviest = behind(t) > behind(heaviest) ? t : heaviest;
  ways.push_back(heaviest);
  // From the centre of the pixel to that of one of the key.
  const int to_centre = (one - (1 << c.vector_fraction)) / 2;
  int n = 0;
  for (const int u : ways) {
    for (const int v : {0, one / 2, heaviest}) {
      RawMotion word = make.near_word(at, to_centre + u, to_centre + v);
      for (std::size_t k = 0; k < word.key.size(); ++k) {
        for (std::size_t ch = 0; ch < 3; ++ch) word.key[k].difference[ch] = ((n + int(ch)) % 3 - 1) * (n % 2 ? d : -d);
      }
      word.key[std::size_t(n % 2)].there = n % 5 != 4;
      ++n;
      make.add(frame, word);
    }
  }
  return frame;
}

// Colours at the end of the scale where a weight is above 0, or where it is below: between four pixels each way.
NamedCompensation overshoot(const Config& c, const Maker& make, bool above) {
  NamedCompensation frame = make.frame(above ? "the largest sum of a filter, and a difference added to it"
                                             : "the least sum of a filter, and a difference taken from it",
                                       12 * c.samples, 12 * c.samples, 1 << c.weight_bits);
  const int g = c.vector_fraction + exact_log2(c.samples), middle = 1 << (g - 1), at = 6 * c.samples;
  if (at >= frame.width || at >= frame.height) return frame;
  const AxisWeights weights = axis_weights(c.filter, middle, g, c.weight_bits);
  // The place of pixel `at` with a vector of 0 lies half a sample beyond the corner of pixel 6 of the key.
  for (KeyFrame& key : frame.key) {
    for (int y = 0; y < key.height; ++y) {
      for (int x = 0; x < key.width; ++x) {
        const int i = x - 5 + 1, j = y - 5 + 1;
        const int weight = i < 0 || j < 0 || i > 3 || j > 3 ? 0 : weights.tap[i] * weights.tap[j];
        key.rgb[std::size_t(y) * key.width + x].fill((weight > 0) == above ? make.full() : 0);
      }
    }
  }
  // About the corner between pixels 5 and 6.
  const int corner = -(1 << c.vector_fraction >> 1), eighth = (c.samples << c.vector_fraction) / 8;
  for (const int d : {0, make.difference_end(), -make.difference_end()}) {
    for (int n = 0; n < 16; ++n) {
      RawMotion word = make.near_word(at, corner + (n % 4 - 1) * eighth, corner + (n / 4 - 1) * eighth);
      for (RawKeyVector& v : word.key) v.difference.fill(above ? d : -d);
      make.add(frame, word);
    }
  }
  return frame;
}

// Keys of other faces: of the last one and of the first, whose numbers differ in the top bit alone.
NamedCompensation faces(const Config& c, const Maker& make) {
  NamedCompensation frame = make.frame("faces whose numbers differ in the top bit alone, and that of nothing",
                                       12 * c.samples, 12 * c.samples, (1 << c.weight_bits) - 1);
  const std::uint32_t last = make.last_face(), other = last & last >> 1;
  for (std::size_t n = 0; n < frame.key[0].face.size(); ++n) {
    frame.key[0].face[n] = n % 2 ? last : other;
    frame.key[1].face[n] = n % 3 ? other : last;
  }
  int n = 0;
  for (int y = 0; y < frame.height; y += c.samples) {
    for (int x = 0; x < frame.width; x += c.samples, ++n) {
      RawMotion word = make.word(x, y, (n % 3 - 1) << c.vector_fraction >> 1, 0);
      word.face = n % 7 == 6 ? 0 : n % 2 ? last : other;
      make.add(frame, word);
    }
  }
  return frame;
}

}  // namespace

std::vector<NamedCompensation> compensation_extremes(const Config& config) {
  const Maker make(config);
  std::vector<NamedCompensation> frames = {corners(config, make)};
  for (const int weight : {0, 1, 1 << (config.weight_bits - 1), (1 << config.weight_bits) - 1, 1 << config.weight_bits})
    frames.push_back(fractions(config, make, weight));
  frames.push_back(overshoot(config, make, true));
  frames.push_back(overshoot(config, make, false));
  frames.push_back(faces(config, make));
  return frames;
}

}  // namespace halfspace::model
