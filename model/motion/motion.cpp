// SPDX-License-Identifier: Apache-2.0
#include "model/motion/motion.hpp"

#include <algorithm>
#include <cmath>

#include "ref/error.hpp"
#include "ref/geometry/snap.hpp"
#include "ref/motion/motion.hpp"

namespace halfspace::model {

int face_number(std::uint32_t face, const Config& config) {
  const std::uint32_t faces = (std::uint32_t(1) << config.face_bits) - 1;
  return int((face - 1) % faces + 1);
}

RawKeyPlaces quantized_places(const std::array<glm::dvec2, 3>& place, const std::array<double, 3>& weight,
                              const Config& config) {
  RawKeyPlaces out;
  glm::dvec2 least(place[0]), most(place[0]);
  for (int v = 1; v < 3; ++v) least = glm::min(least, place[v]), most = glm::max(most, place[v]);
  const double range = std::ldexp(1.0, config.range_bits - 1);
  if (!(least.x >= -range && least.y >= -range && most.x < range && most.y < range)) return out;
  out.there = true;
  const glm::dvec2 origin = glm::floor(least);
  out.origin_x = int(origin.x);
  out.origin_y = int(origin.y);
  const double span = std::max(most.x - origin.x, most.y - origin.y);
  while (span > std::ldexp(1.0, out.extent)) ++out.extent;
  const double full = std::ldexp(1.0, config.coordinate_bits) - 1;
  const double greatest = *std::max_element(weight.begin(), weight.end());
  for (int v = 0; v < 3; ++v) {
    double scale = full + 1;
    if (has_perspective(config)) scale = out.q[v] = int(std::max(std::floor(full * weight[v] / greatest + 0.5), 1.0));
    const glm::dvec2 part = place[v] - origin;
    out.s[v] = int(std::min(std::floor(std::ldexp(part.x, -out.extent) * scale + 0.5), full));
    out.t[v] = int(std::min(std::floor(std::ldexp(part.y, -out.extent) * scale + 0.5), full));
  }
  return out;
}

MotionFrame motion_frame(const ref::Between& between, const Config& config,
                         const ref::OfKeys<ref::LightChange>& change) {
  for (const ref::LightChange& of_key : change) {
    if (of_key.empty() || of_key.size() == between.traces.size()) continue;
    throw ref::Error(
        "the colours of a frame in between are not those of its triangles: give as many as it has triangles");
  }
  MotionFrame frame;
  for (std::size_t k = 0; k < between.traces.size(); ++k) {
    const ref::Trace& trace = between.traces[k];
    RawMotionVectors& out = frame.triangles.emplace_back();
    out.face = face_number(trace.face, config);
    for (int key = 0; key < ref::kKeys; ++key) {
      if (!trace.screen[key]) continue;
      std::array<glm::dvec2, 3> place = *trace.screen[key];
      std::array<double, 3> weight{1, 1, 1};
      for (int v = 0; v < 3; ++v) {
        if (!has_perspective(config)) {
          for (int axis = 0; axis < 2; ++axis) {
            place[v][axis] =
                std::ldexp(double(ref::snapped_position(place[v][axis], config.subpixel_bits)), -config.subpixel_bits);
          }
        } else if (!trace.straight) {
          weight[v] = trace.at_key[key][v].w / trace.w[v];
        }
      }
      out.key[key] = quantized_places(place, weight, config);
      if (!relights(config)) continue;
      for (int c = 0; c < 3; ++c) {
        for (int v = 0; v < 3; ++v) {
          const double full = double((1 << config.colour_bits) - 1);
          const double difference = change[key].empty() ? 0 : change[key][k][v][c] * full / 255;
          out.key[key].difference[c][v] =
              int(std::floor(std::ldexp(difference, kDifferenceFraction) + 0.5)) + (1 << (difference_bits(config) - 1));
        }
      }
    }
  }
  return frame;
}

}  // namespace halfspace::model
