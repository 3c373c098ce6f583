// SPDX-License-Identifier: Apache-2.0
// The S-buffer of frames between key frames: what stands still in them, drawn once. docs/frames.md says what it is for.
#ifndef HALFSPACE_MODEL_DRIVERS_STATIC_BUFFER_HPP_
#define HALFSPACE_MODEL_DRIVERS_STATIC_BUFFER_HPP_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "model/formats/configuration.hpp"
#include "model/pipeline/engine.hpp"
#include "ref/geometry/projection.hpp"
#include "ref/objects/object_buffer.hpp"
#include "ref/scene/scene.hpp"

namespace halfspace::model {

// Instance n is object n + 1, in the order in which the renderer draws.
class StaticBuffer {
 public:
  // `engine` draws `configuration`; both outlive this.
  StaticBuffer(Engine& engine, const Configuration& configuration) : engine_(engine), configuration_(configuration) {}

  // Shows those instances as the scene has them, and nothing else, in the one view that this is of. Returns how many
  // triangles had to be drawn: none where it shows them already. Throws ref::Error where the engine does.
  std::size_t show(const ref::Scene&, const std::vector<bool>& instances, const ref::View&);

  const ref::ObjectPixel& at(int x, int y) const { return pixels_->at(x, y); }
  // Whether a fragment of an object that is not in here is behind what is.
  bool hides(int x, int y, std::uint32_t depth, std::uint32_t object) const {
    return at(x, y).key < ref::object_key(depth, object);
  }

 private:
  bool shows(const ref::Scene&, const std::vector<bool>& instances, const ref::View&) const;

  Engine& engine_;
  const Configuration& configuration_;
  std::optional<ref::Scene> scene_;  // as it was drawn
  std::vector<bool> shown_;
  std::optional<ref::ObjectBuffer> pixels_;
};

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_DRIVERS_STATIC_BUFFER_HPP_
