// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_SCENE_GLTF_MESHES_HPP_
#define HALFSPACE_REF_SCENE_GLTF_MESHES_HPP_

#include <map>
#include <vector>

#include "ref/scene/gltf/file/accessor.hpp"
#include "ref/scene/gltf/materials.hpp"

namespace halfspace::ref::gltf {

// A mesh of the file: one of the document for each of its primitives that is drawn.
struct MeshParts {
  std::vector<int> numbers;
  std::size_t targets = 0;
  int joints = 0;  // that a skin needs to have
};

// The meshes of a file, read as nodes ask for them.
class Meshes {
 public:
  explicit Meshes(File* file) : file_(*file), materials_(file) {}

  const MeshParts& of(int mesh);
  // What is said of all of them together.
  void say_what_is_left_out();

 private:
  void add(const tinygltf::Mesh&, const tinygltf::Primitive&, MeshParts*);

  File& file_;
  Materials materials_;
  std::map<int, MeshParts> parts_;
  std::size_t points_ = 0, lines_ = 0, without_positions_ = 0, without_coordinates_ = 0, vertices_ = 0;
};

}  // namespace halfspace::ref::gltf

#endif  // HALFSPACE_REF_SCENE_GLTF_MESHES_HPP_
