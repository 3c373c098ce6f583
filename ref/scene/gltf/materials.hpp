// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_SCENE_GLTF_MATERIALS_HPP_
#define HALFSPACE_REF_SCENE_GLTF_MATERIALS_HPP_

#include <glm/glm.hpp>
#include <map>

#include "ref/scene/gltf/pictures.hpp"

namespace halfspace::ref::gltf {

// A material as meshes are drawn with it.
struct Surface {
  int material = 0;        // in the document
  bool is_drawn = true;    // false: all of it is transparent
  bool has_alpha = false;  // that counts
  int coordinates = -1;    // TEXCOORD_n of its picture; −1: it has no picture
  // (u, v) = placed · (u, v, 1) of the file.
  glm::dmat3 placed{1};
  bool repeats = true;  // its sampler, in both directions
};

// The materials of a file, read as meshes ask for them. What Phong's model has no word for follows what Assimp's
// importer made of it: the base colour is diffuse, nothing is specular.
class Materials {
 public:
  explicit Materials(File* file) : file_(*file), pictures_(file) {}

  // −1: of a mesh that has none.
  const Surface& of(int material);

 private:
  Surface read(const tinygltf::Material&);
  void take_picture(const tinygltf::TextureInfo&, Material*, Surface*);
  glm::dvec3 emission(const tinygltf::Material&, Material*, Surface*);
  void read_alpha(const tinygltf::Material&, double alpha, bool has_picture, Surface*);

  File& file_;
  Pictures pictures_;
  std::map<int, Surface> surfaces_;
};

}  // namespace halfspace::ref::gltf

#endif  // HALFSPACE_REF_SCENE_GLTF_MATERIALS_HPP_
