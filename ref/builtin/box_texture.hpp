// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_BUILTIN_BOX_TEXTURE_HPP_
#define HALFSPACE_REF_BUILTIN_BOX_TEXTURE_HPP_

#include "ref/scene/scene.hpp"

namespace halfspace::ref {

// Bricks in grey, 64 × 64 texels, on all materials: each face is seen along the axis of its mesh that it faces most,
// where the texture repeats every two units. Vertices that faces of different axes share are doubled; faces stay, and
// their order.
void add_box_texture(Scene&);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_BUILTIN_BOX_TEXTURE_HPP_
