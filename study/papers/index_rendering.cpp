// SPDX-License-Identifier: Apache-2.0
#include "study/papers/index_rendering.hpp"

#include <fmt/format.h>

#include "hls/formats/formats.hpp"
#include "model/formats/configuration.hpp"
#include "ref/error.hpp"

namespace halfspace::model {

using ref::Architecture;
using ref::ShadingMode;

const std::vector<HardwareLevel>& hardware_levels() {
  static const std::vector<HardwareLevel> levels = {{"high", 65536, 30, 13, {{1024, 768}, {800, 600}}},
                                                    {"middle", 16384, 30, 11, {{800, 600}, {640, 480}}},
                                                    {"low", 4096, 24, 9, {{320, 200}, {160, 100}}}};
  return levels;
}

BufferBits buffer_bits(const HardwareLevel& level, ShadingMode mode, WidePixel wide) {
  const FormatTable t = format_table(find_configuration(level.config).config());
  constexpr int kMaterialBits = 8;
  const int colour = 3 * t.colour.width, normal = level.normal_bits + 1;
  // Planes of normals with the fraction bits of those of colours.
  const int gradient_fraction = t.colour_plane.width - t.colour.width;
  const int shading = mode == ShadingMode::kFlat    ? colour
                      : mode == ShadingMode::kPhong ? 3 * 3 * (normal + gradient_fraction) + kMaterialBits
                                                    : 3 * 3 * t.colour_plane.width;
  const int interpolated = mode == ShadingMode::kPhong ? 3 * normal + kMaterialBits : colour;
  return {
      t.depth.width,           colour, wide == WidePixel::kPlanes ? shading : interpolated, bits_for(level.triangles),
      3 * t.depth_plane.width, shading};
}

namespace {

BufferBytes bytes_of(const BufferBits& bits, double depth, double frame, double pixel, double index, double visibility,
                     double shading) {
  return {depth * bits.depth / 8, frame * bits.frame / 8,           pixel * bits.pixel / 8,
          index * bits.index / 8, visibility * bits.visibility / 8, shading * bits.shading / 8};
}

}  // namespace

BufferBytes buffer_sizes(const HardwareLevel& level, int width, int height, Architecture architecture, ShadingMode mode,
                         WidePixel wide) {
  const double pixels = double(width) * height;
  const bool indexed = is_index_rendering(architecture), gamma = architecture == Architecture::kGamma;
  return bytes_of(buffer_bits(level, mode, wide), gamma ? 0 : pixels, architecture == Architecture::kAlpha ? pixels : 0,
                  architecture == Architecture::kBeta ? pixels : 0, indexed ? pixels : 0, gamma ? level.triangles : 0,
                  indexed ? level.triangles : 0);
}

BufferBytes buffer_traffic(const ref::BufferUses& uses, const BufferBits& bits) {
  const auto accesses = [](const ref::BufferUse& use) { return double(use.read + use.written); };
  return bytes_of(bits, accesses(uses.depth), accesses(uses.frame), accesses(uses.pixel), accesses(uses.index),
                  accesses(uses.visibility), accesses(uses.shading));
}

ref::BufferUses largest_uses(const HardwareLevel& level, int width, int height, Architecture architecture) {
  const std::uint64_t pixels = std::uint64_t(width) * height, triangles = std::uint64_t(level.triangles);
  const std::uint64_t fragments = triangles * kTrianglePixels;
  ref::BufferUses uses;
  if (architecture != Architecture::kGamma) {
    uses.depth = {pixels, fragments, fragments + (is_index_rendering(architecture) ? 0 : pixels)};
  }
  if (architecture == Architecture::kAlpha) uses.frame = {pixels, pixels, fragments + pixels};
  if (architecture == Architecture::kBeta) uses.pixel = {pixels, pixels, fragments + pixels};
  if (is_index_rendering(architecture)) {
    uses.index = {pixels, fragments + pixels, fragments + pixels};
    uses.shading = {triangles, pixels, triangles};
  }
  if (architecture == Architecture::kGamma) uses.visibility = {triangles, fragments, triangles};
  return uses;
}

FourRates measure_architectures(const ref::Scene& scene, const std::string& config, int width, int height,
                                ShadingMode mode) {
  ref::RasterFormat format = raster_format(find_configuration(config));
  // The frame and the number of triangles are the paper's and not the configuration's.
  format.width = width;
  format.height = height;
  format.triangles = 1 << 22;
  format.range_bits = std::max(format.range_bits, 12);
  FourRates rates;
  ref::Drawing first;
  for (std::size_t n = 0; n < rates.size(); ++n) {
    ref::Geometry geometry(scene, {width, height, format.range_bits, format.subpixel_bits});
    const ref::SnappedList list = ref::snap(geometry.positions(), format);
    auto surface = ref::lit_surface(geometry, list, mode);
    if (!scene.textures.empty()) {
      surface = ref::textured_surface(std::move(surface), geometry, list,
                                      {ref::TextureFilter::kNearest, ref::TextureMapping::kAffine});
    }
    constexpr std::uint32_t kInFlight = 64;
    ref::Drawing drawing = ref::draw(list, *surface, ref::kArchitectures[n], true, {kInFlight});
    rates[n] = {drawing.rates, drawing.buffers};
    if (n == 0) first = std::move(drawing);
    else if (drawing.colour != first.colour || drawing.triangle != first.triangle) {
      throw ref::Error(fmt::format("{} at {}x{}: {} and {} draw different pictures: this is a fault of the program",
                                   scene.name, width, height, name_of(ref::kArchitectures[0]),
                                   name_of(ref::kArchitectures[n])));
    }
  }
  return rates;
}

ref::Scene culled(ref::Scene scene, bool cull) {
  for (ref::Material& material : scene.materials) material.two_sided = !cull;
  return scene;
}

double even_pixel_bits(const BufferBytes& beta, const BufferBytes& gamma, const ref::BufferUse& pixel) {
  return 8 * (gamma.total() - (beta.total() - beta.pixel)) / double(pixel.read + pixel.written);
}

}  // namespace halfspace::model
