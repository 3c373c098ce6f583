// SPDX-License-Identifier: Apache-2.0
#include "vectors/frames/awkward.hpp"

#include <algorithm>
#include <random>

#include "model/motion/motion.hpp"

namespace halfspace::model {

MotionFrame awkward_motion(const ref::SnappedList& list, const Config& config, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto below = [&](std::int64_t n) { return int(random() % std::uint64_t(n)); };
  const int full = (1 << config.coordinate_bits) - 1, faces = (1 << config.face_bits) - 1;
  const int range = 1 << (config.range_bits - 1), differences = 1 << difference_bits(config);
  MotionFrame frame;
  for (std::size_t k = 0; k < list.triangles.size(); ++k) {
    const ref::SnappedTriangle& triangle = list.triangles[k];
    RawMotionVectors& out = frame.triangles.emplace_back();
    out.face = k % 8 == 7 ? (below(2) ? faces : 1) : 1 + below(faces);
    for (RawKeyPlaces& key : out.key) {
      const int kind = int((k + random() % 2) % 8);
      key.there = kind != 6;
      key.extent = kind == 5 ? config.range_bits : below(std::min(config.range_bits, config.vector_range) + 1);
      // Near a vertex mostly, so that vectors fit; and at both ends of the range.
      const auto origin = [&](const std::array<std::int32_t, 3>& at) {
        if (kind == 4) return below(2) ? range - 1 : -range;
        const int vertex = at[below(3)] >> config.subpixel_bits, around = 1 << config.vector_range;
        return std::clamp(vertex - (1 << key.extent) / 2 + below(around) - around / 2, -range, range - 1);
      };
      key.origin_x = origin(triangle.x);
      key.origin_y = origin(triangle.y);
      const int around = 1 + below(full);
      for (int v = 0; v < 3; ++v) {
        int q = full;
        switch (kind) {
          case 1: q = full / (1 + below(4)); break;
          case 2: q = std::max(full >> below(config.coordinate_bits), 1); break;  // any octave
          case 3: q = v == 0 ? full : 1; break;                                   // as far apart as can be
          case 4: q = std::clamp(around + below(3) - 1, 1, full); break;          // hardly apart
          case 5: q = 1 + below(full); break;
          default: break;
        }
        const int most = has_perspective(config) ? q : full;
        for (auto* place : {&key.s, &key.t}) {
          int value = below(std::int64_t(most) + 1);
          if (kind == 2 || kind == 3) value = below(2) * most;
          if (kind == 7) value = std::clamp(most / 2 + below(3) - 1, 0, most);
          (*place)[v] = value;
        }
        key.q[v] = has_perspective(config) ? q : 0;
        if (!relights(config)) continue;
        for (auto& channel : key.difference) {
          // −2^c cannot be: colours differ by 2^c − 1 at most.
          channel[v] = kind % 2 == 0 ? 1 + below(2) * (differences - 2) : 1 + below(differences - 1);
        }
      }
    }
  }
  return frame;
}

}  // namespace halfspace::model
