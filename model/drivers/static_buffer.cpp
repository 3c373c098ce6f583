// SPDX-License-Identifier: Apache-2.0
#include "model/drivers/static_buffer.hpp"

#include "model/texture/texture.hpp"
#include "ref/geometry/geometry.hpp"
#include "ref/objects/static_instances.hpp"

namespace halfspace::model {

bool StaticBuffer::shows(const ref::Scene& scene, const std::vector<bool>& instances, const ref::View& view) const {
  if (!scene_ || instances != shown_) return false;
  const std::vector<bool> same = ref::same_instances(*scene_, scene, double(view.width) / view.height);
  for (std::size_t n = 0; n < same.size(); ++n) {
    if (instances[n] && !same[n]) return false;
  }
  return true;
}

std::size_t StaticBuffer::show(const ref::Scene& scene, const std::vector<bool>& instances, const ref::View& view) {
  if (shows(scene, instances, view)) return 0;
  const Config config = configuration_.config();
  ref::Geometry geometry(scene, view);
  const ref::TriangleList all = ref::lit_triangles(geometry);
  ref::TriangleList list{all.width, all.height, all.background, {}, {}};
  TextureFrame texture, used;
  if (has_texture(config)) texture = texture_frame(geometry, config), used = {texture.textures, texture.texels, {}};
  std::vector<std::uint32_t> object;  // of each triangle
  for (std::size_t k = 0; k < all.triangles.size(); ++k) {
    const std::uint32_t instance = geometry.origins()[k].instance;
    if (!instances[instance]) continue;
    list.triangles.push_back(all.triangles[k]);
    object.push_back(instance + 1);
    if (has_texture(config)) used.triangles.push_back(texture.triangles[k]);
  }
  if (has_texture(config)) engine_.texture(used);
  const ref::Frame frame = engine_.render(ref::snap(list, raster_format(configuration_)));
  pixels_.emplace(view.width, view.height, ref::full_depth(config.depth_bits));
  for (std::size_t n = 0; n < frame.index.size(); ++n) {
    const std::uint32_t index = frame.index[n];
    ref::ObjectPixel& pixel = pixels_->at(int(n) % view.width, int(n) / view.width);
    pixel = {ref::object_key(frame.depth[n], index == 0 ? 0 : object[index - 1]), index, frame.colour[n]};
  }
  scene_ = scene;
  shown_ = instances;
  return list.triangles.size();
}

}  // namespace halfspace::model
