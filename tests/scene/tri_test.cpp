// SPDX-License-Identifier: Apache-2.0
// Lists of screen-space triangles as text: to the bit and back, and refused with file and line.
#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "ref/geometry/triangle_list.hpp"
#include "tests/scene/refusal.hpp"

namespace halfspace::ref {
namespace {

using Random = std::mt19937;

TEST(Tri, RoundTripsToTheBit) {
  Random random(1);
  std::uniform_real_distribution<double> position(-3000, 3000), unit(0, 1);
  TriangleList list{640, 480, {10, 20.5, 30}, {}};
  for (int k = 0; k < 500; ++k) {
    auto& triangle = list.triangles.emplace_back();
    for (Vertex& v : triangle) {
      v = {position(random), position(random), unit(random), 255 * unit(random), 255 * unit(random), 0};
    }
  }
  std::ostringstream text;
  write_tri(text, list);
  const TemporaryFile file("round_trip.tri", text.str());
  const TriangleList back = read_tri(file.path());
  EXPECT_EQ(back.background, list.background);
  ASSERT_EQ(back.triangles.size(), list.triangles.size());
  for (std::size_t k = 0; k < list.triangles.size(); ++k) {
    for (int i = 0; i < 3; ++i) {
      const Vertex &a = list.triangles[k][i], &b = back.triangles[k][i];
      ASSERT_TRUE(a.x == b.x && a.y == b.y && a.z == b.z && a.r == b.r && a.g == b.g && a.b == b.b);
    }
  }
}

TEST(Tri, WritesWhatThePageSays) {
  std::ostringstream text;
  write_tri(text, {2, 1, {0, 0, 0}, {{{{0, 0.5, 1, 255, 0, 1}, {-8, 0, 0, 1, 2, 3}, {4, 4, 0.25, 4, 5, 6}}}}});
  EXPECT_EQ(text.str(), "size 2 1\nt 0 0.5 1 255 0 1  -8 0 0 1 2 3  4 4 0.25 4 5 6\n");
}

TEST(Tri, TakesCommentsAndBlankLines) {
  const TemporaryFile file("comments.tri", "# a\r\n\n  size 4 3 # b\n\tt 0 0 0 1 2 3  1 0 0.5 1 2 3  0 1 1 1 2 3");
  const TriangleList list = read_tri(file.path());
  EXPECT_EQ(list.width, 4);
  EXPECT_EQ(list.height, 3);
  EXPECT_EQ(list.triangles.size(), 1u);
}

TEST(Tri, RefusesWithFileAndLine) {
  const std::string good = "t 0 0 0 1 2 3  1 0 0 1 2 3  0 1 0 1 2 3\n";
  const auto vertex = [](const std::string& text) { return "size 4 4\nt " + text + "  1 0 0 1 2 3  0 1 0 1 2 3\n"; };
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "empty"},
      {good, ":1: 't' comes before the line 'size W H'"},
      {"# nothing\n", "no line 'size W H'"},
      {"size 4 4\n", "no triangles"},
      {"size 4\n", ":1: 1 numbers where 2 are needed"},
      {"size 0 4\n", ":1: field 2: width = 0 is outside"},
      {"size 4 -4\n", "height = -4 is outside"},
      {"size 4 1000000\n", "height = 1000000 is outside"},
      {"size 4 4.5\n", "not whole"},
      {"size 4 4\nsize 4 4\n", ":2: a second line 'size'"},
      {"size 4 4\nbackground 0 0 256\n", ":2: field 4: colour = 256 is outside"},
      {"size 4 4\nt 1 2 3\n", ":2: 3 numbers where 18 are needed"},
      {"size 4 4\n" + good + "t 1 2 3", ":3: the file ends in the middle of a line (3 numbers of 18)"},
      {"size 4 4\n" + good.substr(0, good.size() - 1) + " 7\n", "19 numbers where 18 are needed"},
      {vertex("0 0 zero 1 2 3"), ":2: field 4: 'zero' is not a number"},
      {vertex("0x 0 0 1 2 3"), "'0x' is not a number"},
      {vertex("nan 0 0 1 2 3"), ":2: field 2: 'nan' is not finite"},
      {vertex("0 -inf 0 1 2 3"), "'-inf' is not finite"},
      {vertex("1e999 0 0 1 2 3"), "beyond a double"},
      {vertex("0 0 1.01 1 2 3"), "z = 1.01 is outside [0, 1]"},
      {vertex("0 0 0 1 256 3"), "g = 256 is outside [0, 255]"},
      {vertex("0 0 0 -1 2 3"), "r = -1 is outside [0, 255]"},
      {std::string("size 4 4\n\x01\xff\0 garbage\n", 20), ":2: "},
  };
  for (const auto& [text, expected] : cases) {
    const TemporaryFile file("bad.tri", text);
    const std::string sentence = refusal([&] { read_tri(file.path()); });
    expect_in(expected, sentence);
    expect_in(file.path(), sentence);
  }
  expect_in("cannot be opened", refusal([] { read_tri("/nowhere/x.tri"); }));
  expect_in("is a folder", refusal([] { read_tri("/"); }));
}

}  // namespace
}  // namespace halfspace::ref
