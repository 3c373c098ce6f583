// SPDX-License-Identifier: Apache-2.0
#include "vectors/frames/features/feature_extremes.hpp"

#include "vectors/frames/features/light_builder.hpp"

namespace halfspace::model {
namespace {

bool has_perspective_texture(const Config& c) { return has_texture(c) && has_perspective(c); }

// Full scale everywhere, so that a texel shows as it is.
LightingFrame white_light(std::size_t triangles, const Config& config) {
  const LightBuilder light(config);
  LightingFrame out;
  out.lights = light.axes();
  out.materials = {light.white()};
  for (std::size_t k = 0; k < triangles; ++k) add_normals(out, 0, {0, 0, 1}, {0, 0, 1}, {0, 0, 1});
  return out;
}

// Triangles without a texture; but the memory and the table have something in them.
TextureFrame no_texture(std::size_t triangles, const Config& config) {
  TextureFrame out;
  const int least = is_bilinear(config) ? 1 : 0;
  out.textures = {{0, least, least}};
  for (int n = 0; n < 1 << (2 * least); ++n) out.texels.push_back({n, {0, 0, 0}});
  out.triangles.resize(triangles);
  for (RawCoordinates& words : out.triangles) {
    if (has_perspective(config)) words.q.fill(1);
  }
  return out;
}

}  // namespace

const std::vector<FeatureExtremeClass>& feature_extreme_classes() {
  static const std::vector<FeatureExtremeClass> classes = {
      {"lengths of normals", has_lighting, normal_extremes},
      {"grazing and full light", has_lighting, light_extremes},
      {"tables of materials", has_lighting, material_extremes},
      {"opposite normals", has_lighting, opposite_normal_extremes},
      {"planes of normals", is_phong, normal_plane_extremes},
      {"texel borders and seams", has_texture, texel_border_extremes},
      {"horizon", has_perspective_texture, horizon_extremes},
      {"repetitions", has_texture, repetition_extremes},
      {"sizes of textures", has_texture, texture_size_extremes},
      {"planes of coordinates", has_texture, coordinate_plane_extremes},
      {"ends of vectors", has_motion, vector_extremes},
      {"extents, keys, q", has_motion, place_extremes},
      {"planes of places", has_motion, place_plane_extremes},
      {"objects", has_objects, object_extremes},
  };
  return classes;
}

std::vector<NamedFrame> frames_of(const FeatureExtremeClass& one, const ref::RasterFormat& format,
                                  const Config& config) {
  std::vector<NamedFrame> frames;
  if (one.is_there(config)) frames = one.frames(format, config);
  for (NamedFrame& frame : frames) {
    const std::size_t triangles = frame.scene.triangles.size();
    if (has_lighting(config) && frame.lighting.triangles.empty()) frame.lighting = white_light(triangles, config);
    if (has_texture(config) && frame.texture.triangles.empty()) frame.texture = no_texture(triangles, config);
  }
  return frames;
}

std::vector<NamedFrame> feature_extremes(const ref::RasterFormat& format, const Config& config) {
  std::vector<NamedFrame> frames;
  for (const FeatureExtremeClass& one : feature_extreme_classes()) {
    for (NamedFrame& frame : frames_of(one, format, config)) frames.push_back(std::move(frame));
  }
  return frames;
}

}  // namespace halfspace::model
