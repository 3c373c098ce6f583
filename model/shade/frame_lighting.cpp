// SPDX-License-Identifier: Apache-2.0
#include "model/shade/frame_lighting.hpp"
#include "ref/geometry/distant_lighting.hpp"

namespace halfspace::model {

LightingFrame frame_lighting(const ref::Geometry& geometry, const Config& config) {
  const ref::DistantScene scene = ref::distant_scene(geometry.scene(), geometry.viewpoint(), most_squarings(config));
  LightingFrame frame = quantized_lighting(scene, config);
  frame.triangles.clear();
  for (std::size_t k = 0; k < geometry.positions().triangles.size(); ++k) {
    RawNormals& out = frame.triangles.emplace_back();
    out.index = int(k) + 1;
    out.material = scene.triangles[scene.of_face[geometry.positions().face[k] - 1]].material;
    const std::array<glm::dvec3, 3> normals = geometry.normals(k);
    for (int v = 0; v < 3; ++v) out.normals[v] = quantized_normal(normals[v], config);
  }
  return frame;
}

}  // namespace halfspace::model
