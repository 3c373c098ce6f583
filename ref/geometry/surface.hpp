// SPDX-License-Identifier: Apache-2.0
// What triangles look like: asked for triangle by triangle and pixel by pixel, so that it can be asked late, and
// counted.
#ifndef HALFSPACE_REF_GEOMETRY_SURFACE_HPP_
#define HALFSPACE_REF_GEOMETRY_SURFACE_HPP_

#include <array>
#include <cstdint>
#include <memory>

#include "ref/geometry/geometry.hpp"
#include "ref/geometry/plane.hpp"
#include "ref/geometry/snap.hpp"

namespace halfspace::ref {

enum class ShadingMode { kFlat, kGouraud, kPhong };
constexpr ShadingMode kShadingModes[] = {ShadingMode::kFlat, ShadingMode::kGouraud, ShadingMode::kPhong};
const char* name_of(ShadingMode);  // "flat", …

// The normal by planes at the centre of a pixel, of those of the vertices in the order given.
glm::dvec3 normal_at(const OrderedTriangle& triangle, const std::array<glm::dvec3, 3>& normals, int subpixel_bits,
                     int x, int y);

class Surface {
 public:
  virtual ~Surface() = default;
  // Makes ready to shade triangle `k`, from 1 on; asked once, before its colours. Returns the lightings that it took.
  virtual int light(std::uint32_t k) = 0;
  // The colour at the centre of a pixel of triangle `k`. Adds the lightings and the texels that it took.
  virtual std::array<std::uint8_t, 4> colour(std::uint32_t k, int x, int y, std::uint64_t& lightings,
                                             std::uint64_t& texels) = 0;
};

// Colours that came with the triangles, over exact planes; flat by the format. Lights nothing, and counts what lighting
// would have taken: one, or three.
std::unique_ptr<Surface> given_surface(const SnappedList&);

// The triangles of a geometry, lit when they are asked for. `list` are its positions, snapped. Both outlive it.
//   flat: one lighting a triangle, of vertex 0; Gouraud: three, and exact planes over their rounded colours;
//   Phong: one a pixel, of the normal by planes over the snapped triangle, with lights and viewer at infinity, and
//   highlights of exponents up to 2^most_squarings, or of none if that is −1.
std::unique_ptr<Surface> lit_surface(Geometry&, const SnappedList& list, ShadingMode, int most_squarings = 4);

// How texture coordinates vary over a triangle on the screen.
enum class TextureMapping {
  kAffine,       // by planes of u and v, as index rendering has them
  kPerspective,  // by planes of u/w, v/w and 1/w, and a division a pixel
};
struct TextureMode {
  TextureFilter filter = TextureFilter::kBilinear;
  TextureMapping mapping = TextureMapping::kPerspective;
};
// What `lit` shows, times the texture where a triangle has one. The scene of the geometry was loaded with its textures.
std::unique_ptr<Surface> textured_surface(std::unique_ptr<Surface> lit, const Geometry&, const SnappedList& list,
                                          const TextureMode&);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_GEOMETRY_SURFACE_HPP_
