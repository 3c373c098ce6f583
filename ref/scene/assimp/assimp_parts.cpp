// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/assimp/assimp_parts.hpp"

#include <algorithm>
#include <cmath>

#include "ref/scene/input_file.hpp"

namespace halfspace::ref {
namespace {

constexpr char kNamelessNode[] = "$ColladaAutoName$_";  // with a number: Assimp's name of a node that has none

// Half of the size of the view at distance 1; 0 for an angle that is none. Assimp's Collada importer turns
// the angle of a camera that has none, 45 degrees, into radians twice: 0.0137.
double half_size(double angle) { return angle > 0.0138 && angle < 3.1 ? std::tan(angle / 2) : 0; }

Camera camera_of(const aiCamera& source) {
  Camera camera;
  camera.position = to_glm(source.mPosition);
  camera.forward = to_glm(source.mLookAt);
  camera.up = to_glm(source.mUp);
  const double aspect = source.mAspect > 0 ? source.mAspect : 0;
  if (source.mOrthographicWidth > 0) {
    camera.orthographic = true;
    camera.half_width = source.mOrthographicWidth;
    camera.half_height = aspect > 0 ? camera.half_width / aspect : 0;
  } else {
    camera.half_width = half_size(source.mHorizontalFOV);
    camera.half_height = aspect > 0 ? camera.half_width / aspect : 0;
  }
  if (source.mClipPlaneNear > 0 && source.mClipPlaneFar > source.mClipPlaneNear) {
    camera.near = source.mClipPlaneNear;
    if (std::isfinite(source.mClipPlaneFar)) camera.far = source.mClipPlaneFar;
  }
  return camera;
}

int number_of(const aiString& name, const NodeNumbers& numbers) {
  const auto found = numbers.find(name.C_Str());
  return found == numbers.end() ? -1 : found->second;
}

}  // namespace

void add_cameras(const aiScene& file, const NodeNumbers& numbers, const Collada& collada, Document* document) {
  const std::string extension = extension_of(document->name);
  const bool is_doubtful = extension == "3ds" || extension == "ase";  // their importers turn cameras the wrong way
  const double unit = glm::length(glm::dvec3(to_glm(file.mRootNode->mTransformation)[0]));  // of the file, in metres
  std::map<std::string, std::size_t> taken;
  for (unsigned i = 0; i < file.mNumCameras; ++i) {
    const aiCamera& source = *file.mCameras[i];
    Camera camera = camera_of(source);
    if (extension == "lws") camera.forward.z = -camera.forward.z;  // its importer turns all round but this
    std::string node = source.mName.C_Str();
    if (node.rfind(kNamelessNode, 0) == 0) node.clear();
    const auto of_node = collada.cameras.find(node);
    if (of_node != collada.cameras.end()) {
      const Camera& said = of_node->second[taken[node]++ % of_node->second.size()];
      camera.orthographic = said.orthographic;
      const double scale = said.orthographic ? unit : 1;
      camera.half_width = scale * said.half_width, camera.half_height = scale * said.half_height;
      camera.near = said.near, camera.far = said.far;
    }
    document->cameras.push_back(
        {one_line(source.mName.C_Str()), number_of(source.mName, numbers), camera, is_doubtful});
  }
}

void add_lights(const aiScene& file, const NodeNumbers& numbers, Document* document) {
  glm::dvec3 ambient(0);
  for (unsigned i = 0; i < file.mNumLights; ++i) {
    const aiLight& source = *file.mLights[i];
    Light light;
    light.colour = sane_colour(to_glm(source.mColorDiffuse));
    light.position = to_glm(source.mPosition);
    light.attenuation = {source.mAttenuationConstant, source.mAttenuationLinear, source.mAttenuationQuadratic};
    light.direction = to_glm(source.mDirection);
    light.cos_inner = std::cos(source.mAngleInnerCone / 2.0);
    light.cos_outer = std::cos(source.mAngleOuterCone / 2.0);
    switch (source.mType) {
      case aiLightSource_AMBIENT:
        ambient += glm::max(sane_colour(to_glm(source.mColorAmbient)), light.colour);
        continue;
      case aiLightSource_DIRECTIONAL: light.kind = Light::Kind::kDirectional; break;
      case aiLightSource_SPOT: light.kind = Light::Kind::kSpot; break;
      default: light.kind = Light::Kind::kPoint;  // an area light is a point from afar
    }
    if (!is_black(light.colour)) document->lights.push_back({number_of(source.mName, numbers), light});
  }
  if (!is_black(ambient)) document->ambient = ambient;
}

}  // namespace halfspace::ref
