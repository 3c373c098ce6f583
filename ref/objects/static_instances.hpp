// SPDX-License-Identifier: Apache-2.0
// What stands still between two times of a scene, and so looks the same in both.
#ifndef HALFSPACE_REF_OBJECTS_STATIC_INSTANCES_HPP_
#define HALFSPACE_REF_OBJECTS_STATIC_INSTANCES_HPP_

#include <cstdint>
#include <vector>

#include "ref/scene/scene.hpp"

namespace halfspace::ref {

// Of each instance, in a frame of this aspect: is all that its pixels follow from the same in both? That is the
// viewpoint with its depth planes, the lights and the background, and of itself the matrix, the mesh as it is posed,
// the material and the texture. None is where the numbers of instances differ.
std::vector<bool> same_instances(const Scene& a, const Scene& b, double aspect);

// Those that are the same at both keys and in between.
std::vector<bool> static_instances(const Scene& first, const Scene& second, const Scene& between, double aspect);

// The scene without these instances. It is seen from the same place, but depth planes that are not held follow what is
// left.
Scene without(const Scene&, const std::vector<bool>& left_out);

// Of each face of the scene, numbered from 1 on, the instance; of number 0 none counts.
std::vector<std::uint32_t> instances_of_faces(const Scene&);

// The depth planes that hold all of these times, so that depths of any two of them compare.
DepthPlanes held_planes(const std::vector<const Scene*>& times, double aspect);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_OBJECTS_STATIC_INSTANCES_HPP_
