// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_SCENE_READ_DOCUMENT_HPP_
#define HALFSPACE_REF_SCENE_READ_DOCUMENT_HPP_

#include <string>

#include "ref/scene/document.hpp"

namespace halfspace::ref {

// A scene file, by the reader of its format. Error with the path.
Document read_document(const std::string& path, const SceneChoice&);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_SCENE_READ_DOCUMENT_HPP_
