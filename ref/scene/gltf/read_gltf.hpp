// SPDX-License-Identifier: Apache-2.0
// glTF 2.0, text and binary, to the letter of the specification: parsed by tinygltf, of which accessors, pictures and
// ranges are no part.
#ifndef HALFSPACE_REF_SCENE_GLTF_READ_GLTF_HPP_
#define HALFSPACE_REF_SCENE_GLTF_READ_GLTF_HPP_

#include <string>

#include "ref/error.hpp"
#include "ref/scene/document.hpp"

namespace halfspace::ref {

// A file of glTF 1, which is another format.
struct FirstGltf : Error {
  using Error::Error;
};

// Error on what is no glTF 2.0, on what the specification forbids and would change the picture, and on extensions that
// are required and not drawn. Nothing is allocated by a number that the size of the file does not bear out.
Document read_gltf(const std::string& path, const ReadChoice&);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_SCENE_GLTF_READ_GLTF_HPP_
