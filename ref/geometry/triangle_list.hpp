// SPDX-License-Identifier: Apache-2.0
// What the geometry stage hands to the rasterizer, before positions are snapped, and its text form *.tri:
//
//   # a comment
//   size 640 480
//   background 24 28 38                                  optional, 0-255; black without it
//   t x y z r g b  x y z r g b  x y z r g b              one a triangle
//
// Triangles are numbered from 1 in the order of the file.
#ifndef HALFSPACE_REF_GEOMETRY_TRIANGLE_LIST_HPP_
#define HALFSPACE_REF_GEOMETRY_TRIANGLE_LIST_HPP_

#include <array>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

namespace halfspace::ref {

struct Vertex {
  double x, y, z;  // pixels, row 0 on top, the centre of pixel i at i + 0.5; depth [0, 1]
  double r, g, b;  // 0-255
};

struct TriangleList {
  int width, height;  // pixels
  std::array<double, 3> background{0, 0, 0};
  std::vector<std::array<Vertex, 3>> triangles;
  // Of which face of the scene each is a part, from 1 on; empty when nothing was clipped or culled: triangle k is face
  // k.
  std::vector<std::uint32_t> face{};
};

// Sides of a frame beyond this are taken for a mistake in the file.
constexpr int kLargestSide = 65536;

bool is_tri_file(const std::string& path);

// Error with file and line on everything malformed, and on a list without triangles unless `may_be_empty`.
TriangleList read_tri(const std::string& path, bool may_be_empty = false);

// Every number in the shortest form that reads back as the same double.
void write_tri(std::ostream&, const TriangleList&);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_GEOMETRY_TRIANGLE_LIST_HPP_
