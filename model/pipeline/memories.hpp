// SPDX-License-Identifier: Apache-2.0
// The memories of the frame: what an entry holds, what accesses come to in bytes, and how many bits the RTL declares.
#ifndef HALFSPACE_MODEL_PIPELINE_MEMORIES_HPP_
#define HALFSPACE_MODEL_PIPELINE_MEMORIES_HPP_

#include <cstdint>

#include "hls/formats/config.hpp"
#include "ref/raster/architecture.hpp"

namespace halfspace::model {

// Bits of an entry; 0 where there is no such memory.
struct BufferBits {
  int depth, frame, pixel, index, visibility, shading, object = 0;
};
BufferBits entry_bits(const Config&);

// Entries of so many bits, not filled up to bytes.
constexpr std::uint64_t bytes_of(std::uint64_t entries, int bits) { return (entries * std::uint64_t(bits) + 7) / 8; }
// Read and written.
std::uint64_t total_bytes(const ref::BufferUses&, const BufferBits&);

// A buffer of BufferUses and BufferBits by its name.
struct NamedBuffer {
  const char* name;
  ref::BufferUse ref::BufferUses::*use;
  int BufferBits::*bits;
};
constexpr NamedBuffer kBuffers[] = {{"depth_buffer", &ref::BufferUses::depth, &BufferBits::depth},
                                    {"frame_buffer", &ref::BufferUses::frame, &BufferBits::frame},
                                    {"pixel_buffer", &ref::BufferUses::pixel, &BufferBits::pixel},
                                    {"index_buffer", &ref::BufferUses::index, &BufferBits::index},
                                    {"visibility_database", &ref::BufferUses::visibility, &BufferBits::visibility},
                                    {"shading_database", &ref::BufferUses::shading, &BufferBits::shading},
                                    {"object_table", &ref::BufferUses::object, &BufferBits::object}};

// What objects add to a frame as any circuit needs it: scan-out reads the depth of each pixel, and the object of each
// triangle that it reads from TdbS; the object of each triangle that comes is stored.
void add_object_uses(std::uint64_t pixels, std::uint64_t triangles, ref::BufferUses&);

// Bits of a frame's memories: two banks of I-buffer and TdbS, and with objects of the Z-buffer and of their table; one
// of Z-buffer or TdbV. A buffer has whole stamps, a database as many entries as its address tells apart.
struct MemoryBits {
  std::uint64_t index, depth, shading, visibility, object;
  std::uint64_t total() const { return index + depth + shading + visibility + object; }
};
MemoryBits memory_bits(const Config&, int lanes_x = 1, int lanes_y = 1);

// Of texture, which are beside these: two banks of planes of coordinates, and the texels. 0 without.
struct TextureBits {
  std::uint64_t planes = 0, texels = 0;
  std::uint64_t total() const { return planes + texels; }
};
TextureBits texture_bits(const Config&);
// Bits of the planes of coordinates of a triangle, and of a texel.
int coordinate_planes_bits(const Config&);
constexpr int texel_bits(const Config& c) { return 3 * c.colour_bits; }

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_PIPELINE_MEMORIES_HPP_
