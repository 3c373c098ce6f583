// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_SCENE_GLTF_CORNERS_HPP_
#define HALFSPACE_REF_SCENE_GLTF_CORNERS_HPP_

#include <array>
#include <cstdint>
#include <vector>

#include "ref/scene/gltf/file/accessor.hpp"

namespace halfspace::ref::gltf {

// The triangles of a primitive, by vertices that it uses.
struct Corners {
  std::vector<std::array<std::uint32_t, 3>> triangles;  // of numbers in `vertices`
  std::vector<std::uint32_t> vertices;                  // of the file, rising
};

// Of a primitive of triangles, a strip or a fan, whose accessors have `count` vertices. Primitives may share accessors:
// each has no more vertices than it uses.
Corners corners_of(const File&, const tinygltf::Primitive&, std::size_t count);

}  // namespace halfspace::ref::gltf

#endif  // HALFSPACE_REF_SCENE_GLTF_CORNERS_HPP_
