// SPDX-License-Identifier: Apache-2.0
#include "ref/geometry/viewpoint.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

namespace halfspace::ref {
namespace {

constexpr double kHalfHeight = 0.3;  // of the automatic view at distance 1: 33 degrees
constexpr double kMargin = 1.06;

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(double value) { low = std::min(low, value), high = std::max(high, value); }
};

Viewpoint look(const glm::dvec3& eye, const glm::dvec3& direction, const glm::dvec3& up_hint) {
  Viewpoint view{eye, glm::normalize(direction), {}, {}, false, {}};
  glm::dvec3 right = glm::cross(view.forward, up_hint);
  if (!(glm::length(right) > 1e-9)) {
    right = glm::cross(view.forward, std::abs(view.forward.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0));
  }
  view.right = glm::normalize(right);
  view.up = glm::cross(view.right, view.forward);
  return view;
}

// The closest eye on a line of sight that sees all points. With t the slope of a side of the view, a point at
// (x, z), z away from the viewer, is seen from (c, -d) when |x - c| <= t (d + z): so with
//   A = max(x - t z),  B = max(-x - t z):  A - t d <= c <= t d - B,  d >= (A + B) / 2t,
// and c = (A - B) / 2 is mid-way.
glm::dvec3 framing_eye(const std::vector<glm::dvec3>& points, const Viewpoint& view, double aspect) {
  const double slope_x = kHalfHeight * aspect / kMargin, slope_y = kHalfHeight / kMargin;
  const glm::dvec3 origin = points.front();
  Range left, right, below, above, depth;
  for (const glm::dvec3& point : points) {
    const glm::dvec3 p = point - origin;
    const double x = glm::dot(p, view.right), y = glm::dot(p, view.up), z = glm::dot(p, view.forward);
    right.add(x - slope_x * z), left.add(-x - slope_x * z);
    above.add(y - slope_y * z), below.add(-y - slope_y * z);
    depth.add(z);
  }
  double d = std::max((right.high + left.high) / (2 * slope_x), (above.high + below.high) / (2 * slope_y));
  // Something flat seen edge on, or a single point, would put the eye into it.
  const double least = -depth.low + std::max(1e-3 * (depth.high - depth.low), 1e-6);
  d = std::max(d, least);
  return origin + (right.high - left.high) / 2 * view.right + (above.high - below.high) / 2 * view.up -
         d * view.forward;
}

// How far away the geometry before the eye begins and ends.
Range depth_range(const Scene& scene, const Viewpoint& view) {
  Range range;
  for (const Instance& instance : scene.instances) {
    for (const glm::dvec3& position : scene.meshes[instance.mesh].positions) {
      const glm::dvec3 point(instance.to_world * glm::dvec4(position, 1));
      range.add(glm::dot(point - view.eye, view.forward));
    }
  }
  return range;
}

void half_sizes(const Camera& camera, double aspect, double* half_width, double* half_height) {
  double height = camera.half_height > 0 ? camera.half_height : camera.half_width / aspect;
  if (!(height > 0) || !std::isfinite(height)) height = kHalfHeight;
  *half_height = height;
  *half_width = height * aspect;
}

// Eye and directions.
Viewpoint place(const Scene& scene, double aspect) {
  Viewpoint view;
  if (scene.camera) {
    view = look(scene.camera->position, scene.camera->forward, scene.camera->up);
    view.orthographic = scene.camera->orthographic;
  } else {
    view = look({0, 0, 0}, scene.view_direction, {0, 1, 0});
    view.eye = framing_eye(scene.framing, view, aspect);
  }
  return view;
}

// A little more than the geometry has, so that nothing lies on a plane. The planes of a file can be far off
// (0.05 and 1e6 for a model of 10); drawn in to the geometry they cut off the same, and leave depth its
// bits. Without planes the nearest is at most 1:10000.
DepthPlanes planes_from(const Scene& scene, const Viewpoint& view) {
  if (scene.depth_planes) return *scene.depth_planes;
  const Camera camera = scene.camera.value_or(Camera());
  const Range depth = depth_range(scene, view);
  double far = 1.02 * depth.high;
  if (camera.far > 0) far = std::min(far, camera.far);
  if (!(far > camera.near)) far = camera.near > 0 ? 2 * camera.near : 1;
  const double least = camera.near > 0 ? camera.near : 1e-4 * far;
  return {std::clamp(0.98 * depth.low, least, std::max(least, 0.98 * far)), far};
}

}  // namespace

DepthPlanes depth_planes(const Scene& scene, double aspect) { return planes_from(scene, place(scene, aspect)); }

DepthPlanes joined(const DepthPlanes& a, const DepthPlanes& b) {
  return {std::min(a.near, b.near), std::max(a.far, b.far)};
}

void zoom(Scene& scene, double zoom, double aspect) {
  const Viewpoint view = place(scene, aspect);
  Camera camera = scene.camera.value_or(Camera());
  half_sizes(camera, aspect, &camera.half_width, &camera.half_height);
  camera.half_width /= zoom, camera.half_height /= zoom;
  camera.position = view.eye, camera.forward = view.forward;
  scene.camera = camera;
}

Viewpoint viewpoint(const Scene& scene, double aspect) {
  Viewpoint view = place(scene, aspect);
  const auto [near, far] = planes_from(scene, view);
  double half_width, half_height;
  half_sizes(scene.camera.value_or(Camera()), aspect, &half_width, &half_height);
  const glm::dmat4 to_eye = glm::lookAtRH(view.eye, view.eye + view.forward, view.up);
  if (view.orthographic) {
    view.to_clip = glm::orthoRH_ZO(-half_width, half_width, -half_height, half_height, near, far) * to_eye;
  } else {
    const double x = near * half_width, y = near * half_height;
    view.to_clip = glm::frustumRH_ZO(-x, x, -y, y, near, far) * to_eye;
  }
  return view;
}

}  // namespace halfspace::ref
