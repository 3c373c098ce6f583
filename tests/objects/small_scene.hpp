// SPDX-License-Identifier: Apache-2.0
// A small scene of objects that start and stop, and how its pictures are held against drawing everything.
#ifndef HALFSPACE_TESTS_OBJECTS_SMALL_SCENE_HPP_
#define HALFSPACE_TESTS_OBJECTS_SMALL_SCENE_HPP_

#include <utility>
#include <vector>

#include "ref/geometry/geometry.hpp"
#include "ref/objects/static_objects.hpp"
#include "ref/raster/raster.hpp"
#include "vectors/frames/moving_scene.hpp"

namespace halfspace::ref {

constexpr int kWidth = 40, kHeight = 30, kObjects = 16;

inline RasterFormat format_of(int depth_bits) { return {"static", kWidth, kHeight, 4096, 7, 6, depth_bits}; }
inline View view_of(const RasterFormat& format) { return {kWidth, kHeight, format.range_bits, format.subpixel_bits}; }

inline Scene small_scene() { return model::moving_scene(kObjects); }
struct Motion : model::SceneMotion {
  explicit Motion(std::uint64_t seed) : SceneMotion(seed, kObjects) {}
};

// Pixels at which the picture is not what the renderer draws, by face, depth or colour.
inline int wrong_pixels(const Scene& scene, const Frame& drawn, const std::vector<std::uint32_t>& faces,
                        const ObjectBuffer& picture) {
  std::vector<std::uint32_t> first{1};
  for (const Instance& instance : scene.instances)
    first.push_back(first.back() + std::uint32_t(scene.meshes[instance.mesh].triangles.size()));
  int wrong = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const std::size_t at = std::size_t(y) * kWidth + x;
      const ObjectPixel& pixel = picture.at(x, y);
      const std::uint32_t face = pixel.object() == 0 ? 0 : first[pixel.object() - 1] + face_of(pixel.triangle);
      wrong += face != (drawn.index[at] == 0 ? 0 : faces[drawn.index[at] - 1]) || pixel.depth() != drawn.depth[at] ||
               pixel.colour != drawn.colour[at];
    }
  }
  return wrong;
}

struct Everything {
  Frame frame;
  std::vector<std::uint32_t> faces;
};
inline Everything draw_everything(const Scene& scene, const RasterFormat& format) {
  const TriangleList list = project(scene, view_of(format));
  return {render(snap(list, format)), list.face};
}

// An S-buffer drawn from nothing.
inline ObjectBuffer rebuilt(const Scene& scene, const RasterFormat& format, StaticObjects& objects, int k) {
  ObjectBuffer buffer(kWidth, kHeight, full_depth(format.depth_bits));
  for (std::uint32_t n = 0; n < scene.instances.size(); ++n) {
    if (objects.is_static(n) && objects.buffer_of(n) == k) objects.raster().draw(n, buffer, buffer.frame());
  }
  return buffer;
}

inline bool same_objects(const ObjectBuffer& a, const ObjectBuffer& b) {
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      if (a.at(x, y).key != b.at(x, y).key || a.at(x, y).triangle != b.at(x, y).triangle) return false;
    }
  }
  return true;
}

inline StaticOptions options_of(int buffers, OcclusionQuery query) {
  StaticOptions options;
  options.buffers = buffers;
  options.query = std::move(query);
  return options;
}

}  // namespace halfspace::ref

#endif  // HALFSPACE_TESTS_OBJECTS_SMALL_SCENE_HPP_
