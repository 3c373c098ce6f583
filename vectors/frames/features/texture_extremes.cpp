// SPDX-License-Identifier: Apache-2.0
// Extremes of texture. b: bits of a coordinate; e: a triangle spans 2^e repetitions; k: leading zeros of q.
#include <random>

#include "vectors/frames/extremes.hpp"
#include "vectors/frames/features/feature_extremes.hpp"
#include "vectors/frames/features/light_builder.hpp"

namespace halfspace::model {

using ref::RasterFormat;

namespace {

// Textures one behind the other, the largest first, and their texels.
class TextureBuilder {
 public:
  explicit TextureBuilder(const Config& config) : config_(config), random_(7) {}

  NamedFrame& frame() { return frame_; }
  int least_side() const { return is_bilinear(config_) ? 1 : 0; }
  int full() const { return (1 << config_.coordinate_bits) - 1; }
  // What a part of a repetition is in words, where it is the same all over a triangle.
  int q() const { return has_perspective(config_) ? 1 << (config_.coordinate_bits - 1) : 0; }
  int part(double of_one) const {
    const double one = has_perspective(config_) ? q() : std::ldexp(1.0, config_.coordinate_bits);
    return std::clamp(int(std::floor(of_one * one + 0.5)), 0, has_perspective(config_) ? q() : full());
  }
  int below(int n) { return int(random_() % std::uint64_t(n)); }

  // Its number, from 1 on.
  int add(int log2_width, int log2_height) {
    RawTexture texture{next_, std::max(log2_width, least_side()), std::max(log2_height, least_side())};
    next_ += 1 << (texture.log2_width + texture.log2_height);
    frame_.texture.textures.push_back(texture);
    return int(frame_.texture.textures.size());
  }
  // In the place of another.
  void add_again(int number) { frame_.texture.textures.push_back(frame_.texture.textures[std::size_t(number) - 1]); }
  void move_to(int base) { next_ = base; }
  int next() const { return next_; }
  void texel(int number, int i, int j, const std::array<std::uint8_t, 3>& rgb) {
    const RawTexture& t = frame_.texture.textures[std::size_t(number) - 1];
    const int address =
        is_bilinear(config_) ? (j / 2 << (t.log2_width - 1) | i / 2) << 2 | j % 2 << 1 | i % 2 : j << t.log2_width | i;
    frame_.texture.texels.push_back({t.base + address, rgb});
  }
  std::array<std::uint8_t, 3> noise() {
    std::array<std::uint8_t, 3> rgb;
    const int colours = 1 << config_.colour_bits;
    for (auto& channel : rgb) channel = std::uint8_t(below(4) ? below(2) * (colours - 1) : below(colours));
    return rgb;
  }
  // Noise all over it.
  int add_noise(int log2_width, int log2_height) {
    const int number = add(log2_width, log2_height);
    const RawTexture t = frame_.texture.textures.back();
    for (int j = 0; j < 1 << t.log2_height; ++j) {
      for (int i = 0; i < 1 << t.log2_width; ++i) texel(number, i, j, noise());
    }
    return number;
  }

  // The same all over a triangle.
  RawCoordinates place(int number, int repeats, double u, double v) const {
    RawCoordinates out{number, repeats, {}, {}, {}};
    out.s.fill(part(u)), out.t.fill(part(v)), out.q.fill(q());
    return out;
  }

 private:
  const Config config_;
  NamedFrame frame_;
  std::mt19937_64 random_;
  int next_ = 0;
};

// Sides of one texel, or of the two that a bilinear filter needs, and of sixteen, as far as there are so many textures
// and so much memory.
void add_small_textures(TextureBuilder& make, const Config& config) {
  const int sides[5][2] = {{4, 4}, {3, 2}, {0, 4}, {4, 0}, {0, 0}};
  for (const auto& [width, height] : sides) {
    if (int(make.frame().texture.textures.size()) == config.textures) return;
    const int size = 1 << (std::max(width, make.least_side()) + std::max(height, make.least_side()));
    if (make.next() + size <= config.texels) make.add_noise(width, height);
  }
}

}  // namespace

std::vector<NamedFrame> texel_border_extremes(const RasterFormat& format, const Config& config) {
  std::vector<NamedFrame> frames;
  TextureBuilder make(config);
  add_small_textures(make, config);
  const int textures = int(make.frame().texture.textures.size());
  // Sixteen pixels along half a repetition: places are halves of texels, exactly.
  push_cells(frames, "extreme: pixels on borders and centres of texels, and across the seam; sides of one texel",
             format, 4 * textures, 17, make.frame(), [&](NamedFrame& frame, int k, Point) {
               const int number = 1 + k % textures, e = k / textures % 2;
               const double from = e == 0 ? 0 : 0.25;  // crosses the seam in the middle
               RawCoordinates words = make.place(number, e, from, from);
               (k / textures < 2 ? words.s : words.t)[1] = make.part(from + 0.5);
               (k / textures < 2 ? words.t : words.s)[2] = make.part(from + 0.5);
               frame.texture.triangles.push_back(words);
             });
  // From the first place to the last, which is next to the first again.
  push_cells(frames, "extreme: places 0 and the last before a seam, and of the largest coordinates", format, 12, 3,
             make.frame(), [&](NamedFrame& frame, int k, Point) {
               RawCoordinates words = make.place(1 + k % textures, k / 4, 0, 0);
               if (has_perspective(config)) words.q.fill(make.full());
               if (k % 4 & 1) words.s.fill(make.full() - k / 4);
               if (k % 4 & 2) words.t.fill(make.full() - k / 4);
               frame.texture.triangles.push_back(words);
             });
  return frames;
}

std::vector<NamedFrame> horizon_extremes(const RasterFormat& format, const Config& config) {
  std::vector<NamedFrame> frames;
  TextureBuilder make(config);
  add_small_textures(make, config);
  const int full = make.full();
  push_cells(frames, "extreme: up to the horizon: q from full scale to 1, and 0 … 2^e repetitions on the way", format,
             8, 17, make.frame(), [&](NamedFrame& frame, int k, Point) {
               RawCoordinates words{1, k / 2, {}, {}, {}};
               words.q.fill(full);
               words.q[std::size_t(k % 3)] = 1;
               if (k % 2) words.q[std::size_t((k + 1) % 3)] = 1;
               for (int v = 0; v < 3; ++v) words.s[v] = v == 1 ? words.q[v] : 0, words.t[v] = v == 2 ? words.q[v] : 0;
               frame.texture.triangles.push_back(words);
             });
  push_cells(frames, "extreme: q of 1, 2, 4 … full scale all over a triangle: k from b − 1 to 0", format,
             4 * config.coordinate_bits, 3, make.frame(), [&](NamedFrame& frame, int k, Point) {
               RawCoordinates words{1, 0, {}, {}, {}};
               const int q = k % 4 == 3 ? (2 << (k / 4)) - 1 : 1 << (k / 4);
               words.q.fill(q);
               words.s.fill(k % 4 == 0 ? 0 : k % 4 == 1 ? q : q / 3 * 2), words.t.fill(k % 2 ? q : q / 5);
               frame.texture.triangles.push_back(words);
             });
  return frames;
}

std::vector<NamedFrame> repetition_extremes(const RasterFormat& format, const Config& config) {
  std::vector<NamedFrame> frames;
  TextureBuilder make(config);
  make.add_noise(std::min(2, exact_log2(config.texels) / 2), std::min(2, exact_log2(config.texels) / 2));
  constexpr int kEach = 6;
  push_cells(frames, "extreme: 2^e repetitions, e from 0 to 15", format, kEach << kRepeatBits, 3, make.frame(),
             [&](NamedFrame& frame, int k, Point) {
               RawCoordinates words{1, k / kEach, {}, {}, {}};
               const int q = has_perspective(config) ? make.full() - make.below(make.full() / 2) : 0;
               words.q.fill(q);
               // A small part of them: the reciprocal's error counts for that.
               const int most = has_perspective(config) ? q / 8 : make.full();
               words.s.fill(make.below(most)), words.t.fill(make.below(most));
               frame.texture.triangles.push_back(words);
             });
  return frames;
}

std::vector<NamedFrame> texture_size_extremes(const RasterFormat& format, const Config& config) {
  std::vector<NamedFrame> frames;
  {
    // Four texels each, the last ones at the end of the memory.
    TextureBuilder make(config);
    // Where there are more textures than room, they lie on each other: but not those that the top bit tells apart.
    const int textures = config.textures, slots = config.texels / 4, top = 1 << (bits_for(textures) - 1);
    for (int n = 1; n <= std::min(textures, slots); ++n) {
      if (textures <= slots && n == textures / 2 + 1) make.move_to(config.texels - 4 * (textures - n + 1));
      make.add_noise(1, 1);
    }
    for (int n = slots + 1; n <= textures; ++n) make.add_again(1 + (n - 1 + (n >= top)) % slots);
    push_cells(
        frames, "extreme: all textures, the last number and the last address; and none", format,
        std::min(4 * textures, 128), 3, make.frame(), [&](NamedFrame& frame, int k, Point) {
          const int number = k / 4 % 2 ? k / 8 % (textures + 1) : textures - k / 8 % textures;
          frame.texture.triangles.push_back(make.place(number, 0, 0.25 + 0.5 * (k % 2), 0.25 + 0.5 * (k / 2 % 2)));
        });
  }
  for (const bool turned : {false, true}) {
    TextureBuilder make(config);
    const int side = exact_log2(config.texels) - make.least_side();
    const int number = turned ? make.add(0, side) : make.add(side, 0);
    // Four places along it, each in a colour of its own; the other texels have none, and nobody asks for them.
    constexpr int kPlaces = 4, kAround = 8;
    const int length = 1 << side, across = 1 << make.least_side(), full = (1 << config.colour_bits) - 1;
    std::vector<bool> there(std::size_t(length), false);
    for (int n = 0; n < kPlaces; ++n) {
      for (int d = -kAround; d < kAround; ++d) {
        const int i = (length / kPlaces * n + length / (2 * kPlaces) + d) & (length - 1);
        if (there[std::size_t(i)]) continue;
        there[std::size_t(i)] = true;
        const int of = i / std::max(length / kPlaces, 1);
        for (int j = 0; j < across; ++j) {
          make.texel(number, turned ? j : i, turned ? i : j,
                     {std::uint8_t(of & 1 ? full : 0), std::uint8_t(of & 2 ? full : 0), std::uint8_t(full / (of + 1))});
        }
      }
    }
    push_cells(frames, std::string("extreme: the longest side there is, ") + (turned ? "standing" : "lying"), format,
               2 * kPlaces, 3, make.frame(), [&](NamedFrame& frame, int k, Point) {
                 const double along = (k % kPlaces + 0.5) / kPlaces, beside = k < kPlaces ? 0 : 0.5;
                 frame.texture.triangles.push_back(turned ? make.place(number, 0, beside, along)
                                                          : make.place(number, 0, along, beside));
               });
  }
  return frames;
}

std::vector<NamedFrame> coordinate_plane_extremes(const RasterFormat& format, const Config& config) {
  std::vector<NamedFrame> frames = gradient_frames(format);
  for (NamedFrame& frame : guard_band_frames(format)) frames.push_back(std::move(frame));
  TextureBuilder make(config);
  const int log2 = std::min(3, exact_log2(config.texels) / 2);
  make.add_noise(log2, log2);
  const int full = make.full();
  for (NamedFrame& frame : frames) {
    frame.note += "; coordinates from 0 to 2^b − 1";
    frame.texture = make.frame().texture;
    for (std::size_t k = 0; k < frame.scene.triangles.size(); ++k) {
      for (auto& rgb : frame.scene.triangles[k].rgb) rgb.fill(std::uint8_t((1 << config.colour_bits) - 1));
      RawCoordinates words{1, 0, {}, {}, {}};
      for (int v = 0; v < 3; ++v) {
        const bool at = v == int(k % 3), other = v == int((k + 1) % 3), swings = k / 3 % 2 == 1;
        const int q = has_perspective(config) && swings && other ? 1 : full;
        words.q[v] = has_perspective(config) ? q : 0;
        words.s[v] = at != (k / 6 % 2 == 1) ? q : 0, words.t[v] = other ? 0 : q;
      }
      frame.texture.triangles.push_back(words);
    }
  }
  return frames;
}

}  // namespace halfspace::model
