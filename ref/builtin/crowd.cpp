// SPDX-License-Identifier: Apache-2.0
#include "ref/builtin/crowd.hpp"

#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "ref/builtin/mesh_builder.hpp"
#include "ref/error.hpp"

namespace halfspace::ref {
namespace {

constexpr double kHalfHeight = 0.3;            // of the view at distance 1
constexpr double kNearest = 1, kFarthest = 2;  // distances of the objects
constexpr int kAround = 48, kAcross = 47;      // 2 · 48 · 47 triangles
const glm::dvec3 kColours[] = {{0.85, 0.62, 0.18}, {0.25, 0.55, 0.85}, {0.80, 0.30, 0.30}};

}  // namespace

// A ball of radius r at distance d covers π r² / (4 h² a d²) of the frame, h half its height at distance 1, a its
// aspect; with distances even from 1 to 2 the mean of 1/d² is ½.
Crowd::Crowd(const CrowdOptions& options)
    : options_(options), random_(options.seed), moves_(std::size_t(std::max(options.objects, 0))) {
  if (options.objects < 1 || !(options.layers > 0) || !(options.interval >= 1)) {
    throw Error(fmt::format("a crowd of {} objects in {} layers, moving for {} frames: take 1 of each at least",
                            options.objects, options.layers, options.interval));
  }
  const double h = kHalfHeight;
  radius_ = std::sqrt(options.layers * 8 * h * h * options.aspect / (glm::pi<double>() * options.objects));
  scene_.name = "crowd";
  for (int m = 0; m < 3; ++m) {
    MeshBuilder builder;
    if (m == 0) builder.torus(0.7, 0.3, kAround, kAcross);
    if (m == 1) builder.ellipsoid({0, 0, 0}, {1, 1, 1}, kAround, kAcross + 1);
    if (m == 2) builder.ellipsoid({0, 0, 0}, {0.6, 1, 0.6}, kAround, kAcross + 1);
    scene_.meshes.push_back(std::move(builder).mesh("part"));
    scene_.meshes.back().material = m;
    Material material;
    material.ambient = material.diffuse = kColours[m];
    material.specular = glm::dvec3(0.4);
    material.shininess = 20;
    scene_.materials.push_back(material);
  }
  Camera camera;
  camera.half_height = h;
  scene_.camera = camera;
  scene_.depth_planes = DepthPlanes{std::max(kNearest - 1.01 * radius_, 0.01), kFarthest + 1.01 * radius_};
  for (int n = 0; n < options.objects; ++n) {
    const double d = uniform(kNearest, kFarthest);
    const double x = uniform(-1, 1) * h * options.aspect * d, y = uniform(-1, 1) * h * d;
    glm::dmat4 m = glm::translate(glm::dmat4(1), glm::dvec3(x, y, -d));
    m = glm::rotate(m, uniform(0, 2 * glm::pi<double>()), direction());
    scene_.instances.push_back({n % 3, glm::scale(m, glm::dvec3(radius_))});
  }
}

// Of the upper 53 bits: the same everywhere.
double Crowd::uniform(double low, double high) { return low + (high - low) * std::ldexp(double(random_() >> 11), -53); }

glm::dvec3 Crowd::direction() {
  for (;;) {
    const double x = uniform(-1, 1), y = uniform(-1, 1), z = uniform(-1, 1);
    const double length = std::sqrt(x * x + y * y + z * z);
    if (length > 0.1 && length < 1) return glm::dvec3(x, y, z) / length;
  }
}

bool Crowd::holds(const glm::dvec3& p) const {
  const double d = -p.z, h = kHalfHeight;
  return d >= kNearest && d <= kFarthest && std::abs(p.x) <= h * options_.aspect * d && std::abs(p.y) <= h * d;
}

void Crowd::choose(int frames) {
  std::uint32_t object;
  do object = std::uint32_t(random_() % std::uint64_t(options_.objects));
  while (moves_[object]);
  moves_[object] = true;
  movers_.push_back({object, radius_ / 8 * direction(), frames});
  ++starts_;
}

// Turns back where it would leave.
void Crowd::move(Mover& mover) {
  glm::dvec4& place = scene_.instances[mover.object].to_world[3];
  if (!holds(glm::dvec3(place) + mover.step)) mover.step = -mover.step;
  place += glm::dvec4(mover.step, 0);
  --mover.left;
}

void Crowd::step(int moving) {
  if (moving < 0 || 3 * moving > options_.objects) {
    throw Error(fmt::format("{} of {} objects cannot move: take a third of them at most", moving, options_.objects));
  }
  starts_ = 0;
  std::vector<Mover> going;
  std::vector<std::uint32_t> stopped;  // in this frame: none of them is chosen
  for (const Mover& mover : movers_) {
    if (mover.left > 0) going.push_back(mover);
    else stopped.push_back(mover.object);
  }
  movers_ = std::move(going);
  // Who follows one that has stopped begins an interval; who comes on top is met in one, the likelier the longer it is.
  for (std::size_t n = 0; int(movers_.size()) < moving; ++n) {
    const bool follows = n < stopped.size();
    const double whole = 2 * options_.interval * (follows ? uniform(0, 1) : std::sqrt(uniform(0, 1)));
    choose(1 + int(follows ? whole : uniform(0, whole)));
  }
  for (const std::uint32_t object : stopped) moves_[object] = false;
  for (Mover& mover : movers_) move(mover);
}

}  // namespace halfspace::ref
