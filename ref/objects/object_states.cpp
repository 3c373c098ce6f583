// SPDX-License-Identifier: Apache-2.0
#include "ref/objects/object_states.hpp"

#include <fmt/format.h>

#include "ref/error.hpp"

namespace halfspace::ref {

ObjectStates::ObjectStates(const Scene& scene, double aspect, int buffers, int object_bits)
    : scene_(scene), aspect_(aspect), buffers_(buffers), viewpoint_(ref::viewpoint(scene, aspect)) {
  if (buffers < 1) throw Error(fmt::format("{} S-buffers hold no object: take one at least", buffers));
  if (scene.instances.size() >= std::uint64_t(1) << object_bits) {
    throw Error(fmt::format("{}: {} objects, and {} bits number {}: take more bits", scene.name, scene.instances.size(),
                            object_bits, (std::uint64_t(1) << object_bits) - 1));
  }
  for (const Instance& instance : scene.instances) objects_.push_back({instance.to_world, {}});
}

void ObjectStates::step() {
  if (scene_.instances.size() != objects_.size()) {
    throw Error(fmt::format("{}: {} objects in a frame and {} in the first: begin anew where objects come or go",
                            scene_.name, scene_.instances.size(), objects_.size()));
  }
  const Viewpoint from = ref::viewpoint(scene_, aspect_);
  new_view_ = anew_ || from != viewpoint_;
  viewpoint_ = from;
  anew_ = false;
  for (std::uint32_t n = 0; n < objects(); ++n) {
    Object& object = objects_[n];
    if (new_view_) object.is_static = false;
    const bool before = object.state == ObjectState::kDD || object.state == ObjectState::kSD;
    object.state = object_state(before, new_view_ || object.to_world != scene_.instances[n].to_world);
    object.to_world = scene_.instances[n].to_world;
  }
}

}  // namespace halfspace::ref
