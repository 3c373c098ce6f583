// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_SCENE_SCENE_AT_HPP_
#define HALFSPACE_REF_SCENE_SCENE_AT_HPP_

#include <vector>

#include "ref/scene/document.hpp"

namespace halfspace::ref {

// Null where the document has none. Error on a name or a number that it does not have.
const Animation* chosen_animation(const Document&, const SceneChoice&);

// What is to be in view without a camera, at all times of the animation.
std::vector<glm::dvec3> framing_of(const Document&, const SceneChoice&);

// The scene of a document at a time. `framing`: as framing_of() says. Error likewise, of a camera too.
Scene scene_at(const Document&, const SceneChoice&, double seconds, std::vector<glm::dvec3> framing);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_SCENE_SCENE_AT_HPP_
