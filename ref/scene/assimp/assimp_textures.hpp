// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_SCENE_ASSIMP_ASSIMP_TEXTURES_HPP_
#define HALFSPACE_REF_SCENE_ASSIMP_ASSIMP_TEXTURES_HPP_

#include <assimp/scene.h>

#include <map>
#include <string>

#include "ref/scene/document.hpp"

namespace halfspace::ref {

// The pictures that materials name, from files beside the scene's or from inside it, each read once. Error with the
// path on one that is not there or cannot be read.
class AssimpTextures {
 public:
  AssimpTextures(const aiScene& file, Document* document) : file_(file), document_(*document) {}

  int in_document(const std::string& name);
  MeanColour mean(const std::string& name);

 private:
  Texture read(const std::string& name) const;

  const aiScene& file_;
  Document& document_;
  std::map<std::string, int> numbers_;
  std::map<std::string, MeanColour> means_;
};

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_SCENE_ASSIMP_ASSIMP_TEXTURES_HPP_
