// SPDX-License-Identifier: Apache-2.0
// Built-in scenes: closed, outside out, within the frame of every configuration.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <set>

#include "tests/geometry/three_formats.hpp"

namespace halfspace::ref {
namespace {

double area(const Mesh& mesh, const std::array<std::uint32_t, 3>& t) {
  const auto& p = mesh.positions;
  return glm::length(glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]])) / 2;
}

TEST(Scenes, TeapotIsNewells) {
  const Mesh mesh = load_scene("teapot").meshes.at(0);
  EXPECT_EQ(mesh.triangles.size(), 3136u);
  EXPECT_EQ(std::count_if(mesh.triangles.begin(), mesh.triangles.end(), [&](auto& t) { return area(mesh, t) < 1e-12; }),
            56);
}

TEST(Scenes, WindingsAndNormalsPointOutward) {
  for (const std::string& name : builtin_scene_names()) {
    const Scene scene = load_scene(name);
    for (const Mesh& mesh : scene.meshes) {
      for (const auto& t : mesh.triangles) {
        if (area(mesh, t) < 1e-12) continue;
        const auto& p = mesh.positions;
        const glm::dvec3 face = glm::normalize(glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]));
        for (const std::uint32_t i : t) {
          EXPECT_NEAR(glm::length(mesh.normals[i]), 1, 1e-9) << name;
          ASSERT_GT(glm::dot(face, mesh.normals[i]), 0.1) << name << " vertex " << i;
        }
      }
    }
  }
}

TEST(Scenes, SolidsAreClosedAndOutsideOut) {
  using Place = std::array<long, 3>;
  const auto place = [](const glm::dvec3& p) {
    return Place{std::lround(p.x * 1e6), std::lround(p.y * 1e6), std::lround(p.z * 1e6)};
  };
  for (const char* name : {"cube", "pyramid", "ring", "wheel", "two_tone"}) {
    for (const Mesh& mesh : load_scene(name).meshes) {
      std::map<std::pair<Place, Place>, int> balance;
      double volume = 0;
      for (const auto& t : mesh.triangles) {
        const auto& p = mesh.positions;
        volume += glm::dot(p[t[0]], glm::cross(p[t[1]], p[t[2]])) / 6;
        for (int i = 0; i < 3; ++i) {
          const Place from = place(p[t[i]]), to = place(p[t[(i + 1) % 3]]);
          from < to ? ++balance[{from, to}] : --balance[{to, from}];
        }
      }
      EXPECT_GT(volume, 0) << name << " " << mesh.name;
      for (const auto& [edge, count] : balance) ASSERT_EQ(count, 0) << name << " " << mesh.name;
    }
  }
}

// Which is why it is said to be of two colours: across an edge lies the other one.
TEST(Scenes, NeighboursInTwoToneDiffer) {
  const Mesh mesh = load_scene("two_tone").meshes.at(0);
  EXPECT_EQ(mesh.triangles.size(), 24u);
  std::map<std::set<std::array<double, 3>>, std::vector<double>> red;  // of the triangles at an edge
  for (const auto& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      std::set<std::array<double, 3>> edge;
      for (const std::uint32_t v : {t[i], t[(i + 1) % 3]})
        edge.insert({mesh.positions[v].x, mesh.positions[v].y, mesh.positions[v].z});
      red[edge].push_back(mesh.colours[t[i]].r);
    }
  }
  EXPECT_EQ(red.size(), 36u);
  for (const auto& [edge, of] : red) {
    ASSERT_EQ(of.size(), 2u);
    EXPECT_NE(of[0], of[1]);
  }
}

TEST(Scenes, AllFitAllConfigurationsAndTheFrame) {
  for (const std::string& name : builtin_scene_names()) {
    for (const RasterFormat& format : kAll) {
      const TriangleList list = project(load_scene(name), view_of(format));
      for (const auto& triangle : list.triangles) {
        for (const Vertex& v : triangle) {
          ASSERT_TRUE(v.x >= 0 && v.x <= format.width && v.y >= 0 && v.y <= format.height)
              << name << " " << format.name;
          ASSERT_TRUE(v.z > 0 && v.z < 1) << name;
        }
      }
      const double share = double(covered(render(snap(list, format)))) / (format.width * format.height);
      EXPECT_GT(share, 0.2) << name << " " << format.name;
    }
  }
}

TEST(Scenes, CastleHidesMuchOfItself) {
  const TriangleList list = project(load_scene("castle"), view_of(kMiddle));
  EXPECT_GE(list.triangles.size(), 2000u);
  EXPECT_LE(list.triangles.size(), 4095u);
  const Frame frame = render(snap(list, kMiddle));
  EXPECT_GT(std::count(frame.visible.begin(), frame.visible.end(), false), 300);
}

}  // namespace
}  // namespace halfspace::ref
