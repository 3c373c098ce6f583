// SPDX-License-Identifier: Apache-2.0
// The ideal picture of a scene with its lights and its textures: nothing snapped, nothing rounded between the scene and
// a pixel's colour.
#ifndef HALFSPACE_REF_RASTER_IDEAL_SCENE_HPP_
#define HALFSPACE_REF_RASTER_IDEAL_SCENE_HPP_

#include <optional>
#include <string>

#include "ref/geometry/surface.hpp"
#include "ref/raster/ideal.hpp"
#include "ref/scene/scene.hpp"

namespace halfspace::ref {

// How a scene is looked at.
struct IdealLook {
  // Flat: the colour of the first vertex as it stands in the geometry's triangle. Gouraud: colours of the vertices,
  // mixed on the screen. Phong: normals are, and each pixel is lit; always distantly.
  ShadingMode shading = ShadingMode::kGouraud;
  // Lights and viewer at infinity, and exponents of highlights to the nearest power of two up to 16, as hardware lights
  // (ref/geometry/distant_lighting.hpp). Else each vertex has the light that it has where it is.
  bool distant = false;
  // Without it textures are not looked at. Coordinates are true to perspective in either mapping: affine ones are an
  // approximation, and no look.
  std::optional<TextureFilter> texture = std::nullopt;
};

// "gouraud, lights at infinity, bilinear"
std::string name_of(const IdealLook&);

// `view` is one of ideal_view(). With textures the scene was loaded with them.
IdealFrame ideal(const Scene&, const View& view, const IdealLook&);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_RASTER_IDEAL_SCENE_HPP_
