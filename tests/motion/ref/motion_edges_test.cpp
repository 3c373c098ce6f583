// SPDX-License-Identifier: Apache-2.0
// Faces that enter, leave, cross the near plane, turn their backs, or move farther than the format has.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "ref/error.hpp"
#include "tests/motion/ref/rays.hpp"

namespace halfspace::ref {
namespace {

// One moving triangle, face 1, and a small far one that stands still, face 2; the camera at the origin.
Scene one_triangle(const std::array<glm::dvec3, 3>& corners, bool two_sided = false) {
  Scene scene;
  scene.name = "one triangle";
  scene.materials.resize(1);
  scene.materials[0].two_sided = two_sided;
  const std::array<glm::dvec3, 3> mark{{{-30, 20, -50}, {-25, 20, -50}, {-30, 24, -50}}};
  for (const auto& t : {corners, mark}) {
    scene.meshes.push_back(
        {"triangle", {t.begin(), t.end()}, std::vector<glm::dvec3>(3, {0, 0, 1}), {}, {}, {{0, 1, 2}}, 0});
    scene.instances.push_back({int(scene.meshes.size()) - 1, glm::dmat4(1)});
  }
  scene.camera = camera_at_origin();
  return scene;
}
const std::array<glm::dvec3, 3> kTriangle{{{-1, -1, -5}, {1, -1, -6}, {0, 1, -5}}};
std::array<glm::dvec3, 3> moved(const glm::dvec3& by) {
  return {kTriangle[0] + by, kTriangle[1] + by, kTriangle[2] + by};
}
Times moving(const glm::dvec3& from, const glm::dvec3& to, double a) {
  return {one_triangle(moved(from)), one_triangle(moved(to)), one_triangle(moved(glm::mix(from, to, a))), a};
}
Standing standing(const Scene& scene) { return FacePlaces(scene, kView).standing(1); }

struct Count {
  int pixels = 0;
  OfKeys<int> with{}, inside{};  // a vector; one that leads into the frame
};
Count count(const MotionField& field) {
  Count count;
  for (std::size_t i = 0; i < field.face.size(); ++i) {
    if (field.face[i] != 1) continue;
    ++count.pixels;
    for (int key = 0; key < kKeys; ++key) {
      if (!field.to_key[key][i]) continue;
      ++count.with[key];
      const glm::dvec2 place = *field.to_key[key][i] + centre_of(i);
      count.inside[key] += place.x >= 0 && place.x < kView.width && place.y >= 0 && place.y < kView.height;
    }
  }
  return count;
}
bool shows_face(const Scene& scene) {
  const Geometry geometry(scene, kView);
  const Frame frame = render(snap(geometry.positions(), kFormat));
  for (const std::uint32_t k : frame.index) {
    if (k != 0 && geometry.positions().face[k - 1] == 1) return true;
  }
  return false;
}

// Vectors lead to it all the same, and out of the key's frame.
TEST(Edges, EntersAndLeaves) {
  const Times enters = moving({-6, 0, 0}, {0, 0, 0}, 0.75);
  EXPECT_EQ(standing(enters.first), Standing::kOutside);
  EXPECT_EQ(standing(enters.second), Standing::kDrawn);
  for (const MotionMethod method : {MotionMethod::kExact, MotionMethod::kStraight}) {
    const Count seen = count(motion_field(enters.follow(method), kFormat, VectorMapping::kPerspective));
    ASSERT_GT(seen.pixels, 500);
    EXPECT_EQ(seen.with, (OfKeys<int>{seen.pixels, seen.pixels}));
    EXPECT_EQ(seen.inside, (OfKeys<int>{0, seen.pixels}));
  }
  EXPECT_LT(compare_with_rays(enters).perspective, 1e-6);
  const Times leaves = moving({0, 0, 0}, {0, 6, 0}, 0.25);
  EXPECT_EQ(standing(leaves.second), Standing::kOutside);
  const Count seen = count(motion_field(leaves.follow(MotionMethod::kExact), kFormat, VectorMapping::kPerspective));
  ASSERT_GT(seen.pixels, 500);
  EXPECT_EQ(seen.inside, (OfKeys<int>{seen.pixels, 0}));
}

// A vector beyond the format is refused, for its key and its triangle alone.
TEST(Edges, MovesByMoreThanTheFormatHas) {
  const Between between = moving({-20, 0, 0}, {0, 0, 0}, 0.9).follow(MotionMethod::kExact);
  EXPECT_GT(-vectors(between, 0)[0].value()[0].x, kView.width);
  const auto narrow = fixed_vectors(between, 0, kFormat.subpixel_bits, {8, 4}),
             wide = fixed_vectors(between, 0, kFormat.subpixel_bits, {9, 4});
  EXPECT_FALSE(narrow[0]);
  EXPECT_TRUE(narrow[1]);
  ASSERT_TRUE(wide[0]);
  EXPECT_NEAR((*wide[0])[0][0] / 16.0, vectors(between, 0)[0].value()[0].x, 1 / 16.0);
  const FixedMotionField field = motion_field(between, kFormat, VectorFormat{8, 4});
  int pixels = 0;
  for (std::size_t i = 0; i < field.face.size(); ++i) {
    if (field.face[i] == 0) continue;
    EXPECT_EQ(bool(field.to_key[0][i]), field.face[i] == 2);
    EXPECT_TRUE(field.to_key[1][i]);
    pixels += field.face[i] == 1;
  }
  EXPECT_GT(pixels, 500);
}

// The ends of the range are the format's own: the lowest is in it, the highest is not.
TEST(Edges, RangeOfTheFormat) {
  Between between{};
  between.list.triangles = {{Vertex{8, 8, 0, 0, 0, 0}, Vertex{8, 8, 0, 0, 0, 0}, Vertex{8, 8, 0, 0, 0, 0}}};
  const auto at = [&](double place) {
    Trace trace{};
    trace.screen[0] = std::array<glm::dvec2, 3>{glm::dvec2(place, 8), glm::dvec2(8, 8), glm::dvec2(8, 8)};
    between.traces = {trace};
    return fixed_vectors(between, 0, 8, {4, 2})[0];
  };
  EXPECT_EQ(at(-8).value()[0], (FixedVector{-64, 0}));
  EXPECT_FALSE(at(-8.125 - 1 / 256.0));  // half up, −8.125 would be −64.5 steps, which is −64
  EXPECT_EQ(at(-8.125).value()[0], (FixedVector{-64, 0}));
  EXPECT_EQ(at(24 - 0.125 - 1 / 256.0).value()[0], (FixedVector{63, 0}));
  EXPECT_FALSE(at(24 - 0.125));
}

// No vertex's vector to the key, so no plane; in perspective the points that were before the near plane have theirs.
// Without a place on the screen at a key there is no straight line, and the face is at its exact place.
TEST(Edges, CrossesTheNearPlane) {
  const Times t = moving({0, 0, 4.5}, {0, 0, 0}, 0.5);
  EXPECT_EQ(standing(t.first), Standing::kCrossing);
  EXPECT_EQ(standing(t.between), Standing::kDrawn);
  const Between exact = t.follow(MotionMethod::kExact), straight = t.follow(MotionMethod::kStraight);
  EXPECT_FALSE(vectors(exact, 0)[0]);
  EXPECT_TRUE(vectors(exact, 0)[1]);
  const Count linear = count(motion_field(exact, kFormat, VectorMapping::kLinear)),
              perspective = count(motion_field(exact, kFormat, VectorMapping::kPerspective));
  ASSERT_GT(linear.pixels, 500);
  EXPECT_EQ(linear.with, (OfKeys<int>{0, linear.pixels}));
  EXPECT_GT(perspective.with[0], 0);
  EXPECT_LT(perspective.with[0], perspective.pixels);
  EXPECT_EQ(perspective.with[1], perspective.pixels);
  const Seen seen = compare_with_rays(t);
  EXPECT_LT(seen.perspective, 1e-6);
  EXPECT_GT(seen.absent, 0);
  EXPECT_EQ(straight.fallen_back, 1u);
  ASSERT_EQ(straight.list.face, exact.list.face);
  expect_same(straight.list.triangles[0], exact.list.triangles[0]);
  EXPECT_FALSE(straight.traces[0].straight);
  EXPECT_TRUE(straight.traces.back().straight);
}

TEST(Edges, BehindTheViewerAtAKey) {
  const Times t = moving({0, 0, 12}, {0, 0, 0}, 0.9);
  EXPECT_EQ(standing(t.first), Standing::kBehind);
  const Between exact = t.follow(MotionMethod::kExact);
  for (const VectorMapping mapping : {VectorMapping::kLinear, VectorMapping::kPerspective}) {
    const Count seen = count(motion_field(exact, kFormat, mapping));
    ASSERT_GT(seen.pixels, 500);
    EXPECT_EQ(seen.with, (OfKeys<int>{0, seen.pixels}));
  }
  EXPECT_EQ(t.follow(MotionMethod::kStraight).fallen_back, 1u);
}

// A floor through the near plane: vertices that clipping made follow their own point of the floor, and stay where
// nothing moves.
TEST(Edges, ClippedInBetween) {
  const auto floor = [](double x, double z) {
    Scene scene = one_triangle({{{-4 + x, -1, -20 + z}, {4 + x, -1, -20 + z}, {x, -1, 5 + z}}}, true);
    return scene;
  };
  for (int i = 0; i < 100; ++i) {  // some vertices are rounded to behind the near plane at the key
    const Scene here = floor(0.037 * i, -0.011 * i);
    ASSERT_EQ(standing(here), Standing::kCrossing);
    const Between stays = Times{here, here, here, 0.5}.follow(MotionMethod::kExact);
    ASSERT_GT(stays.traces.size(), 2u);
    for (std::size_t k = 0; k < stays.traces.size(); ++k) {
      const auto to_keys = vectors(stays, k);
      for (const auto& of_key : to_keys) {
        ASSERT_TRUE(of_key) << i;
        for (const glm::dvec2& vector : *of_key) EXPECT_LT(glm::length(vector), 1e-9);
      }
    }
  }
  const Times sideways{floor(-1, -1), floor(2, -2), floor(0.2, 0), 0.4};
  const Seen seen = compare_with_rays(sideways);
  EXPECT_LT(seen.perspective, 1e-6);
  EXPECT_GT(seen.vectors, 5000);
  EXPECT_EQ(seen.absent, 0);
  std::printf("floor through the near plane: perspective-correct within %.1e pixels, planes within %.4f\n",
              seen.perspective, seen.linear);
}

// Its place at the key is known, and the key's frame does not show it: the index there says so.
TEST(Edges, TurnsItsBackAtAKey) {
  const auto turned = [](double angle, bool two_sided) {
    Scene scene = one_triangle(kTriangle, two_sided);
    const glm::dmat4 there = glm::translate(glm::dmat4(1), glm::dvec3(0, 0, -5.5));
    scene.instances[0].to_world = there * glm::rotate(glm::dmat4(1), angle, glm::dvec3(0, 1, 0)) * glm::inverse(there);
    return scene;
  };
  const Times t{turned(2.2, false), turned(0, false), turned(0.66, false), 0.7};
  EXPECT_EQ(standing(t.first), Standing::kCulled);
  EXPECT_EQ(standing(turned(2.2, true)), Standing::kDrawn);
  EXPECT_FALSE(shows_face(t.first));
  EXPECT_TRUE(shows_face(t.second));
  EXPECT_TRUE(shows_face(turned(2.2, true)));
  const Count seen = count(motion_field(t.follow(MotionMethod::kExact), kFormat, VectorMapping::kPerspective));
  ASSERT_GT(seen.pixels, 300);
  EXPECT_EQ(seen.inside, (OfKeys<int>{seen.pixels, seen.pixels}));
  EXPECT_LT(compare_with_rays(t).perspective, 1e-6);
}

// Half a turn in the picture: straight lines all meet in the axis, and the face is gone; exact positions keep it.
TEST(Edges, SpinsByHalfATurn) {
  const auto spun = [](double angle) {
    Scene scene = one_triangle({{{-1, -1, -5}, {1, -1, -5}, {0, 1, -5}}});
    scene.instances[0].to_world = glm::rotate(glm::dmat4(1), angle, glm::dvec3(0, 0, 1));
    return scene;
  };
  const Times t{spun(0), spun(glm::pi<double>()), spun(glm::half_pi<double>()), 0.5};
  EXPECT_EQ(count(motion_field(t.follow(MotionMethod::kStraight), kFormat, VectorMapping::kLinear)).pixels, 0);
  const Seen seen = compare_with_rays(t);
  EXPECT_GT(seen.vectors, 1000);
  EXPECT_LT(seen.perspective, 1e-6);
}

TEST(Edges, FacesThatChangeAreRefused) {
  const Times t = moving({0, 0, 0}, {1, 0, 0}, 0.5);
  Scene other = t.second;
  other.meshes[0].triangles.push_back({0, 2, 1});
  try {
    follow(MotionMethod::kExact, t.first, other, t.between, 0.5, kView);
    FAIL() << "not refused";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("one triangle: its instances or faces"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace halfspace::ref
