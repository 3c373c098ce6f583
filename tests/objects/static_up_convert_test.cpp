// SPDX-License-Identifier: Apache-2.0
// Frames between key frames with an S-buffer: pixels that stand still are the rendered ones to the bit, and those that
// move have the words and the colours of the ordinary method.
#include <gtest/gtest.h>

#include <cstdio>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>

#include "model/drivers/up_convert.hpp"
#include "model/texture/texture.hpp"
#include "ref/builtin/mesh_builder.hpp"
#include "ref/error.hpp"
#include "ref/geometry/viewpoint.hpp"
#include "ref/objects/static_instances.hpp"

namespace halfspace {
namespace {

using model::Configuration;
using model::KernelFrameBetween;
using model::KernelUpConverter;
using ref::Scene;

constexpr int kWidth = 64, kHeight = 48;
constexpr double kAspect = double(kWidth) / kHeight;

enum Part { kBall, kInPlaneFirst, kWall, kInPlaneLater, kThrough, kBehind, kSurprise, kSleeper, kParts };

void add_quad(Scene& scene, const char* name, double rx, double ry) {
  ref::MeshBuilder builder;
  const double hue = 0.11 * double(scene.meshes.size());
  builder.colour = {0.2 + hue, 0.9 - hue, 0.3};
  builder.polygon({{-rx, -ry, 0}, {rx, -ry, 0}, {rx, ry, 0}, {-rx, ry, 0}});
  scene.meshes.push_back(std::move(builder).mesh(name));
  scene.instances.push_back({int(scene.meshes.size()) - 1, glm::dmat4(1)});
}

glm::dmat4 at(double x, double y, double z) { return glm::translate(glm::dmat4(1), glm::dvec3(x, y, z)); }

// At fraction `a` of an interval. The wall, the ball and the sleeper stand. Two quads move in the plane of the wall,
// one drawn before it and one after; one turns through it; one passes behind it; one is behind it at both keys and
// before it in between.
Scene room(double a) {
  Scene scene;
  scene.name = "room";
  ref::Material two_sided;
  two_sided.two_sided = true;
  scene.materials = {two_sided};
  ref::MeshBuilder ball;
  ball.ellipsoid({0, 0, 0}, glm::dvec3(0.4), 12, 8);
  scene.meshes.push_back(std::move(ball).mesh("ball"));
  scene.instances.push_back({kBall, at(-0.7, -0.5, 0.3)});
  add_quad(scene, "first", 0.25, 0.2);
  add_quad(scene, "wall", 1.1, 0.8);
  add_quad(scene, "later", 0.25, 0.2);
  add_quad(scene, "through", 0.4, 0.3);
  add_quad(scene, "behind", 0.5, 0.3);
  add_quad(scene, "surprise", 0.2, 0.2);
  add_quad(scene, "sleeper", 0.15, 0.3);
  scene.instances[kInPlaneFirst].to_world = at(-0.6 + 0.4 * a, 0.4, 0);
  scene.instances[kInPlaneLater].to_world = at(0.6 - 0.4 * a, -0.4, 0);
  scene.instances[kThrough].to_world = glm::rotate(at(0.5, 0.1 * a, 0), 0.5 + 0.6 * a, glm::dvec3(0.2, 1, 0));
  scene.instances[kBehind].to_world = at(-1.2 + 0.5 * a, -0.6 + 0.3 * a, -0.4);
  scene.instances[kSurprise].to_world = at(0, -0.1, a > 0 && a < 1 ? 0.5 : -0.2);
  scene.instances[kSleeper].to_world = at(1.2, 0.5, 0.1);
  ref::Camera camera;
  camera.position = {0, 0, 4};
  camera.half_height = 0.3;
  scene.camera = camera;
  scene.depth_planes = ref::DepthPlanes{2, 6};
  return scene;
}

model::KernelUpConversion mode_of(const char* config, bool static_buffer, int samples = 1) {
  const Configuration colour = model::find_configuration(config);
  Config numbers = model::default_motion(colour.config());
  numbers.samples = samples;
  model::KernelUpConversion mode{kWidth, kHeight, colour,
                                 model::motion_configuration(colour, numbers, kWidth * samples, kHeight * samples)};
  mode.static_buffer = static_buffer;
  return mode;
}

bool same(const model::RawMotion& a, const model::RawMotion& b) {
  for (std::size_t k = 0; k < 2; ++k) {
    const model::RawKeyVector &u = a.key[k], &v = b.key[k];
    if (u.there != v.there || u.x != v.x || u.y != v.y || u.difference != v.difference) return false;
  }
  return a.x == b.x && a.y == b.y && a.face == b.face;
}
bool same(const std::vector<model::RawMotion>& a, const std::vector<model::RawMotion>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& u, const auto& v) { return same(u, v); });
}

// Both methods side by side.
class Pair {
 public:
  explicit Pair(const char* config, int samples = 1)
      : all_(mode_of(config, false, samples)), static_(mode_of(config, true, samples)), samples_(samples) {}

  struct Both {
    KernelFrameBetween ordinary, with;
  };
  void set_keys(const Scene& first, const Scene& second) {
    first_ = first, second_ = second;
    all_.set_keys(first, second), static_.set_keys(first, second);
  }
  // Holds the one against the other.
  Both at(const Scene& between, double a) {
    Both both{all_.at(between, a), static_.at(between, a)};
    const std::vector<bool> still = ref::static_instances(first_, second_, between, kAspect);
    const std::vector<std::uint32_t> instance = ref::instances_of_faces(between);
    seen_.assign(between.instances.size(), 0);
    std::vector<model::RawMotion> moving;
    std::vector<bool> moves(both.ordinary.rendered.size(), false);
    std::uint64_t standing = 0;
    for (const model::RawMotion& word : all_.input().motion) {
      ++seen_[instance[word.face]];
      if (still[instance[word.face]]) {
        ++standing;
        continue;
      }
      moving.push_back(word);
      moves[std::size_t(word.y / samples_) * kWidth + word.x / samples_] = true;
    }
    EXPECT_TRUE(same(static_.input().motion, moving));
    EXPECT_EQ(both.with.words, moving.size());
    EXPECT_EQ(both.with.shares.still, standing);
    EXPECT_EQ(both.with.shares.background, both.ordinary.shares.background);
    EXPECT_EQ(both.with.rendered, both.ordinary.rendered);
    int wrong = 0;
    for (std::size_t n = 0; n < moves.size(); ++n) {
      if (moves[n] && samples_ != 1) continue;  // some of its samples may stand still
      wrong += both.with.colour[n] != (moves[n] ? both.ordinary.colour[n] : both.with.rendered[n]);
    }
    EXPECT_EQ(wrong, 0);
    return both;
  }
  // Pixels of an instance in the last frame, drawn as a whole.
  int seen(std::size_t instance) const { return seen_[instance]; }

 private:
  KernelUpConverter all_, static_;
  const int samples_;
  Scene first_, second_;
  std::vector<int> seen_;
};

// --- pictures ---

TEST(StaticUpConversion, IsTheRenderedFrameWhereNothingMovesAndTheOrdinaryOneElsewhere) {
  for (const char* config : {"low", "middle"}) {
    SCOPED_TRACE(config);
    Pair pair(config);
    pair.set_keys(room(0), room(1));
    for (const double a : {0.2, 0.4, 0.6, 0.8}) {
      const Pair::Both both = pair.at(room(a), a);
      EXPECT_EQ(both.with.static_instances, 3u);
      EXPECT_EQ(both.with.static_triangles != 0, a == 0.2);  // once an interval
      EXPECT_EQ(both.with.triangles, 10u);
      EXPECT_GT(both.with.shares.still, 800u);
      EXPECT_LT(both.with.words, both.ordinary.words / 2);
      EXPECT_LT(both.with.cycles, both.ordinary.cycles);
      // At equal depths the first drawn is seen; what is in no key is rendered.
      EXPECT_GT(pair.seen(kInPlaneFirst), 40);
      EXPECT_EQ(pair.seen(kInPlaneLater), 0);
      EXPECT_GT(pair.seen(kThrough), 20);
      EXPECT_LT(pair.seen(kThrough), 200);
      EXPECT_GT(pair.seen(kBehind), 10);
      EXPECT_GT(both.with.shares.filled, 20u);
    }
  }
}

TEST(StaticUpConversion, HoldsForSamplesToo) {
  Pair pair("middle", 4);
  pair.set_keys(room(0), room(1));
  const Pair::Both both = pair.at(room(0.4), 0.4);
  EXPECT_GT(both.with.shares.still, 16u * 800);
  EXPECT_LT(both.with.words, both.ordinary.words / 2);
}

TEST(StaticUpConversion, WhereAllStandsNothingIsCompensated) {
  Pair pair("low");
  pair.set_keys(room(0), room(0));
  const Pair::Both both = pair.at(room(0), 0.5);
  EXPECT_EQ(both.with.words, 0u);
  EXPECT_EQ(both.with.triangles, 0u);
  EXPECT_EQ(both.with.misses[0] + both.with.misses[1], 0u);
  EXPECT_EQ(both.with.colour, both.with.rendered);
}

TEST(StaticUpConversion, ACourtTakesFewWords) {
  const auto court = [](int n) { return ref::load_scene("court", n / 30.0); };
  Pair pair("middle");
  std::vector<Scene> times;
  for (const int n : {0, 2, 5, 70, 72, 75}) times.push_back(court(n));
  std::vector<const Scene*> all;
  for (const Scene& scene : times) all.push_back(&scene);
  const ref::DepthPlanes planes = ref::held_planes(all, kAspect);
  for (Scene& scene : times) scene.depth_planes = planes;
  pair.set_keys(times[0], times[2]);
  EXPECT_EQ(pair.at(times[1], 0.4).with.static_instances, 6u);  // the castle, and the drone but for its blades
  pair.set_keys(times[3], times[5]);
  const Pair::Both both = pair.at(times[4], 0.4);
  EXPECT_EQ(both.with.static_instances, 1u);
  EXPECT_GT(both.with.words, 20u);
  EXPECT_LT(both.with.words, both.ordinary.words / 10);
}

TEST(StaticUpConversion, TexturesAreKept) {
  const auto textured = [](double a) {
    Scene scene = room(a);
    ref::Texture noise{"noise", 16, 16, {}};
    for (unsigned n = 0, state = 7; n < 256; ++n, state = state * 1664525 + 1013904223)
      noise.texels.push_back({std::uint8_t(state >> 24), std::uint8_t(state >> 16), 128});
    scene.textures = {noise};
    scene.materials[0].texture = 0;
    for (ref::Mesh& mesh : scene.meshes) {
      for (const glm::dvec3& p : mesh.positions) mesh.texture_coordinates.emplace_back(p.x, p.y);
    }
    return scene;
  };
  const Configuration low = model::find_configuration("low");
  const Configuration colour = model::textured_configuration(low, TextureFilter::kBilinear);
  const Configuration motion =
      model::motion_configuration(colour, model::default_motion(colour.config()), kWidth, kHeight);
  model::KernelUpConversion mode{kWidth, kHeight, colour, motion};
  mode.static_buffer = true;
  KernelUpConverter with(mode);
  with.set_keys(textured(0), textured(1));
  const KernelFrameBetween made = with.at(textured(0.4), 0.4);
  EXPECT_EQ(made.static_instances, 3u);
  std::vector<bool> moves(made.rendered.size(), false);
  for (const model::RawMotion& word : with.input().motion) moves[std::size_t(word.y) * kWidth + word.x] = true;
  for (std::size_t n = 0; n < moves.size(); ++n) {
    if (!moves[n]) {
      EXPECT_EQ(made.colour[n], made.rendered[n]) << n;
    }
  }
}

// --- what the S-buffer shows ---

TEST(StaticUpConversion, TheBufferIsKeptWhileNothingInItChanges) {
  Pair pair("low");
  const auto drawn = [&](const Scene& first, const Scene& between, const Scene& second) {
    pair.set_keys(first, second);
    const Pair::Both both = pair.at(between, 0.4);
    EXPECT_GT(both.with.static_instances, 1u);
    return both.with.static_triangles;
  };
  using Change = std::function<void(Scene&)>;
  const auto changed = [&](const Change& change) {
    std::array<Scene, 3> times{room(0), room(0.4), room(1)};
    for (Scene& scene : times) change(scene);
    return drawn(times[0], times[1], times[2]);
  };
  EXPECT_GT(changed([](Scene&) {}), 0u);
  EXPECT_EQ(changed([](Scene&) {}), 0u);
  EXPECT_EQ(changed([](Scene& s) { s.instances[kInPlaneFirst].to_world *= at(0.1, 0, 0); }), 0u);  // moves anyway
  const Change changes[] = {
      [](Scene& s) { s.instances[kSleeper].to_world = at(-1.2, 0.5, 0.1); },
      [](Scene& s) { s.ambient = glm::dvec3(0.1); },
      [](Scene& s) {
        s.background = {200, 0, 0};
      },
      [](Scene& s) { s.lights = {ref::Light()}; },
      [](Scene& s) { s.camera->position.x = 0.1; },
      [](Scene& s) {
        s.depth_planes = ref::DepthPlanes{1, 6};
      },
      [](Scene& s) { s.materials[0].diffuse = glm::dvec3(0.2); },
      [](Scene& s) {
        s.meshes[kWall].colours[2] = {0, 0, 1};
      },
      [](Scene& s) { s.meshes[kWall].positions[2].x = 0.2; },
  };
  for (const Change& change : changes) {
    EXPECT_GT(changed(change), 0u);
    EXPECT_EQ(changed(change), 0u);
  }
  // The ball starts to move, and the sleeper stays.
  changed([](Scene&) {});
  Scene later = room(1);
  later.instances[kBall].to_world = at(-0.6, 0.5, 0.3);
  EXPECT_GT(drawn(room(0), room(0.4), later), 0u);
}

TEST(StaticUpConversion, WhatIsElsewhereInBetweenMoves) {
  Pair pair("low");
  pair.set_keys(room(0), room(1));
  pair.at(room(0.2), 0.2);
  Scene away = room(0.4);
  away.instances[kSleeper].to_world = at(0.9, 0.5, 0.1);
  const Pair::Both both = pair.at(away, 0.4);
  EXPECT_EQ(both.with.static_instances, 2u);
  EXPECT_GT(pair.seen(kSleeper), 10);
  EXPECT_EQ(pair.at(room(0.6), 0.6).with.static_instances, 3u);
}

TEST(StaticUpConversion, IsTheOrdinaryMethodWhereTheViewOrTheLightChanges) {
  using Change = std::function<void(Scene&, double a)>;
  const Change changes[] = {
      [](Scene& s, double a) { s.camera->position.x = 0.2 * a; },
      [](Scene& s, double a) { s.ambient = glm::dvec3(0.2 + 0.1 * a); },
      [](Scene& s, double a) {
        s.lights = {ref::Light()};
        s.lights[0].direction = glm::normalize(glm::dvec3(a, 0, -1));
      },
      [](Scene& s, double a) { s.background.r = 100 * a; },
      // Planes that follow the geometry.
      [](Scene& s, double a) { s.depth_planes.reset(), s.instances[kBehind].to_world = at(0.9, 0, -1 - a); },
  };
  for (const Change& change : changes) {
    const auto scene = [&](double a) {
      Scene s = room(a);
      change(s, a);
      return s;
    };
    Pair pair("low");
    pair.set_keys(scene(0), scene(1));
    const Pair::Both both = pair.at(scene(0.4), 0.4);
    EXPECT_EQ(both.with.static_instances, 0u);
    EXPECT_EQ(both.with.static_triangles, 0u);
    EXPECT_EQ(both.with.colour, both.ordinary.colour);
    EXPECT_EQ(both.with.words, both.ordinary.words);
    EXPECT_EQ(both.with.triangles, both.ordinary.triangles);
  }
}

// --- what is the same ---

TEST(StaticInstances, AreThoseOfWhichNothingChanges) {
  const auto held = [](const std::function<void(Scene&)>& change) {
    Scene other = room(0);
    change(other);
    const std::vector<bool> same = ref::same_instances(room(0), other, kAspect);
    return std::count(same.begin(), same.end(), true);
  };
  EXPECT_EQ(held([](Scene&) {}), kParts);
  EXPECT_EQ(held([](Scene& s) { s.meshes[kBall].positions[5].y += 0.01; }), kParts - 1);  // a pose
  EXPECT_EQ(held([](Scene& s) { s.meshes[kBall].normals[5] = {1, 0, 0}; }), kParts - 1);
  EXPECT_EQ(held([](Scene& s) { s.meshes[kWall].triangles[0] = {0, 1, 3}; }), kParts - 1);
  EXPECT_EQ(held([](Scene& s) {
              s.materials.push_back(s.materials[0]);
              s.meshes[kWall].material = 1;
            }),
            kParts);
  EXPECT_EQ(held([](Scene& s) {
              s.materials.push_back({});
              s.meshes[kWall].material = 1;
            }),
            kParts - 1);
  EXPECT_EQ(held([](Scene& s) {
              s.textures = {ref::Texture{"white", 1, 1, {{255, 255, 255}}}};
              s.materials[0].texture = 0;
            }),
            0);
  EXPECT_EQ(held([](Scene& s) { s.instances.pop_back(); }), 0);
}

TEST(StaticInstances, PlanesHoldAllTimes) {
  const Scene near = ref::load_scene("wheel_in_out", 0), far = ref::load_scene("wheel_in_out", 1);
  const ref::DepthPlanes planes = ref::held_planes({&far, &near}, kAspect);
  EXPECT_EQ(planes.near, ref::depth_planes(near, kAspect).near);
  EXPECT_EQ(planes.far, ref::depth_planes(far, kAspect).far);
}

// --- the reference ---

TEST(StaticUpConversion, TheReferenceHasTheSamePixels) {
  const Configuration colour = model::find_configuration("middle");
  ref::UpConversion mode{kWidth, kHeight, model::raster_format(colour)};
  mode.mapping = ref::VectorMapping::kPerspective;
  mode.relight = true;
  ref::Interval ordinary(room(0), room(1), mode);
  mode.static_buffer = true;
  ref::Interval with(room(0), room(1), mode);
  KernelUpConverter kernels(mode_of("middle", true));
  kernels.set_keys(room(0), room(1));
  for (const double a : {0.2, 0.6}) {
    const ref::FrameBetween made = with.at(room(a), a), all = ordinary.at(room(a), a);
    const KernelFrameBetween by_kernels = kernels.at(room(a), a);
    EXPECT_EQ(made.shares.still, by_kernels.shares.still);
    EXPECT_EQ(made.shares.background, by_kernels.shares.background);
    EXPECT_EQ(made.shares.background, all.shares.background);
    std::vector<bool> moves(made.rendered.size(), false);
    for (const model::RawMotion& word : kernels.input().motion) moves[std::size_t(word.y) * kWidth + word.x] = true;
    for (std::size_t n = 0; n < moves.size(); ++n) {
      EXPECT_EQ(made.colour[n], moves[n] ? all.colour[n] : made.rendered[n]) << n;
    }
  }
}

TEST(StaticUpConversion, RefusesWhatHasNoDepthASample) {
  model::KernelUpConversion mode = mode_of("low", true);
  mode.half_field = true;
  EXPECT_THROW(KernelUpConverter{mode}, ref::Error);
  mode.half_field = false, mode.method = ref::MotionMethod::kStraight;
  EXPECT_THROW(KernelUpConverter{mode}, ref::Error);
  mode.static_buffer = false;
  KernelUpConverter{mode};
  Config flat = model::find_configuration("low").config();
  flat.architecture = Architecture::kGamma;
  const Configuration gamma("gamma", flat);
  model::KernelUpConversion planes{kWidth, kHeight, gamma,
                                   model::motion_configuration(gamma, model::default_motion(flat), kWidth, kHeight)};
  planes.static_buffer = true;
  EXPECT_THROW(KernelUpConverter{planes}, ref::Error);
  ref::UpConversion reference{kWidth, kHeight, model::raster_format("low")};
  reference.static_buffer = true, reference.field = ref::FieldSize::kHalf;
  EXPECT_THROW(ref::Interval(room(0), room(1), reference), ref::Error);
  reference.field = ref::FieldSize::kSamples, reference.method = ref::MotionMethod::kStraight;
  EXPECT_THROW(ref::Interval(room(0), room(1), reference), ref::Error);
}

}  // namespace
}  // namespace halfspace
