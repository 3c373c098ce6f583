// SPDX-License-Identifier: Apache-2.0
#include "model/pipeline/memories.hpp"

#include "hls/formats/records.hpp"

namespace halfspace::model {

BufferBits entry_bits(const Config& config) {
  const FormatTable t = format_table(config);
  const int keys = kKeys * (Bit::width() + 2 * t.origin.width + t.extent.width +
                            (has_perspective(config) ? 9 : 6) * t.coordinate_plane.width +
                            (relights(config) ? 9 * t.difference_plane.width : 0));
  const int shading = has_motion(config)   ? t.face.width + keys
                      : is_gouraud(config) ? 9 * t.colour_plane.width
                      : is_phong(config)   ? 9 * t.normal_plane.width + t.material.width
                                           : 3 * t.colour.width;
  return {stores_depth(config) ? t.depth.width : 0,
          0,
          0,
          t.index.width,
          tests_planes(config) ? 3 * t.depth_plane.width : 0,
          shading,
          config.object_bits};
}

std::uint64_t total_bytes(const ref::BufferUses& uses, const BufferBits& bits) {
  std::uint64_t total = 0;
  for (const NamedBuffer& buffer : kBuffers) {
    const ref::BufferUse& use = uses.*buffer.use;
    total += bytes_of(use.read, bits.*buffer.bits) + bytes_of(use.written, bits.*buffer.bits);
  }
  return total;
}

void add_object_uses(std::uint64_t pixels, std::uint64_t triangles, ref::BufferUses& uses) {
  uses.depth.read += pixels;
  uses.object.read += uses.shading.read;
  uses.object.written += triangles;
}

namespace {

// Entries that an address of a database tells apart.
std::uint64_t whole_address(int triangles) {
  std::uint64_t entries = 1;
  while (entries < std::uint64_t(triangles)) entries *= 2;
  return entries;
}

}  // namespace

MemoryBits memory_bits(const Config& c, int lanes_x, int lanes_y) {
  const BufferBits entry = entry_bits(c);
  const auto stamps = [](int size, int lanes) { return std::uint64_t(size + lanes - 1) / lanes; };
  const std::uint64_t pixels = stamps(c.width, lanes_x) * stamps(c.height, lanes_y) * lanes_x * lanes_y;
  const std::uint64_t triangles = whole_address(c.triangles);
  const std::uint64_t depth_banks = has_objects(c) ? 2 : 1;
  return {2 * pixels * entry.index, depth_banks * pixels * entry.depth, 2 * triangles * entry.shading,
          triangles * entry.visibility, 2 * triangles * entry.object};
}

int coordinate_planes_bits(const Config& c) {
  const FormatTable t = format_table(c);
  if (!has_texture(c)) return 0;
  return t.texture.width + t.repeats.width + (has_perspective(c) ? 9 : 6) * t.coordinate_plane.width;
}

TextureBits texture_bits(const Config& c) {
  if (!has_texture(c)) return {};
  return {2 * whole_address(c.triangles) * std::uint64_t(coordinate_planes_bits(c)),
          std::uint64_t(c.texels) * texel_bits(c)};
}

}  // namespace halfspace::model
