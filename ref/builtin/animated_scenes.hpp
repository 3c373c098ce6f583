// SPDX-License-Identifier: Apache-2.0
// Built-in scenes that move. Instances, and the camera of some, are functions of time; meshes and the order of
// instances are not, so that a face has one number at all times. Speeds are in docs/frames.md.
#ifndef HALFSPACE_REF_BUILTIN_ANIMATED_SCENES_HPP_
#define HALFSPACE_REF_BUILTIN_ANIMATED_SCENES_HPP_

#include <optional>
#include <string>

#include "ref/scene/scene.hpp"

namespace halfspace::ref {

// Held at its ends outside its duration, as animations of files are. If `textured`, with bricks on all of it.
std::optional<Scene> animated_scene(const std::string& name, double time_seconds, bool textured = false);

// Four shrouded rotors around a ball, added to a scene: 17 instances, the rotors turned on by so many seconds.
void add_drone(Scene&, const glm::dmat4& flight, double seconds);
Scene drone(double seconds);
Scene jet(double seconds);    // wings that sweep back, fins, nozzles, missiles
Scene court(double seconds);  // a drone at a castle, which stands still

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_BUILTIN_ANIMATED_SCENES_HPP_
