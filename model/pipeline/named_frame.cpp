// SPDX-License-Identifier: Apache-2.0
#include "model/pipeline/named_frame.hpp"

#include "model/pipeline/engine.hpp"

namespace halfspace::model {
namespace {

std::vector<std::uint32_t> objects_of(const NamedFrame& frame, const Config& config) {
  if (!frame.objects.empty()) return frame.objects;
  const std::uint32_t most = (1u << config.object_bits) - 1;
  std::vector<std::uint32_t> objects;
  for (std::size_t k = 0; k < frame.scene.triangles.size(); ++k) objects.push_back(1 + std::uint32_t(k / 4) % most);
  return objects;
}

}  // namespace

void load_frame(Engine& engine, const Config& config, const NamedFrame& frame) {
  if (has_lighting(config)) engine.light(frame.lighting);
  if (has_texture(config)) engine.texture(frame.texture);
  if (!shades(config)) engine.move(frame.motion);
  if (has_objects(config)) engine.number(objects_of(frame, config));
}

}  // namespace halfspace::model
