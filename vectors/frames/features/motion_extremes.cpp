// SPDX-License-Identifier: Apache-2.0
// Extremes of places in key frames. A vector leads from the centre of a pixel to its place: origin + u·2^e. r: log2 of
// the range of vectors; b: bits of a place.
#include <cmath>

#include "vectors/frames/extremes.hpp"
#include "vectors/frames/features/feature_extremes.hpp"
#include "vectors/frames/features/light_builder.hpp"

namespace halfspace::model {

using ref::RasterFormat;

namespace {

class PlaceBuilder {
 public:
  explicit PlaceBuilder(const Config& config) : config_(config) {}

  int range() const { return 1 << (config_.range_bits - 1); }
  int full() const { return (1 << config_.coordinate_bits) - 1; }
  int last_face() const { return (1 << config_.face_bits) - 1; }
  int q() const { return has_perspective(config_) ? 1 << (config_.coordinate_bits - 1) : 0; }
  int clamped(int origin) const { return std::clamp(origin, -range(), range() - 1); }

  // The same all over a triangle: (x, y) pixels, less than 2^extent from the origin.
  RawKeyPlaces place(int extent, int origin_x, int origin_y, double x, double y) const {
    RawKeyPlaces out;
    out.there = true;
    out.extent = extent, out.origin_x = clamped(origin_x), out.origin_y = clamped(origin_y);
    out.s.fill(part(x - out.origin_x, extent)), out.t.fill(part(y - out.origin_y, extent)), out.q.fill(q());
    return without_difference(out);
  }
  RawKeyPlaces without_difference(RawKeyPlaces out) const {
    if (!relights(config_)) return out;
    for (auto& channel : out.difference) channel.fill(1 << (difference_bits(config_) - 1));
    return out;
  }

 private:
  int part(double pixels, int extent) const {
    const double one = has_perspective(config_) ? q() : std::ldexp(1.0, config_.coordinate_bits);
    return std::clamp(int(std::floor(std::ldexp(pixels, -extent) * one + 0.5)), 0,
                      has_perspective(config_) ? q() : full());
  }
  const Config config_;
};

}  // namespace

std::vector<NamedFrame> vector_extremes(const RasterFormat& format, const Config& config) {
  std::vector<NamedFrame> frames;
  const PlaceBuilder make(config);
  // Positions end before the longest vectors of some configurations do.
  const double unit = std::ldexp(1.0, -config.vector_fraction),
               end = std::min(std::ldexp(1.0, config.vector_range), double(make.range() - 64));
  const double ways[8] = {-end, -end - unit, -end + unit, end - unit, end, 0, unit, -unit};
  push_cells(frames, "extreme: vectors at both ends of their range, a unit before and a unit beyond", format, 32, 3, {},
             [&](NamedFrame& frame, int k, Point first) {
               const auto [x, y] = first;
               const double way = ways[k % 8], px = x + 0.5 + (k / 8 % 2 ? 0 : way),
                            py = y + 0.5 + (k / 8 % 2 ? way : 0);
               RawMotionVectors words;
               words.face = k % 2 ? 1 : make.last_face();
               const RawKeyPlaces moved = make.place(1, int(std::floor(px)), int(std::floor(py)), px, py),
                                  still = make.place(1, x, y, x + 0.5, y + 0.5);
               words.key[std::size_t(k / 16 % 2)] = moved, words.key[std::size_t(1 - k / 16 % 2)] = still;
               frame.motion.triangles.push_back(words);
             });
  return frames;
}

std::vector<NamedFrame> far_ways(const RasterFormat& format, const Config& config) {
  std::vector<NamedFrame> frames;
  const PlaceBuilder make(config);
  const int first_bit = config.vector_range, bits = config.range_bits - first_bit + 1;
  push_cells(frames, "rare: ways whose upper bits but one, or one alone, are those of a vector that fits", format,
             4 * bits, 3, {}, [&](NamedFrame& frame, int k, Point first) {
               const int far = 1 << (first_bit + k / 4);
               const int x = first.x + (k % 2 ? -far : far);
               RawMotionVectors words;
               words.face = 1;
               const RawKeyPlaces still = make.place(1, first.x, first.y, first.x + 0.5, first.y + 0.5);
               RawKeyPlaces moved = make.place(config.range_bits, k % 2 ? -make.range() : make.range() - 1, first.y,
                                               x + 0.5, first.y + 0.5);
               if (k % 4 >= 2) std::swap(moved.origin_x, moved.origin_y), std::swap(moved.s, moved.t);
               words.key = {moved, still};
               if (k / 4 % 2) std::swap(words.key[0], words.key[1]);
               frame.motion.triangles.push_back(words);
             });
  return frames;
}

std::vector<NamedFrame> place_extremes(const RasterFormat& format, const Config& config) {
  std::vector<NamedFrame> frames;
  const PlaceBuilder make(config);
  const int full = make.full();
  push_cells(frames, "extreme: extents of 1 to the largest, from both ends of positions; keys that do not show", format,
             6 * (config.range_bits + 1), 3, {}, [&](NamedFrame& frame, int k, Point first) {
               const int e = k / 6, reach = 1 << e, low = -make.range(), x = first.x, y = first.y;
               RawMotionVectors words;
               words.face = k % 6 == 5 ? 1 : make.last_face();
               // In the middle of what the extent spans.
               const RawKeyPlaces near = make.place(e, x - reach / 2, y - reach / 2, x + 0.5, y + 0.5);
               RawKeyPlaces at_low = make.place(e, low, low, low + reach / 2, low + reach / 2);
               if (e + 1 >= config.range_bits) at_low = make.place(e, low, low, x + 0.5, y + 0.5);
               const RawKeyPlaces at_high = make.place(e, make.range() - 1, 0, make.range() - 0.5, 0.5);
               RawKeyPlaces spread = near;
               for (int v = 0; v < 3; ++v) {
                 const int q = has_perspective(config) ? full : 0;
                 spread.q[v] = q, spread.s[v] = v == 1 ? full : 0, spread.t[v] = v == 2 ? full : 0;
               }
               words.key = {near, near};
               switch (k % 6) {
                 case 0: words.key[0] = at_low; break;
                 case 1: words.key[1] = at_high; break;
                 case 2: words.key[1].there = false; break;
                 case 3: words.key[0] = spread; break;
                 case 4: words.key[0].there = words.key[1].there = false; break;
                 default: words.key[1] = at_low;
               }
               frame.motion.triangles.push_back(words);
             });
  if (!has_perspective(config)) return frames;
  push_cells(frames, "extreme: q of 1, 2, 4 … full scale, and from full scale to 1 over a triangle", format,
             3 * config.coordinate_bits, 5, {}, [&](NamedFrame& frame, int k, Point) {
               RawMotionVectors words;
               words.face = 1;
               for (int key = 0; key < ref::kKeys; ++key) {
                 RawKeyPlaces& out = words.key[std::size_t(key)];
                 out = make.place(4, 0, 0, 0, 0);
                 const int q = 1 << (k / 3);
                 out.q.fill(q);
                 if (k % 3 == 2) out.q[std::size_t(k / 3 % 3)] = full;
                 for (int v = 0; v < 3; ++v) {
                   out.s[v] = (v + key) % 3 == 0 ? out.q[v] : out.q[v] / 2;
                   out.t[v] = k % 3 == 1 ? out.q[v] : (v + key) % 3 == 1 ? 0 : out.q[v] / 3;
                 }
               }
               frame.motion.triangles.push_back(words);
             });
  return frames;
}

std::vector<NamedFrame> place_plane_extremes(const RasterFormat& format, const Config& config) {
  const PlaceBuilder make(config);
  std::vector<NamedFrame> frames = gradient_frames(format);
  for (NamedFrame& frame : guard_band_frames(format)) frames.push_back(std::move(frame));
  const int full = make.full(), differences = relights(config) ? 1 << difference_bits(config) : 2;
  for (NamedFrame& frame : frames) {
    frame.note += "; places from 0 to 2^b − 1, and differences from end to end";
    for (std::size_t k = 0; k < frame.scene.triangles.size(); ++k) {
      const ref::SnappedTriangle& triangle = frame.scene.triangles[k];
      // Near what the frame shows of the triangle, so that vectors fit.
      const auto inside = [&](const std::array<std::int32_t, 3>& at, int size) {
        std::array<std::int32_t, 3> sorted = at;
        std::sort(sorted.begin(), sorted.end());
        return std::clamp(sorted[1] >> config.subpixel_bits, 0, size - 1);
      };
      RawMotionVectors words;
      words.face = k % 2 ? 1 : make.last_face();
      for (int key = 0; key < ref::kKeys; ++key) {
        RawKeyPlaces& out = words.key[std::size_t(key)];
        const int e = std::min(3, config.vector_range), n = int(k) + key;
        out = make.place(e, inside(triangle.x, frame.scene.width) - (1 << e >> 1),
                         inside(triangle.y, frame.scene.height) - (1 << e >> 1), 0, 0);
        for (int v = 0; v < 3; ++v) {
          const bool at = v == n % 3, other = v == (n + 1) % 3;
          const int q = has_perspective(config) && n / 3 % 2 == 1 && other ? 1 : full;
          out.q[v] = has_perspective(config) ? q : 0;
          out.s[v] = at != (n / 6 % 2 == 1) ? q : 0, out.t[v] = other ? 0 : q;
          for (int c = 0; relights(config) && c < 3; ++c)
            out.difference[std::size_t(c)][std::size_t(v)] =
                (v == (n + c) % 3) != (n / 3 % 2 == 1) ? differences - 1 : 1;
        }
      }
      frame.motion.triangles.push_back(words);
    }
  }
  return frames;
}

}  // namespace halfspace::model
