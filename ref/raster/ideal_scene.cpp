// SPDX-License-Identifier: Apache-2.0
#include "ref/raster/ideal_scene.hpp"

#include "ref/geometry/distant_lighting.hpp"
#include "ref/geometry/geometry.hpp"

namespace halfspace::ref {
namespace {

constexpr int kMostSquarings = 4;

glm::dvec3 mixed(const std::array<double, 3>& weights, const std::array<glm::dvec3, 3>& of) {
  return weights[0] * of[0] + weights[1] * of[1] + weights[2] * of[2];
}

// Triangles come in runs: what is the same all over one is looked up once.
class Shade {
 public:
  Shade(Geometry& geometry, const IdealLook& look) : geometry_(geometry), look_(look) {
    if (look.distant || look.shading == ShadingMode::kPhong)
      distant_ = distant_scene(geometry.scene(), geometry.viewpoint(), kMostSquarings);
  }

  std::array<double, 3> operator()(std::uint32_t k, const std::array<double, 3>& weights) {
    if (k != k_) set(k);
    glm::dvec3 colour =
        look_.shading == ShadingMode::kPhong ? distant_colour(mixed(weights, normals_)) : mixed(weights, colours_);
    if (texture_ >= 0) colour *= texel(weights) / 255.0;
    return {colour.r, colour.g, colour.b};
  }

 private:
  glm::dvec3 distant_colour(const glm::dvec3& normal) const {
    return ref::distant_colour(distant_.materials[material_], distant_.lights, normal);
  }

  glm::dvec3 texel(std::array<double, 3> weights) const {
    const std::array<double, 3>& w = geometry_.origins()[k_ - 1].w;
    double total = 0;
    for (int v = 0; v < 3; ++v) total += weights[v] /= w[v];
    const glm::dvec2 uv = (weights[0] * uv_[0] + weights[1] * uv_[1] + weights[2] * uv_[2]) / total;
    std::uint64_t texels = 0;
    return sample(geometry_.scene().textures[texture_], uv, *look_.texture, texels);
  }

  void set(std::uint32_t k) {
    k_ = k;
    if (!distant_.materials.empty()) {
      material_ = distant_.triangles[distant_.of_face[geometry_.positions().face[k - 1] - 1]].material;
      normals_ = geometry_.normals(k - 1);
      for (int v = 0; v < 3; ++v) colours_[v] = distant_colour(normals_[v]);
    } else {
      colours_ = geometry_.colours(k - 1);
    }
    if (look_.shading == ShadingMode::kFlat) colours_.fill(colours_[0]);
    texture_ = look_.texture ? geometry_.texture(k - 1) : -1;
    if (texture_ >= 0) uv_ = geometry_.uv(k - 1);
  }

  Geometry& geometry_;
  const IdealLook look_;
  DistantScene distant_;
  std::uint32_t k_ = 0;
  int material_ = 0, texture_ = -1;
  std::array<glm::dvec3, 3> colours_, normals_;
  std::array<glm::dvec2, 3> uv_;
};

}  // namespace

std::string name_of(const IdealLook& look) {
  std::string name = name_of(look.shading);
  if (look.distant || look.shading == ShadingMode::kPhong) name += ", lights at infinity";
  if (look.texture) name += *look.texture == TextureFilter::kNearest ? ", nearest texel" : ", bilinear";
  return name;
}

IdealFrame ideal(const Scene& scene, const View& view, const IdealLook& look) {
  Geometry geometry(scene, view);
  Shade shade(geometry, look);
  return ideal(geometry.positions(), [&](std::uint32_t k, const std::array<double, 3>& w) { return shade(k, w); });
}

}  // namespace halfspace::ref
