// SPDX-License-Identifier: Apache-2.0
#include "study/fit/fit_steps.hpp"

#include <algorithm>
#include <cmath>

#include "ref/geometry/distant_lighting.hpp"
#include "ref/geometry/geometry.hpp"

namespace halfspace::model {
namespace {

constexpr int kMostTexels = 1 << 20;
constexpr int kMostSquarings = 4;  // log2 of the largest gloss
constexpr int kLeastReserve = 6;   // bits that a reciprocal has more than what it divides

// In the order in which they are tried.
constexpr const char* kNumbers[] = {"texels",          "depth_bits",          "colour_bits",     "coordinate_bits",
                                    "normal_bits",     "subpixel_bits",       "gloss",           "colour_fraction",
                                    "depth_fraction",  "coordinate_fraction", "normal_fraction", "vector_range",
                                    "vector_fraction", "weight_bits",         "reciprocal_bits"};

// The least number of bits that a frame of this size lies in, with the stamps around it.
int range_bits_for(int width, int height) {
  int bits = 1;
  while (1 << (bits - 1) < std::max(width, height) + 12) ++bits;
  return bits;
}

// r and g that make the rounding of planes small beside the rest: an error of 1/32 LSB before rounding at most.
void give_generous_planes(Config& c) {
  const std::int64_t reach = (std::int64_t(1) << c.range_bits) + c.width + c.height;
  const int g = bits_for(reach) + 5;
  c.depth_fraction = has_depth(c) ? g : 0;
  c.colour_fraction = has_colour_planes(c) ? g : 0;
  c.normal_fraction = is_phong(c) ? g : 0;
  c.coordinate_fraction = has_coordinates(c) ? g : 0;
  const int value = std::max({c.depth_bits, colour_plane_bits(c), normal_plane_bits(c), c.coordinate_bits});
  c.reciprocal_bits = has_planes(c) ? std::max(c.subpixel_bits + g, value + kLeastReserve) : 0;
}

std::optional<Config> without_depth(const Config& c) {
  if (!has_depth(c)) return std::nullopt;
  Config less = c;
  less.depth_bits = 0;
  give_generous_planes(less);
  return less;
}

// Phong shading, then Gouraud: flat is what is left.
std::optional<Config> simpler_shading(const Config& c) {
  if (!is_phong(c) && !is_gouraud(c)) return std::nullopt;
  Config less = c;
  less.shading = is_phong(c) ? Shading::kGouraud : Shading::kFlat;
  give_generous_planes(less);
  return less;
}

// Its planes as well where no texture is looked at any more.
std::optional<Config> simpler_texture(const Config& c) {
  if (!has_texture(c)) return std::nullopt;
  Config less = c;
  less.texture = is_bilinear(c) ? TextureFilter::kNearest : TextureFilter::kNone;
  if (!has_texture(less)) {
    less.mapping = TextureMapping::kAffine;
    less.texels = less.textures = less.coordinate_bits = 0;
  }
  give_generous_planes(less);
  return less;
}

std::optional<Config> affine(const Config& c) {
  if (!has_coordinates(c) || !has_perspective(c)) return std::nullopt;
  Config less = c;
  less.mapping = TextureMapping::kAffine;
  give_generous_planes(less);
  return less;
}

// Of key frames, in the order of what they read.
std::optional<Config> simpler_filter(const Config& c) {
  if (!has_motion(c) || c.filter == KeyFilter::kNearest) return std::nullopt;
  Config less = c;
  less.filter = c.filter == KeyFilter::kBilinear ? KeyFilter::kNearest : KeyFilter::kBilinear;
  return less;
}

std::optional<Config> without_relight(const Config& c) {
  if (!relights(c)) return std::nullopt;
  Config less = c;
  less.relight = 0;
  give_generous_planes(less);
  return less;
}

}  // namespace

std::vector<const ConfigField*> fit_numbers(const Config& c) {
  std::vector<const ConfigField*> found;
  for (const char* name : kNumbers) {
    const ConfigField* field = find_field(name);
    if (field->get(c) != 0) found.push_back(field);
  }
  return found;
}

std::optional<Config> stepped(const Config& c, const ConfigField& field, int direction) {
  const Limits& allowed = field.allowed;
  const int value = field.get(c);
  int next = allowed.is_power ? (direction < 0 ? value / 2 : value * 2) : value + direction;
  // Without depth is another circuit, and no step of its bits; without highlights is one of theirs.
  if (next < allowed.low && allowed.is_optional && allowed.is_power && direction < 0) next = 0;
  if (next == value || (next != 0 && (next < allowed.low || next > allowed.high))) return std::nullopt;
  if (next == 0 && !(allowed.is_optional && allowed.is_power)) return std::nullopt;
  Config changed = c;
  field.set(changed, next);
  return changed;
}

const std::vector<FitUnit>& fit_units() {
  static const std::vector<FitUnit> units = {{"depth", without_depth},     {"shading", simpler_shading},
                                             {"texture", simpler_texture}, {"mapping", affine},
                                             {"filter", simpler_filter},   {"relight", without_relight}};
  return units;
}

FitNeeds fit_needs(const FitScene& scene, const ref::IdealLook& look) {
  FitNeeds needs;
  const bool lit = look.distant || look.shading == ref::ShadingMode::kPhong;
  for (const Subject& subject : scene.frames) {
    if (!subject.scene()) continue;
    const ref::Scene& drawn = look.texture && subject.has_textures() ? *subject.textured() : *subject.scene();
    if (look.texture && subject.has_textures()) {
      int texels = 0;
      for (const ref::Texture& texture : drawn.textures)
        texels += 1 << (bits_for(texture.width) + bits_for(texture.height) - 2);
      needs.textures = std::max(needs.textures, int(drawn.textures.size()));
      needs.texels = std::max(needs.texels, texels);
    }
    if (!lit) continue;
    const ref::Geometry geometry(drawn, ref::ideal_view(scene.width, scene.height));
    const ref::DistantScene distant = ref::distant_scene(drawn, geometry.viewpoint(), kMostSquarings);
    needs.lights = std::max(needs.lights, int(distant.lights.size()));
    needs.materials = std::max(needs.materials, int(distant.materials.size()));
    for (const ref::DistantMaterial& material : distant.materials) {
      for (const auto& reflection : material.reflections) {
        if (reflection.specular != glm::dvec3(0)) needs.squarings = std::max(needs.squarings, material.squarings);
      }
    }
  }
  return needs;
}

Config generous(const FitScene& scene, const ref::IdealLook& look, const FitNeeds& needs, int subpixel_bits) {
  Config c{"fit"};
  c.width = scene.width, c.height = scene.height, c.triangles = 1;
  c.range_bits = range_bits_for(scene.width, scene.height);
  c.subpixel_bits = subpixel_bits;
  c.depth_bits = 24, c.colour_bits = 8, c.lanes = 1;
  if (needs.lights != 0) {
    if (look.shading == ref::ShadingMode::kPhong) c.shading = Shading::kPhong;
    c.normal_bits = 16;
    c.lights = needs.lights;
    c.gloss = needs.squarings < 0 ? 0 : 1 << needs.squarings;
    c.materials = needs.materials;
  }
  if (needs.textures != 0) {
    c.texture = *look.texture == ref::TextureFilter::kBilinear ? TextureFilter::kBilinear : TextureFilter::kNearest;
    c.mapping = TextureMapping::kPerspective;
    c.textures = needs.textures;
    c.texels = 4;
    while (c.texels < std::min(needs.texels, kMostTexels)) c.texels *= 2;
    c.coordinate_bits = 24;
  }
  give_generous_planes(c);
  return c;
}

Config generous_motion(int width, int height, int face_bits, KeyFilter filter) {
  Config c{"fit"};
  c.width = width, c.height = height, c.triangles = 1;
  c.range_bits = range_bits_for(width, height);
  c.subpixel_bits = 8;
  c.depth_bits = 24, c.colour_bits = 8, c.lanes = 1;
  c.shading = Shading::kMotion;
  c.mapping = TextureMapping::kPerspective;
  c.coordinate_bits = 24;
  c.filter = filter;
  c.vector_range = std::min(13, bits_for(std::max(width, height)));
  c.vector_fraction = 8, c.weight_bits = 8, c.face_bits = std::min(face_bits, 22), c.relight = 1, c.samples = 1;
  give_generous_planes(c);
  return c;
}

}  // namespace halfspace::model
