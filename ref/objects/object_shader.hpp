// SPDX-License-Identifier: Apache-2.0
// The colour of a pixel of which the object and its triangle are known: geometry, lighting and the colour planes of
// that one triangle, so that what is not seen costs nothing. Colours are those of render(snap(project(scene))), to
// the bit.
#ifndef HALFSPACE_REF_OBJECTS_OBJECT_SHADER_HPP_
#define HALFSPACE_REF_OBJECTS_OBJECT_SHADER_HPP_

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "ref/geometry/plane.hpp"
#include "ref/geometry/projection.hpp"
#include "ref/objects/object_buffer.hpp"
#include "ref/scene/scene.hpp"

namespace halfspace::ref {

class ObjectShader {
 public:
  // The scene outlives it; its instances may move.
  ObjectShader(const Scene&, const RasterFormat&, const View&);

  void look_from(const Viewpoint&);
  // A pixel that shows an object or the background, and has no colour yet, gets it; that of the background too where
  // the triangle, as its object stands now, is not drawn: then somebody has left in a buffer what has moved.
  void shade(ObjectPixel& pixel, int x, int y);
  // To be called when instances have moved.
  void forget() { object_ = 0; }

 private:
  void prepare(std::uint32_t object, std::uint32_t triangle);

  const Scene& scene_;
  const RasterFormat format_;
  const View view_;
  std::vector<ClipPlane> guard_planes_;
  Viewpoint viewpoint_;
  std::vector<Light> lights_;
  std::array<std::uint8_t, 4> background_;
  std::uint32_t object_ = 0, triangle_ = 0;  // that is ready; object 0: none
  std::optional<OrderedTriangle> ordered_;
  std::array<std::array<std::int64_t, 3>, 3> channel_;  // of the vertices
};

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_OBJECTS_OBJECT_SHADER_HPP_
