// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_SCENE_GLTF_PICTURES_HPP_
#define HALFSPACE_REF_SCENE_GLTF_PICTURES_HPP_

#include <glm/glm.hpp>
#include <map>
#include <optional>

#include "ref/scene/gltf/file/file.hpp"

namespace halfspace::ref::gltf {

// The pictures of a file, each read once, if it is asked for. Row 0 is at v = 1, as of the other formats.
class Pictures {
 public:
  explicit Pictures(File* file) : file_(*file) {}

  // The picture of a texture of the file; −1: it has none that glTF 2.0 itself knows.
  int of_texture(int texture) const;
  // The number in the document. Error on what is no PNG or JPEG, or not there.
  int in_document(int picture);

  struct Mean {
    glm::dvec3 colour;  // 0-1
    bool is_uniform;
  };
  Mean mean(int picture);

 private:
  Texture read(int picture) const;

  File& file_;
  std::map<int, int> numbers_;
  std::map<int, Mean> means_;
};

}  // namespace halfspace::ref::gltf

#endif  // HALFSPACE_REF_SCENE_GLTF_PICTURES_HPP_
