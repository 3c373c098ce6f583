// SPDX-License-Identifier: Apache-2.0
// Key frames: mixed pixels, identities of faces and of surfaces.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "ref/motion/up_convert.hpp"

namespace halfspace::ref {
namespace {

TEST(KeyFrames, PureOnesHaveNoMixedPixels) {
  const DrawnFrame frame{4,
                         2,
                         {{10, 0, 0, 255},
                          {20, 0, 0, 255},
                          {1, 1, 1, 255},
                          {1, 1, 1, 255},
                          {30, 0, 0, 255},
                          {42, 0, 0, 255},
                          {1, 1, 1, 255},
                          {2, 2, 2, 255}},
                         {1, 2, 3, 3, 1, 2, 3, 0}};
  const KeyFrame faces = pure_key_frame(frame, 2, {0, 1, 2, 3}), surfaces = pure_key_frame(frame, 2, {0, 7, 7, 8});
  EXPECT_EQ(faces.identity, (std::vector<std::uint32_t>{0, 0}));
  EXPECT_EQ(surfaces.identity, (std::vector<std::uint32_t>{7, 0}));
  EXPECT_EQ(faces.colour[0], (std::array<std::uint8_t, 4>{26, 0, 0, 255}));  // 25.5
  EXPECT_EQ(faces.colour[1], (std::array<std::uint8_t, 4>{1, 1, 1, 255}));   // 1.25
}

// Pixels of 2 × 2 samples: of faces 1 and 2 two each, 2 first; of face 3 one beside the background; of the background;
// of faces 1, 2, 3, of which 1 has two.
TEST(KeyFrames, APixelKeepsTheFaceOfMostOfItsSamplesAndTheNext) {
  const auto grey = [](int level) { return std::array<std::uint8_t, 4>{std::uint8_t(level), 0, 0, 255}; };
  const DrawnFrame frame{8,
                         2,
                         {grey(10), grey(20), grey(0), grey(0), grey(9), grey(9), grey(30), grey(80), grey(41),
                          grey(60), grey(0), grey(200), grey(9), grey(9), grey(81), grey(100)},
                         {2, 1, 0, 0, 0, 0, 3, 1, 1, 2, 0, 3, 0, 0, 1, 2}};
  const Identities numbers{0, 1, 2, 3};
  const KeyFrame most = key_frame(frame, 2, numbers), next = second_key_frame(frame, 2, numbers);
  EXPECT_EQ(most.identity, (std::vector<std::uint32_t>{2, 3, 0, 1}));
  EXPECT_EQ(next.identity, (std::vector<std::uint32_t>{1, 0, 0, 3}));
  EXPECT_EQ(most.colour, (Colours{grey(35), grey(200), grey(9), grey(81)}));  // the last 80.5
  EXPECT_EQ(next.colour[0], grey(31));                                        // 30.5
  EXPECT_EQ(next.colour[3], grey(30));
  // Faces of one surface are one.
  const KeyFrame surfaces = key_frame(frame, 2, {0, 7, 7, 8});
  EXPECT_EQ(surfaces.identity, (std::vector<std::uint32_t>{7, 8, 0, 7}));
  EXPECT_EQ(surfaces.colour[3], grey(87));
  // A pixel of one sample is what it is.
  EXPECT_EQ(key_frame(frame, 1, numbers).identity, frame.face);
  EXPECT_EQ(key_frame(frame, 1, numbers).colour, frame.colour);
}

TEST(KeyFrames, SurfacesAreSmoothGroupsOfAnInstance) {
  const auto of = [](const char* name) { return surface_identities(load_scene(name)); };
  EXPECT_EQ(of("cube"), (Identities{0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6}));
  const Identities ring = of("ring");
  EXPECT_EQ(*std::max_element(ring.begin(), ring.end()), 1u);
  Scene twice = load_scene("ring");
  twice.instances.push_back(twice.instances[0]);
  EXPECT_EQ(surface_identities(twice).back(), 2u);
  EXPECT_EQ(face_identities(twice).back(), surface_identities(twice).size() - 1);
}

TEST(BoxTexture, LeavesFacesInPlace) {
  for (const std::string& name : animated_scene_names()) {
    const Scene plain = load_scene(name, 0.5), textured = load_scene(name, 0.5, {true});
    ASSERT_EQ(plain.meshes.size(), textured.meshes.size());
    for (std::size_t m = 0; m < plain.meshes.size(); ++m) {
      const Mesh &a = plain.meshes[m], &b = textured.meshes[m];
      ASSERT_EQ(a.triangles.size(), b.triangles.size());
      ASSERT_EQ(b.texture_coordinates.size(), b.positions.size());
      for (std::size_t t = 0; t < a.triangles.size(); ++t) {
        for (int v = 0; v < 3; ++v) {
          EXPECT_EQ(a.positions[a.triangles[t][v]], b.positions[b.triangles[t][v]]);
          EXPECT_EQ(a.normals[a.triangles[t][v]], b.normals[b.triangles[t][v]]);
        }
      }
    }
    EXPECT_EQ(surface_identities(plain), surface_identities(textured));
  }
}

}  // namespace
}  // namespace halfspace::ref
