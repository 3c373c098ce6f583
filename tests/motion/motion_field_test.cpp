// SPDX-License-Identifier: Apache-2.0
// The motion field of the kernels against the reference's, within the bound of each pixel: animated scenes, words as no
// scene has them, and the ends of formats.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "model/formats/field_value.hpp"
#include "model/pipeline/engine_impl.hpp"
#include "ref/motion/motion_field.hpp"
#include "ref/raster/plane.hpp"
#include "study/proofs/motion_bounds.hpp"
#include "tests/config_path.hpp"
#include "tests/motion/motion_configs.hpp"
#include "vectors/extremes.hpp"
#include "vectors/standard_set.hpp"

namespace halfspace::tests {
namespace {

constexpr double kTiny = 1e-9;  // of doubles, pixels

model::Configuration configuration_of(const Config& config) { return model::Configuration(config.name, config); }

// What the kernels made of a frame.
struct Field {
  ref::SnappedList list;
  model::MotionFrame words;
  std::vector<std::uint32_t> triangle;  // at each pixel
  std::vector<model::RawMotion> motion;
};

Field field_of(model::Engine& engine, const ref::SnappedList& list, const model::MotionFrame& words) {
  engine.move(words);
  return {list, words, engine.render(list).index, engine.motion(list, nullptr)};
}

ref::View view_of(const ref::RasterFormat& format, int width, int height) {
  return {width, height, format.range_bits, format.subpixel_bits};
}

// The triangles as they are snapped, and where places are planes, these too: what the field is exact of.
ref::Between snapped(ref::Between between, const ref::SnappedList& list, const Config& config) {
  const ref::TriangleList on_grid = ref::unsnap(list);
  for (std::size_t k = 0; k < between.traces.size(); ++k) {
    for (int v = 0; v < 3; ++v) {
      between.list.triangles[k][v].x = on_grid.triangles[k][v].x;
      between.list.triangles[k][v].y = on_grid.triangles[k][v].y;
      for (auto& screen : between.traces[k].screen) {
        for (int axis = 0; screen && !has_perspective(config) && axis < 2; ++axis) {
          double& at = (*screen)[v][axis];
          at = std::ldexp(ref::snapped_position(at, config.subpixel_bits), -config.subpixel_bits);
        }
      }
    }
  }
  return between;
}

// The exact planes of the words of a triangle at a pixel.
struct Exact {
  glm::dvec2 place;  // less the origin, in units of 2^e
  double q, distance, least, spread;
};
Exact exact_at(const ref::SnappedTriangle& triangle, const model::RawKeyPlaces& key, int x, int y,
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

// The words of `motion` are those of the covered pixels, each once, stamps in order and lanes in order.
void expect_each_pixel_once(const Field& field, int lanes_x, int lanes_y) {
  std::vector<std::pair<int, int>> expected;
  const int width = field.list.width, height = field.list.height;
  for (int y = 0; y < height; y += lanes_y) {
    for (int x = 0; x < width; x += lanes_x) {
      for (int l = 0; l < lanes_x * lanes_y; ++l) {
        const int px = x + l % lanes_x, py = y + l / lanes_x;
        if (px < width && py < height && field.triangle[std::size_t(py) * width + px] != 0)
          expected.emplace_back(px, py);
      }
    }
  }
  std::vector<std::pair<int, int>> found;
  for (const auto& word : field.motion) found.emplace_back(word.x, word.y);
  EXPECT_FALSE(expected.empty());
  EXPECT_EQ(found, expected);
}

TEST_P(MotionFieldTest, AnimationsAreWithinTheBound) {
  std::printf("%s: largest error, pixels; its share of the bound of the pixel\n", GetParam());
  double largest_share = 0;
  for (const std::string& name : ref::animated_scene_names()) {
    double largest = 0, share = 0;
    std::size_t compared = 0, beyond = 0;
    for (const double first : {0.0, 0.5, 1.1}) {
      const ref::Between motion = between(name, first, first + 5 / 30.0, 0.4);
      const Field field = drawn(motion);
      expect_each_pixel_once(field, engine_->lanes_x(), engine_->lanes_y());
      const ref::MotionField exact =
          ref::motion_field(snapped(motion, field.list, config_), format_,
                            has_perspective(config_) ? ref::VectorMapping::kPerspective : ref::VectorMapping::kLinear);
      for (const auto& word : field.motion) {
        const std::size_t at = std::size_t(word.y) * field.list.width + word.x;
        const std::uint32_t k = field.triangle[at];
        ASSERT_EQ(int(word.face), model::face_number(motion.traces[k - 1].face, config_));
        if (k != exact.triangle[at]) continue;  // surfaces closer than an LSB of depth
        for (int key = 0; key < ref::kKeys; ++key) {
          const model::RawKeyPlaces& words = field.words.triangles[k - 1].key[key];
          if (!words.there) {
            ASSERT_FALSE(word.key[key].there) << name;
            continue;
          }
          ASSERT_TRUE(exact.to_key[key][at].has_value());
          const Exact at_pixel = exact_at(field.list.triangles[k - 1], words, word.x, word.y, config_);
          const double part = std::max(at_pixel.place.x, at_pixel.place.y);
          const double bound =
              model::motion_bound(config_, words.extent, part, at_pixel.q, at_pixel.distance) +
              model::motion_vertex_bound(config_, words.extent, at_pixel.spread, at_pixel.q, at_pixel.least) + kTiny;
          const glm::dvec2 vector = *exact.to_key[key][at];
          if (!word.key[key].there) {
            ++beyond;
            ASSERT_TRUE(std::max(std::abs(vector.x), std::abs(vector.y)) >= range_ - unit_ - bound) << name;
            continue;
          }
          for (int axis = 0; axis < 2; ++axis) {
            const double error = std::abs((axis ? word.key[key].y : word.key[key].x) * unit_ - vector[axis]);
            ASSERT_LE(error, bound) << name << ", pixel (" << word.x << ", " << word.y << "), key " << key;
            largest = std::max(largest, error);
            share = std::max(share, error / bound);
          }
          ++compared;
        }
      }
    }
    EXPECT_GT(compared, 1000u) << name;
    std::printf("  %-14s %.4f  %.3f  %zu vectors, %zu out of range\n", name.c_str(), largest, share, compared, beyond);
    largest_share = std::max(largest_share, share);
  }
  EXPECT_GT(largest_share, 0.5);  // a bound that is far off says nothing
}

// Planes of the vectors as they are, positions not snapped: two snapped ends more.
TEST_P(MotionFieldTest, AffineFieldsAreThoseOfTheReference) {
  if (has_perspective(config_)) GTEST_SKIP();
  for (const std::string& name : ref::animated_scene_names()) {
    const ref::Between motion = between(name, 0.3, 0.3 + 5 / 30.0, 0.6);
    const Field field = drawn(motion);
    const ref::MotionField exact = ref::motion_field(motion, format_, ref::VectorMapping::kLinear);
    std::size_t compared = 0;
    for (const auto& word : field.motion) {
      const std::size_t at = std::size_t(word.y) * field.list.width + word.x;
      const std::uint32_t k = field.triangle[at];
      if (k != exact.triangle[at]) continue;
      for (int key = 0; key < ref::kKeys; ++key) {
        if (!word.key[key].there) continue;
        const model::RawKeyPlaces& words = field.words.triangles[k - 1].key[key];
        const Exact at_pixel = exact_at(field.list.triangles[k - 1], words, word.x, word.y, config_);
        const double bound = model::motion_bound(config_, words.extent, 1, at_pixel.q, at_pixel.distance) +
                             model::motion_vertex_bound(config_, words.extent, 1, at_pixel.q, at_pixel.least) +
                             std::ldexp(1.0, -config_.subpixel_bits) + kTiny;
        ASSERT_LE(std::abs(word.key[key].x * unit_ - exact.to_key[key][at]->x), bound) << name;
        ASSERT_LE(std::abs(word.key[key].y * unit_ - exact.to_key[key][at]->y), bound) << name;
        ++compared;
      }
    }
    EXPECT_GT(compared, 500u) << name;
  }
}

TEST_P(MotionFieldTest, WhereNothingMovesVectorsAreZero) {
  for (const char* name : {"cube_slow", "wheel_turn", "drone"}) {
    const Field field = drawn(between(name, 0.7, 0.7, 0.5));
    for (const auto& word : field.motion) {
      for (const auto& key : word.key) {
        ASSERT_TRUE(key.there) << name;
        ASSERT_EQ(key.x, 0) << name << ", pixel (" << word.x << ", " << word.y << ")";
        ASSERT_EQ(key.y, 0) << name << ", pixel (" << word.x << ", " << word.y << ")";
      }
    }
  }
}

// A triangle that is moved as it is, by the same way to both keys.
class OneTriangle : public MotionFieldTest {
 protected:
  ref::Between moved(const glm::dvec2& way) const {
    ref::Between motion;
    motion.list = {64, 48, {0, 0, 0}, {}, {}};
    const glm::dvec2 corner[3] = {{10, 8}, {40, 12}, {20, 40}};
    ref::Trace trace{7, true, {1, 1, 1}, {}, {}};
    std::array<ref::Vertex, 3> triangle;
    for (int v = 0; v < 3; ++v) triangle[v] = {corner[v].x, corner[v].y, 0.5, 0, 0, 0};
    for (auto& screen : trace.screen) {
      screen.emplace();
      for (int v = 0; v < 3; ++v) (*screen)[v] = corner[v] + way;
    }
    motion.list.triangles.push_back(triangle);
    motion.list.face.push_back(7);
    motion.traces.push_back(trace);
    return motion;
  }
};

TEST_P(OneTriangle, VectorsReachTheEndsOfTheirRange) {
  const double last = range_ - unit_, guard = std::ldexp(1.0, config_.range_bits - 1);
  struct Case {
    double way;
    bool there;
  };
  for (const Case& one :
       {Case{last, true}, Case{range_, false}, Case{-range_, true}, Case{-range_ - unit_, false}, Case{guard, false}}) {
    for (const glm::dvec2& way : {glm::dvec2(one.way, 0), glm::dvec2(0, one.way)}) {
      const Field field = drawn(moved(way));
      ASSERT_GT(field.motion.size(), 100u);
      for (const auto& word : field.motion) {
        EXPECT_EQ(word.face, 7u);
        for (const auto& key : word.key) {
          ASSERT_EQ(key.there, one.there) << one.way;
          ASSERT_EQ(key.x, one.there ? int(way.x / unit_) : 0);
          ASSERT_EQ(key.y, one.there ? int(way.y / unit_) : 0);
        }
      }
    }
  }
}

// Nearer than the near plane at one key: no vectors to that one, whatever the other has.
TEST_P(OneTriangle, KeysAreThereOrNotEachForItself) {
  for (int key = 0; key < ref::kKeys; ++key) {
    ref::Between motion = moved({3, -2});
    motion.traces[0].screen[key].reset();
    for (const auto& word : drawn(motion).motion) {
      ASSERT_FALSE(word.key[key].there);
      ASSERT_EQ(word.key[key].x, 0);
      ASSERT_TRUE(word.key[1 - key].there);
      ASSERT_EQ(word.key[1 - key].x, int(3 / unit_));
      ASSERT_EQ(word.key[1 - key].y, int(-2 / unit_));
    }
  }
}

TEST_P(OneTriangle, FaceNumbersBeginAgain) {
  const std::uint32_t faces = (1u << config_.face_bits) - 1;
  EXPECT_EQ(model::face_number(1, config_), 1);
  EXPECT_EQ(model::face_number(faces, config_), int(faces));
  EXPECT_EQ(model::face_number(faces + 1, config_), 1);
}

// A frame whose last stamp is background ends with a word of face 0, and one without a triangle is that word alone.
TEST_P(OneTriangle, TheEndOfAFrameIsAWord) {
  const Field field = drawn(moved({1, 1}));
  ref::SnappedList none = field.list;
  none.triangles.clear();
  for (const bool drawn : {true, false}) {
    engine_->move(drawn ? field.words : model::MotionFrame{});
    std::size_t words = 0, lasts = 0, of_no_face = 0;
    engine_->capture(drawn ? field.list : none,
                     [&](const model::Layout& layout, const model::Word* word, std::size_t count) {
                       if (layout.stream != "motion") return;
                       words = count;
                       for (std::size_t n = 0; n < count; ++n) {
                         const bool last = model::field_value(word[n], model::field_named(layout, "last")) != 0;
                         lasts += last;
                         of_no_face += model::field_value(word[n], model::field_named(layout, "face")) == 0;
                         EXPECT_EQ(last, n + 1 == count);
                       }
                     });
    EXPECT_EQ(words, (drawn ? field.motion.size() : 0) + 1);
    EXPECT_EQ(lasts, 1u);
    EXPECT_EQ(of_no_face, 1u);
  }
}

// Words as no scene has them, on triangles of all kinds, slivers among them: against the exact planes of the words.
TEST_P(MotionFieldTest, AwkwardWordsAreWithinTheBound) {
  std::vector<model::NamedFrame> frames = model::sliver_frames(format_);
  for (auto& frame : model::random_frames(format_, 3, 4, 60)) frames.push_back(std::move(frame));
  double share = 0, difference_share = 0;
  std::size_t compared = 0, out_of_range = 0;
  for (std::size_t n = 0; n < frames.size(); ++n) {
    const ref::SnappedList& list = frames[n].scene;
    const Field field = field_of(*engine_, list, model::awkward_motion(list, config_, n + 1));
    for (const auto& word : field.motion) {
      const std::uint32_t k = field.triangle[std::size_t(word.y) * list.width + word.x];
      for (int key = 0; key < ref::kKeys; ++key) {
        const model::RawKeyPlaces& words = field.words.triangles[k - 1].key[key];
        if (!words.there) {
          ASSERT_FALSE(word.key[key].there);
          continue;
        }
        const Exact exact = exact_at(list.triangles[k - 1], words, word.x, word.y, config_);
        const double bound = model::motion_bound(config_, words.extent, std::max(exact.place.x, exact.place.y), exact.q,
                                                 exact.distance) +
                             kTiny;
        const glm::dvec2 vector = glm::dvec2(words.origin_x, words.origin_y) +
                                  exact.place * std::ldexp(1.0, words.extent) - glm::dvec2(word.x + 0.5, word.y + 0.5);
        if (!word.key[key].there) {
          ++out_of_range;
          ASSERT_GE(std::max(std::abs(vector.x), std::abs(vector.y)), range_ - unit_ - bound);
          continue;
        }
        for (int axis = 0; axis < 2; ++axis) {
          const double error = std::abs((axis ? word.key[key].y : word.key[key].x) * unit_ - vector[axis]);
          ASSERT_LE(error, bound) << frames[n].note << ", pixel (" << word.x << ", " << word.y << ")";
          share = std::max(share, error / bound);
        }
        ++compared;
        if (!relights(config_)) continue;
        const ref::OrderedTriangle t(list.triangles[k - 1]);
        const int s = config_.subpixel_bits;
        const auto weight = ref::vertex_weights(t, ref::pixel_centre(word.x, s), ref::pixel_centre(word.y, s));
        for (int c = 0; c < 3; ++c) {
          double difference = -std::ldexp(1.0, difference_bits(config_) - 1);
          for (int v = 0; v < 3; ++v) difference += weight[v] * words.difference[c][v];
          const double error = std::abs(word.key[key].difference[c] - difference);
          const double limit = model::difference_bound(config_, exact.distance) + kTiny;
          ASSERT_LE(error, limit);
          difference_share = std::max(difference_share, error / limit);
        }
      }
    }
  }
  std::printf("%s: awkward words, %.3f of the bound at most, differences %.3f; %zu vectors, %zu out of range\n",
              GetParam(), share, difference_share, compared, out_of_range);
  EXPECT_GT(compared, 1000u);
  EXPECT_GT(out_of_range, 0u);
  EXPECT_GT(share, 0.5);
}

INSTANTIATE_TEST_SUITE_P(Configurations, MotionFieldTest,
                         testing::Values("motion_low", "motion_middle", "motion_high", "motion_gamma"));
INSTANTIATE_TEST_SUITE_P(Configurations, OneTriangle,
                         testing::Values("motion_low", "motion_middle", "motion_high", "motion_gamma"));

// The kernels as compiled for a configuration give the words that they give with formats read at run time.
template <class C>
void expect_compiled_words() {
  const model::Configuration configuration = configuration_of(C::config());
  const std::unique_ptr<model::Engine> compiled = std::make_unique<model::KernelEngine<Formats<C, Stamp4>>>();
  const auto read = model::make_engine(configuration, 4);
  std::size_t compared = 0;
  for (const auto& frame : model::random_frames(model::raster_format(configuration), 5, 2, 60)) {
    const model::MotionFrame words = model::awkward_motion(frame.scene, C::config(), 9);
    const Field a = field_of(*compiled, frame.scene, words), b = field_of(*read, frame.scene, words);
    ASSERT_EQ(a.motion.size(), b.motion.size());
    for (std::size_t n = 0; n < a.motion.size(); ++n) {
      const model::RawMotion &x = a.motion[n], &y = b.motion[n];
      ASSERT_TRUE(x.x == y.x && x.y == y.y && x.face == y.face);
      for (int key = 0; key < ref::kKeys; ++key) {
        ASSERT_TRUE(x.key[key].there == y.key[key].there && x.key[key].x == y.key[key].x &&
                    x.key[key].y == y.key[key].y && x.key[key].difference == y.key[key].difference);
        compared += x.key[key].there;
      }
    }
  }
  EXPECT_GT(compared, 1000u);
}
TEST(MotionFieldFormats, CompiledAffine) { expect_compiled_words<MotionLow>(); }
TEST(MotionFieldFormats, CompiledPerspective) { expect_compiled_words<MotionMiddle>(); }

}  // namespace
}  // namespace halfspace::tests
