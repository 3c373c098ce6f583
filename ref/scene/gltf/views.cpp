// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/gltf/views.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfspace::ref::gltf {

DocumentCamera camera_of(const File& file, int number) {
  const tinygltf::Camera& source = file.model.cameras[std::size_t(number)];
  DocumentCamera out;
  out.name = name_of(source.name);
  Camera& camera = out.camera;
  double near = 0, far = 0;
  if (source.type == "orthographic") {
    camera.orthographic = true;
    camera.half_width = std::abs(source.orthographic.xmag);
    camera.half_height = std::abs(source.orthographic.ymag);
    if (!(camera.half_width > 0) || !(camera.half_height > 0)) {
      file.refuse(fmt::format("cannot be read as a mesh (camera {} sees nothing: xmag or ymag is 0)", number));
    }
    near = source.orthographic.znear, far = source.orthographic.zfar;
  } else {
    camera.half_height = std::tan(source.perspective.yfov / 2);
    if (source.perspective.aspectRatio > 0) camera.half_width = camera.half_height * source.perspective.aspectRatio;
    near = source.perspective.znear, far = source.perspective.zfar;  // 0: there is none
  }
  if (far != 0 && !(far > near)) {
    file.refuse(fmt::format("cannot be read as a mesh (camera {} has zfar {} before znear {})", number, far, near));
  }
  camera.near = near, camera.far = far;
  return out;
}

std::optional<Light> light_of(const File& file, int number) {
  const tinygltf::Light& source = file.model.lights[std::size_t(number)];
  Light light;
  for (int i = 0; i < 3; ++i) {
    light.colour[i] = source.intensity * (source.color.size() == 3 ? source.color[std::size_t(i)] : 1.0);
  }
  if (light.colour == glm::dvec3(0)) return std::nullopt;
  if (source.type == "directional") return light;
  light.attenuation = {0, 0, 1};
  light.kind = source.type == "spot" ? Light::Kind::kSpot : Light::Kind::kPoint;
  if (source.type != "spot" && source.type != "point") {
    file.refuse(fmt::format("cannot be read as a mesh (light {} is of the type '{}')", number, name_of(source.type)));
  }
  light.cos_inner = std::cos(source.spot.innerConeAngle), light.cos_outer = std::cos(source.spot.outerConeAngle);
  return light;
}

int light_number(const File& file, int node) {
  const tinygltf::ExtensionMap& extensions = file.model.nodes[std::size_t(node)].extensions;
  const auto found = extensions.find("KHR_lights_punctual");
  return found == extensions.end() || !found->second.Has("light") ? -1 : found->second.Get("light").GetNumberAsInt();
}

}  // namespace halfspace::ref::gltf
