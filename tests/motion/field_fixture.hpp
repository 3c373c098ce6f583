// SPDX-License-Identifier: Apache-2.0
// Motion fields that the kernels make, and the exact planes of the words that they make them from.
#ifndef HALFSPACE_TESTS_MOTION_FIELD_FIXTURE_HPP_
#define HALFSPACE_TESTS_MOTION_FIELD_FIXTURE_HPP_

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "model/pipeline/engine.hpp"
#include "ref/geometry/plane.hpp"
#include "ref/motion/motion_field.hpp"
#include "study/proofs/motion_bounds.hpp"
#include "tests/config_path.hpp"

namespace halfspace::tests {

constexpr double kTiny = 1e-9;  // of doubles, pixels

// What the kernels made of a frame.
struct Field {
  ref::SnappedList list;
  model::MotionFrame words;
  std::vector<std::uint32_t> triangle;  // at each pixel
  std::vector<model::RawMotion> motion;
};

inline Field field_of(model::Engine& engine, const ref::SnappedList& list, const model::MotionFrame& words) {
  engine.move(words);
  return {list, words, engine.render(list).index, engine.motion(list, nullptr)};
}

inline ref::View view_of(const ref::RasterFormat& format, int width, int height) {
  return {width, height, format.range_bits, format.subpixel_bits};
}

// The exact planes of the words of a triangle at a pixel.
struct Exact {
  glm::dvec2 place;  // less the origin, in units of 2^e
  double q, distance, least, spread;
};
inline Exact exact_at(const ref::SnappedTriangle& triangle, const model::RawKeyPlaces& key, int x, int y,
                      const Config& config) {
  const int s = config.subpixel_bits;
  const ref::OrderedTriangle t(triangle);
  const auto weight = ref::vertex_weights(t, ref::pixel_centre(x, s), ref::pixel_centre(y, s));
  Exact exact{{0, 0}, 0, 0, 1e30, 0};
  const double full = std::ldexp(1.0, config.coordinate_bits);
  for (int v = 0; v < 3; ++v) {
    const double q = has_perspective(config) ? key.q[v] : full;
    exact.place += weight[v] * glm::dvec2(key.s[v], key.t[v]);
    exact.q += weight[v] * q;
    exact.least = std::min(exact.least, q);
    const double dx = std::ldexp(double(ref::pixel_centre(x, s) - triangle.x[v]), -s);
    const double dy = std::ldexp(double(ref::pixel_centre(y, s) - triangle.y[v]), -s);
    exact.distance = std::max(exact.distance, std::abs(dx) + std::abs(dy));
  }
  exact.place /= exact.q;
  for (int v = 0; v < 3; ++v) {
    const double q = has_perspective(config) ? key.q[v] : full;
    for (int axis = 0; axis < 2; ++axis) {
      exact.spread = std::max(exact.spread, std::abs((axis ? key.t : key.s)[v] / q - exact.place[axis]));
    }
  }
  return exact;
}

class MotionFieldTest : public testing::TestWithParam<const char*> {
 protected:
  const model::Configuration configuration_ = model::find_configuration(config_path(GetParam()));
  const Config config_ = configuration_.config();
  const ref::RasterFormat format_ = model::raster_format(configuration_);
  const std::unique_ptr<model::Engine> engine_ = model::make_engine(configuration_, 4);
  const double unit_ = std::ldexp(1.0, -config_.vector_fraction), range_ = std::ldexp(1.0, config_.vector_range);

  ref::Between between(const std::string& name, double first, double second, double a, int width = 160,
                       int height = 120) const {
    const double time = (1 - a) * first + a * second;
    return ref::follow(ref::MotionMethod::kExact, ref::load_scene(name, first), ref::load_scene(name, second),
                       ref::load_scene(name, time), a, view_of(format_, width, height));
  }
  Field drawn(const ref::Between& motion) const {
    return field_of(*engine_, ref::snap(motion.list, format_), model::motion_frame(motion, config_));
  }
};

}  // namespace halfspace::tests

#endif  // HALFSPACE_TESTS_MOTION_FIELD_FIXTURE_HPP_
