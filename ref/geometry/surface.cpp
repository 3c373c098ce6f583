// SPDX-License-Identifier: Apache-2.0
#include "ref/geometry/surface.hpp"

#include <optional>

#include "ref/geometry/distant_lighting.hpp"
#include "ref/geometry/plane.hpp"

namespace halfspace::ref {
namespace {

// The planes of one triangle at a time: pixels come in runs.
class ColourPlanes {
 public:
  ColourPlanes(const RasterFormat& format, bool flat) : format_(format), flat_(flat) {}

  std::array<std::uint8_t, 4> at(std::uint32_t k, const SnappedTriangle& snapped, int x, int y) {
    if (k != k_) set(k, snapped);
    const std::int64_t px = pixel_centre(x, format_.subpixel_bits), py = pixel_centre(y, format_.subpixel_bits);
    std::array<std::uint8_t, 4> colour{0, 0, 0, 255};
    for (int c = 0; c < 3; ++c) {
      const Plane& plane = *planes_[c];
      const auto value = plane.rounded(plane.numerator(px, py));
      colour[c] = displayed_colour(static_cast<unsigned>(value), format_.colour_bits);
    }
    return colour;
  }

 private:
  void set(std::uint32_t k, const SnappedTriangle& snapped) {
    k_ = k;
    triangle_.emplace(snapped);
    for (int c = 0; c < 3; ++c) {
      std::array<std::int64_t, 3> values{snapped.rgb[0][c], snapped.rgb[1][c], snapped.rgb[2][c]};
      if (flat_) values.fill(values[0]);
      planes_[c].emplace(*triangle_, values);
    }
  }

  const RasterFormat format_;
  const bool flat_;
  std::uint32_t k_ = 0;
  std::optional<OrderedTriangle> triangle_;
  std::array<std::optional<Plane>, 3> planes_;
};

class GivenSurface : public Surface {
 public:
  explicit GivenSurface(const SnappedList& list) : list_(list), planes_(list.format, list.format.flat) {}
  int light(std::uint32_t) override { return list_.format.flat ? 1 : 3; }
  std::array<std::uint8_t, 4> colour(std::uint32_t k, int x, int y, std::uint64_t&, std::uint64_t&) override {
    return planes_.at(k, list_.triangles[k - 1], x, y);
  }

 private:
  const SnappedList& list_;
  ColourPlanes planes_;
};

class LitSurface : public Surface {
 public:
  LitSurface(Geometry& geometry, const SnappedList& list, bool flat)
      : geometry_(geometry),
        colour_bits_(list.format.colour_bits),
        flat_(flat),
        planes_(list.format, flat),
        lit_(list.triangles) {}

  int light(std::uint32_t k) override {
    std::array<glm::dvec3, 3> colours;
    if (flat_) colours.fill(geometry_.colour(k - 1));
    else colours = geometry_.colours(k - 1);
    for (int v = 0; v < 3; ++v) {
      for (int c = 0; c < 3; ++c) lit_[k - 1].rgb[v][c] = snapped_colour(colours[v][c], colour_bits_);
    }
    return flat_ ? 1 : 3;
  }
  std::array<std::uint8_t, 4> colour(std::uint32_t k, int x, int y, std::uint64_t&, std::uint64_t&) override {
    return planes_.at(k, lit_[k - 1], x, y);
  }

 private:
  Geometry& geometry_;
  const int colour_bits_;
  const bool flat_;
  ColourPlanes planes_;
  std::vector<SnappedTriangle> lit_;
};

class PhongSurface : public Surface {
 public:
  PhongSurface(Geometry& geometry, const SnappedList& list, int most_squarings)
      : geometry_(geometry),
        list_(list),
        scene_(distant_scene(geometry.scene(), geometry.viewpoint(), most_squarings)) {}

  int light(std::uint32_t) override { return 0; }
  std::array<std::uint8_t, 4> colour(std::uint32_t k, int x, int y, std::uint64_t& lightings, std::uint64_t&) override {
    if (k != k_) set(k);
    const glm::dvec3 normal = normal_at(*triangle_, normals_, list_.format.subpixel_bits, x, y);
    ++lightings;
    const glm::dvec3 lit = distant_colour(scene_.materials[material_], scene_.lights, normal);
    std::array<std::uint8_t, 4> colour{0, 0, 0, 255};
    const int bits = list_.format.colour_bits;
    for (int c = 0; c < 3; ++c) colour[c] = displayed_colour(snapped_colour(lit[c], bits), bits);
    return colour;
  }

 private:
  void set(std::uint32_t k) {
    k_ = k;
    triangle_.emplace(list_.triangles[k - 1]);
    normals_ = geometry_.normals(k - 1);
    material_ = scene_.triangles[scene_.of_face[geometry_.positions().face[k - 1] - 1]].material;
  }

  Geometry& geometry_;
  const SnappedList& list_;
  const DistantScene scene_;
  std::uint32_t k_ = 0;
  std::optional<OrderedTriangle> triangle_;
  std::array<glm::dvec3, 3> normals_;
  int material_ = 0;
};

class TexturedSurface : public Surface {
 public:
  TexturedSurface(std::unique_ptr<Surface> lit, const Geometry& geometry, const SnappedList& list,
                  const TextureMode& mode)
      : lit_(std::move(lit)), geometry_(geometry), list_(list), mode_(mode) {}

  int light(std::uint32_t k) override { return lit_->light(k); }
  std::array<std::uint8_t, 4> colour(std::uint32_t k, int x, int y, std::uint64_t& lightings,
                                     std::uint64_t& texels) override {
    std::array<std::uint8_t, 4> colour = lit_->colour(k, x, y, lightings, texels);
    if (k != k_) set(k);
    if (texture_ < 0) return colour;
    const int f = list_.format.subpixel_bits;
    std::array<double, 3> weights = vertex_weights(*triangle_, pixel_centre(x, f), pixel_centre(y, f));
    if (mode_.mapping == TextureMapping::kPerspective) {
      double total = 0;
      for (int v = 0; v < 3; ++v) total += weights[v] /= geometry_.origins()[k - 1].w[v];
      for (double& weight : weights) weight /= total;
    }
    const glm::dvec2 uv = weights[0] * coordinates_[0] + weights[1] * coordinates_[1] + weights[2] * coordinates_[2];
    const glm::dvec3 texel = sample(geometry_.scene().textures[texture_], uv, mode_.filter, texels);
    const int bits = list_.format.colour_bits;
    for (int c = 0; c < 3; ++c) colour[c] = displayed_colour(snapped_colour(colour[c] * texel[c] / 255, bits), bits);
    return colour;
  }

 private:
  void set(std::uint32_t k) {
    k_ = k;
    triangle_.emplace(list_.triangles[k - 1]);
    texture_ = geometry_.texture(k - 1);
    if (texture_ >= 0) coordinates_ = geometry_.uv(k - 1);
  }

  const std::unique_ptr<Surface> lit_;
  const Geometry& geometry_;
  const SnappedList& list_;
  const TextureMode mode_;
  std::uint32_t k_ = 0;
  std::optional<OrderedTriangle> triangle_;
  int texture_ = -1;
  std::array<glm::dvec2, 3> coordinates_;
};

}  // namespace

std::unique_ptr<Surface> textured_surface(std::unique_ptr<Surface> lit, const Geometry& geometry,
                                          const SnappedList& list, const TextureMode& mode) {
  return std::make_unique<TexturedSurface>(std::move(lit), geometry, list, mode);
}

const char* name_of(ShadingMode mode) {
  constexpr const char* kNames[] = {"flat", "gouraud", "phong"};
  return kNames[int(mode)];
}

glm::dvec3 normal_at(const OrderedTriangle& triangle, const std::array<glm::dvec3, 3>& normals, int subpixel_bits,
                     int x, int y) {
  const std::array<double, 3> weights =
      vertex_weights(triangle, pixel_centre(x, subpixel_bits), pixel_centre(y, subpixel_bits));
  return weights[0] * normals[0] + weights[1] * normals[1] + weights[2] * normals[2];
}

std::unique_ptr<Surface> given_surface(const SnappedList& list) { return std::make_unique<GivenSurface>(list); }

std::unique_ptr<Surface> lit_surface(Geometry& geometry, const SnappedList& list, ShadingMode mode,
                                     int most_squarings) {
  if (mode == ShadingMode::kPhong) return std::make_unique<PhongSurface>(geometry, list, most_squarings);
  return std::make_unique<LitSurface>(geometry, list, mode == ShadingMode::kFlat);
}

}  // namespace halfspace::ref
