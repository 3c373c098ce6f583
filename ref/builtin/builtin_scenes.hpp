// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_BUILTIN_BUILTIN_SCENES_HPP_
#define HALFSPACE_REF_BUILTIN_BUILTIN_SCENES_HPP_

#include <optional>
#include <string>

#include "ref/scene/scene.hpp"

namespace halfspace::ref {

std::optional<Scene> builtin_scene(const std::string& name);

// Each with its parts in world coordinates, y up.
Scene teapot();      // the 32 patches of Utah, 3,136 triangles of which 56 have no area
Scene cube();        // a colour a face
Scene pyramid();     // square base, a colour a face
Scene wheel();       // rim, hub and spokes
Scene ring();        // a torus
Scene polyhedron();  // two triangles through each other, seen from both sides
Scene two_tone();    // a body of 24 triangles in two colours, seen from both sides
Scene castle();      // walls and towers that cover each other

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_BUILTIN_BUILTIN_SCENES_HPP_
