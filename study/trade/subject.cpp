// SPDX-License-Identifier: Apache-2.0
#include "study/trade/subject.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "model/pipeline/engine.hpp"
#include "model/shade/frame_lighting.hpp"
#include "ref/error.hpp"
#include "ref/geometry/distant_lighting.hpp"
#include "ref/geometry/geometry.hpp"
#include "ref/raster/architecture.hpp"

namespace halfspace::model {

ref::TextureMode texture_mode(const Config& config) {
  return {is_bilinear(config) ? ref::TextureFilter::kBilinear : ref::TextureFilter::kNearest,
          has_perspective(config) ? ref::TextureMapping::kPerspective : ref::TextureMapping::kAffine};
}

ref::IdealLook look_of(const Config& config, const ref::IdealLook& finest) {
  ref::IdealLook look = finest;
  if (is_phong(config)) look.shading = ref::ShadingMode::kPhong;
  look.distant = has_lighting(config);
  if (has_texture(config) && (!look.texture || is_bilinear(config))) look.texture = texture_mode(config).filter;
  return look;
}

std::shared_ptr<const ref::Scene> Subject::fitted(const Config& config) const {
  const std::lock_guard<std::mutex> lock(fitted_->mutex);
  auto& scene = fitted_->scenes[{config.texels, config.textures}];
  if (!scene) {
    auto copy = std::make_shared<ref::Scene>(*textured_);
    fit_textures(*copy, config);
    scene = std::move(copy);
  }
  return scene;
}

const ref::Scene& Subject::needed(const Config& config) const {
  if (scene_ && (textured_ || !has_texture(config))) return *scene_;
  throw ref::Error(scene_ ? fmt::format("{}: it was read without its textures", scene_->name)
                          : "triangles of a *.tri have colours alone, and are neither lit nor textured: take a mesh "
                            "file, or a configuration without lights and texture");
}

ref::TriangleList Subject::triangles(const ref::View& view) const {
  if (scene_) return ref::project(*scene_, view);
  ref::TriangleList moved = *list_;
  for (auto& triangle : moved.triangles) {
    for (ref::Vertex& vertex : triangle) vertex.x += view.shift_x, vertex.y += view.shift_y;
  }
  return moved;
}

Subject::Drawn Subject::drawn(const Config& config, int width, int height, double shift_x, double shift_y) const {
  const ref::RasterFormat format = raster_format(Configuration(config.name, config));
  ref::View view = ref::frame_view(format, width, height);
  view.shift_x = shift_x, view.shift_y = shift_y;
  const auto named = [&](ref::TriangleList list) {
    ref::SnappedList snapped = ref::snap(list, format, raster_formats());
    return Drawn{std::move(list), {"", std::move(snapped)}};
  };
  if (!has_lighting(config) && !has_texture(config)) return named(triangles(view));
  needed(config);
  const std::shared_ptr<const ref::Scene> scene = has_texture(config) ? fitted(config) : scene_;
  ref::Geometry geometry(*scene, view);
  Drawn drawn = named(has_lighting(config) ? geometry.positions() : ref::lit_triangles(geometry));
  if (has_lighting(config)) drawn.frame.lighting = frame_lighting(geometry, config);
  if (has_texture(config)) drawn.frame.texture = texture_frame(geometry, config);
  return drawn;
}

ref::Frame Subject::reference(const Config& config, const Drawn& drawn) const {
  const ref::SnappedList& list = drawn.frame.scene;
  if (!has_lighting(config) && !has_texture(config)) return ref::render(list);
  const std::shared_ptr<const ref::Scene> scene = has_texture(config) ? fitted(config) : scene_;
  ref::Geometry geometry(*scene, ref::frame_view(list.format, list.width, list.height));
  ref::SnappedList lit = list;
  if (has_lighting(config) && !is_phong(config)) lit = ref::distantly_lit(list, geometry, most_squarings(config));
  ref::Frame frame = ref::render(lit);  // coverage, depth, and the colours where these are planes
  if (!is_phong(config) && !has_texture(config)) return frame;
  auto surface = is_phong(config) ? ref::lit_surface(geometry, lit, ref::ShadingMode::kPhong, most_squarings(config))
                                  : ref::given_surface(lit);
  if (has_texture(config)) surface = ref::textured_surface(std::move(surface), geometry, lit, texture_mode(config));
  frame.colour = ref::draw(lit, *surface, ref::Architecture::kDelta).colour;
  frame.exact_colour.clear();
  return frame;
}

ref::IdealFrame Subject::ideal(const ref::IdealLook& look, int width, int height, double shift_x,
                               double shift_y) const {
  const ref::View view = ref::ideal_view(width, height, shift_x, shift_y);
  const bool plain = look.shading == ref::ShadingMode::kGouraud && !look.distant && !look.texture;
  if (plain || !scene_) return ref::ideal(triangles(view));
  return ref::ideal(look.texture && textured_ ? *textured_ : *scene_, view, look);
}

}  // namespace halfspace::model
