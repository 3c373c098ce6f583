// SPDX-License-Identifier: Apache-2.0
// Static objects buffers: which objects move and which stand still, and what the S-buffers show or have to be drawn
// again for. The same whoever draws.
#ifndef HALFSPACE_REF_OBJECTS_OBJECT_STATES_HPP_
#define HALFSPACE_REF_OBJECTS_OBJECT_STATES_HPP_

#include <cstdint>
#include <vector>

#include "ref/geometry/viewpoint.hpp"
#include "ref/objects/object_buffer.hpp"
#include "ref/scene/scene.hpp"

namespace halfspace::ref {

// Static or dynamic in the previous frame, and in this one. Dynamic is what has another matrix than a frame before.
enum class ObjectState : std::uint8_t { kSS, kSD, kDS, kDD };
constexpr ObjectState object_state(bool dynamic_before, bool dynamic_now) {
  return dynamic_before ? (dynamic_now ? ObjectState::kDD : ObjectState::kDS)
                        : (dynamic_now ? ObjectState::kSD : ObjectState::kSS);
}

class ObjectStates {
 public:
  // The scene as it stands in the frame before the first; it outlives this. In that frame all objects are dynamic.
  // `aspect` is width / height. Instance n is in S-buffer n mod `buffers` while it stands still, and object n + 1.
  // Error for less than one S-buffer, and for more objects than there are numbers of `object_bits`.
  ObjectStates(const Scene&, double aspect, int buffers, int object_bits);

  // The scene as it stands now, from where it is looked at now. Error where objects have come or gone.
  void step();
  // Other lights, materials or meshes: the next frame begins as after a movement of the viewpoint.
  void start_anew() { anew_ = true; }

  // All is dynamic, and the S-buffers are empty.
  bool new_view() const { return new_view_; }
  const Viewpoint& viewpoint() const { return viewpoint_; }
  std::uint32_t objects() const { return std::uint32_t(objects_.size()); }
  ObjectState state(std::uint32_t n) const { return objects_[n].state; }
  int buffers() const { return buffers_; }
  int buffer_of(std::uint32_t n) const { return int(n % std::uint32_t(buffers_)); }
  // It is one of those that its S-buffer shows, or would show if they were not hidden.
  bool is_static(std::uint32_t n) const { return objects_[n].is_static; }
  // It starts to move, and is still one of its S-buffer's.
  bool has_to_leave(std::uint32_t n) const { return is_static(n) && state(n) == ObjectState::kSD; }
  // Holds what a static object covers.
  const Box& box(std::uint32_t n) const { return objects_[n].box; }

  void leave(std::uint32_t n) { objects_[n].is_static = false; }
  void stay(std::uint32_t n, const Box& covered) { objects_[n].is_static = true, objects_[n].box = covered; }

  // each(n, region) for the objects of S-buffer k whose box meets a hole, once each and in order.
  template <class Each>
  void over(int k, const std::vector<Box>& holes, Each&& each) const {
    if (holes.empty()) return;
    for (std::uint32_t n = std::uint32_t(k); n < objects(); n += std::uint32_t(buffers_)) {
      if (!is_static(n)) continue;
      Box region;
      for (const Box& hole : holes) {
        if (hole.meets(box(n))) region.add(hole.cut(box(n)));
      }
      if (!region.empty()) each(n, region);
    }
  }

 private:
  struct Object {
    glm::dmat4 to_world;
    Box box;
    ObjectState state = ObjectState::kDD;
    bool is_static = false;
  };
  const Scene& scene_;
  const double aspect_;
  const int buffers_;
  Viewpoint viewpoint_;
  std::vector<Object> objects_;
  bool anew_ = false, new_view_ = false;
};

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_OBJECTS_OBJECT_STATES_HPP_
