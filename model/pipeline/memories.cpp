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

MemoryBits memory_bits(const Config& c, int lanes_x, int lanes_y) {
  const BufferBits entry = entry_bits(c);
  const auto stamps = [](int size, int lanes) { return std::uint64_t(size + lanes - 1) / lanes; };
  const std::uint64_t pixels = stamps(c.width, lanes_x) * stamps(c.height, lanes_y) * lanes_x * lanes_y;
  std::uint64_t triangles = 1;
  while (triangles < std::uint64_t(c.triangles)) triangles *= 2;
  const std::uint64_t depth_banks = has_objects(c) ? 2 : 1;
  return {2 * pixels * entry.index, depth_banks * pixels * entry.depth, 2 * triangles * entry.shading,
          triangles * entry.visibility, 2 * triangles * entry.object};
}

}  // namespace halfspace::model
