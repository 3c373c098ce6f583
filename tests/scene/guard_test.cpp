// SPDX-License-Identifier: Apache-2.0
// Reading in a child process: a document comes back whole, and whatever becomes of the child is one sentence.
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstring>

#include "ref/scene/check_document.hpp"
#include "ref/scene/guard/guarded_read.hpp"
#include "tests/scene/refusal.hpp"

namespace halfspace::ref {
namespace {

constexpr ReadLimits kLimits{1, 256};

Document small_document() {
  Document d;
  d.name = "file";
  Node root;
  root.name = "Wurzel ü";
  root.rotation = {0.5, 0.5, 0.5, 0.5};
  Node leaf;
  leaf.parent = 0;
  leaf.meshes = {0};
  leaf.skin = 0;
  leaf.weights = {0.25};
  d.nodes = {root, leaf};
  DocumentMesh mesh;
  mesh.mesh.name = "mesh";
  mesh.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.mesh.normals.assign(3, {0, 0, 1});
  mesh.mesh.triangles = {{0, 1, 2}};
  mesh.targets = {{{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}, {}, 0.5}};
  mesh.joint_weights = {{2, 0, 0.75}};
  d.meshes = {mesh};
  d.skins = {{{1, glm::dmat4(2)}}};
  d.materials.resize(2);
  d.materials[1].texture = 0;
  d.textures = {{"picture", 2, 1, {{1, 2, 3}, {4, 5, 6}}}};
  d.animations = {{"turn", 2, {{1, ChannelPath::kRotation, Interpolation::kStep, {0, 2}, {0, 0, 0, 1, 1, 0, 0, 0}}}}};
  d.cameras = {{"eye", 1, Camera(), true}};
  d.lights = {{0, Light()}};
  d.ambient = glm::dvec3(0.125);
  d.remarks = {"one", "two"};
  return d;
}

TEST(Guard, ADocumentComesBackWhole) {
  const Document sent = small_document(), got = guarded_read("file", small_document, kLimits);
  EXPECT_EQ(got.name, sent.name);
  ASSERT_EQ(got.nodes.size(), 2u);
  EXPECT_EQ(got.nodes[0].name, sent.nodes[0].name);
  EXPECT_EQ(got.nodes[0].rotation, sent.nodes[0].rotation);
  EXPECT_EQ(got.nodes[1].parent, 0);
  EXPECT_EQ(got.nodes[1].meshes, sent.nodes[1].meshes);
  EXPECT_EQ(got.nodes[1].weights, sent.nodes[1].weights);
  EXPECT_EQ(got.meshes[0].mesh.positions, sent.meshes[0].mesh.positions);
  EXPECT_EQ(got.meshes[0].mesh.triangles, sent.meshes[0].mesh.triangles);
  EXPECT_EQ(got.meshes[0].targets[0].positions, sent.meshes[0].targets[0].positions);
  EXPECT_EQ(got.meshes[0].joint_weights[0].weight, 0.75);
  EXPECT_EQ(got.skins[0][0].from_mesh, glm::dmat4(2));
  EXPECT_EQ(got.materials[1].texture, 0);
  EXPECT_EQ(got.textures[0].texels, sent.textures[0].texels);
  EXPECT_EQ(got.animations[0].channels[0].interpolation, Interpolation::kStep);
  EXPECT_EQ(got.animations[0].channels[0].values, sent.animations[0].channels[0].values);
  EXPECT_TRUE(got.cameras[0].is_doubtful);
  EXPECT_EQ(got.ambient, sent.ambient);
  EXPECT_EQ(got.remarks, sent.remarks);
  EXPECT_NO_THROW(check_document(got));
}

TEST(Guard, ALargeDocumentComesBackWhole) {
  constexpr std::size_t kMany = 300'000;
  const Document got = guarded_read(
      "file",
      [] {
        Document d;
        d.meshes.resize(1);
        for (std::size_t i = 0; i < kMany; ++i) d.meshes[0].mesh.positions.emplace_back(i, -double(i), 0.5);
        return d;
      },
      kLimits);
  ASSERT_EQ(got.meshes[0].mesh.positions.size(), kMany);
  for (std::size_t i = 0; i < kMany; ++i) ASSERT_EQ(got.meshes[0].mesh.positions[i], glm::dvec3(i, -double(i), 0.5));
}

TEST(Guard, WhateverBecomesOfTheChildIsASentence) {
  const auto sentence = [](const std::function<void()>& fate) {
    return refusal([&] {
      guarded_read(
          "file",
          [&] {
            fate();
            return Document();
          },
          kLimits);
    });
  };
  for (const int number : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS}) {
    expect_in(std::string("a crash (") + strsignal(number), sentence([=] { raise(number); }));
  }
  expect_in("more than 1 seconds", sentence([] {
              for (volatile bool on = true; on;) {}
            }));
#if !defined(__SANITIZE_ADDRESS__)
  expect_in("more than 256 MB of memory", sentence([] {
              std::vector<std::string> all;
              for (;;) all.emplace_back(std::size_t(1) << 20, 'x');
            }));
#endif
  expect_in("to an end with status 3", sentence([] { _exit(3); }));
  expect_in("cannot be read (words of a library)",
            sentence([] { throw std::runtime_error("words of\na library.\n"); }));
  EXPECT_EQ(sentence([] { throw Error("file: a sentence"); }), "file: a sentence");
}

TEST(Guard, NothingComesToTheScreen) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  guarded_read(
      "file",
      [] {
        std::puts("words of a library");
        std::fputs("and more", stderr);
        std::fflush(stdout);
        return Document();
      },
      kLimits);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

// Each broken in one place.
TEST(Guard, DocumentsThatDoNotHoldTogetherAreRefused) {
  const double nan = std::nan("");
  const std::vector<std::function<void(Document&)>> faults{
      [](Document& d) { d.nodes[1].parent = 1; },
      [](Document& d) { d.nodes[1].meshes = {1}; },
      [](Document& d) { d.nodes[1].skin = 7; },
      [&](Document& d) { d.nodes[0].matrix[3][0] = nan; },
      [](Document& d) { d.meshes[0].mesh.triangles[0][1] = 3; },
      [](Document& d) { d.meshes[0].mesh.normals.pop_back(); },
      [&](Document& d) { d.meshes[0].mesh.positions[1].y = nan; },
      [&](Document& d) { d.meshes[0].mesh.texture_coordinates.assign(3, glm::dvec2(0, nan)); },
      [](Document& d) { d.meshes[0].mesh.colours.resize(2); },
      [](Document& d) { d.meshes[0].targets[0].positions.pop_back(); },
      [](Document& d) { d.meshes[0].joint_weights[0].vertex = 3; },
      [](Document& d) { d.meshes[0].joint_weights[0].joint = 1; },
      [](Document& d) { d.skins[0][0].node = 2; },
      [](Document& d) { d.materials[0].texture = 1; },
      [](Document& d) { d.textures[0].width = 3; },
      [](Document& d) { d.animations[0].channels[0].values.pop_back(); },
      [](Document& d) {
        d.animations[0].channels[0].times = {2, 0};
      },
      [](Document& d) { d.animations[0].channels[0].node = -1; },
      [](Document& d) { d.cameras[0].node = 2; },
      [](Document& d) { d.lights[0].node = -2; },
  };
  for (std::size_t i = 0; i < faults.size(); ++i) {
    Document document = small_document();
    faults[i](document);
    expect_in("export the file again", refusal([&] { check_document(document); }));
    EXPECT_THROW(check_document(document), Error) << i;
  }
}

}  // namespace
}  // namespace halfspace::ref
