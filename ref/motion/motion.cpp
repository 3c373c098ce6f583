// SPDX-License-Identifier: Apache-2.0
#include "ref/motion/motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ref/error.hpp"
#include "ref/geometry/snap.hpp"

namespace halfspace::ref {
namespace {

// A vertex made by the near plane lies on it at the key as well where nothing moves, and rounding must not put it
// behind. In depth.
constexpr double kNearSlack = 1e-6;

bool same_faces(const Scene& a, const Scene& b) {
  const auto same = [&](const Instance& x, const Instance& y) {
    return a.meshes[x.mesh].triangles == b.meshes[y.mesh].triangles &&
           a.meshes[x.mesh].positions.size() == b.meshes[y.mesh].positions.size();
  };
  return std::equal(a.instances.begin(), a.instances.end(), b.instances.begin(), b.instances.end(), same);
}

// The places of a triangle of `geometry` at a key follow from those of its corners there: clipping weighs them in clip
// space.
Trace exact_trace(const Geometry& geometry, std::size_t k, const OfKeys<FacePlaces>& keys, const View& view) {
  const Origin& origin = geometry.origins()[k];
  Trace trace{geometry.positions().face[k], false, origin.w, {}, {}};
  for (int key = 0; key < kKeys; ++key) {
    std::array<glm::dvec2, 3> screen;
    bool seen = true;
    for (int v = 0; v < 3; ++v) {
      glm::dvec4& point = trace.at_key[key][v];
      point = glm::dvec4(0);
      for (int i = 0; i < 3; ++i) point += origin.weights[v][i] * keys[key].clip(origin.instance, origin.corner[i]);
      seen = seen && before_viewer(point);
      if (!seen) continue;
      const Vertex vertex = viewport(point, view);
      screen[v] = {vertex.x, vertex.y};
    }
    if (seen) trace.screen[key] = screen;
  }
  return trace;
}

// Straight lines: what lies in pixels is clipped as if it were clip space with w = 1.
class StraightFaces {
 public:
  StraightFaces(const View& view, Between& out) : view_(view), out_(out) {
    const double guard = std::ldexp(1.0, view.range_bits - 1) - 1;
    frame_ = sides(0, view.width, 0, view.height);
    guard_ = sides(-guard, guard, -guard, guard);
  }

  void add(std::uint32_t face, const OfKeys<std::array<Vertex, 3>>& keys, double a, bool two_sided) {
    std::vector<ClipVertex> polygon;
    for (int v = 0; v < 3; ++v) {
      const auto way = [&](double Vertex::*axis) { return (1 - a) * (keys[0][v].*axis) + a * (keys[1][v].*axis); };
      ClipVertex corner{{way(&Vertex::x), way(&Vertex::y), way(&Vertex::z), 1}, glm::dvec3(0)};
      corner.weights[v] = 1;
      polygon.push_back(corner);
    }
    if (outside_one(polygon, frame_)) return;
    polygon = clip(std::move(polygon), guard_);
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      const std::array<const ClipVertex*, 3> part{&polygon[0], &polygon[i - 1], &polygon[i]};
      std::array<Vertex, 3> triangle;
      Trace trace{face, true, {1, 1, 1}, {}, {}};
      for (int v = 0; v < 3; ++v)
        triangle[v] = {part[v]->position.x, part[v]->position.y, part[v]->position.z, 0, 0, 0};
      if (!two_sided && !faces_viewer(triangle, view_)) continue;
      for (int key = 0; key < kKeys; ++key) {
        trace.screen[key].emplace();
        for (int v = 0; v < 3; ++v) {
          glm::dvec2& place = (*trace.screen[key])[v];
          place = glm::dvec2(0);
          for (int i = 0; i < 3; ++i) place += part[v]->weights[i] * glm::dvec2(keys[key][i].x, keys[key][i].y);
        }
      }
      out_.list.triangles.push_back(triangle);
      out_.list.face.push_back(face);
      out_.traces.push_back(trace);
    }
  }

 private:
  static std::vector<ClipPlane> sides(double left, double right, double top, double bottom) {
    return {{1, 0, 0, -left}, {-1, 0, 0, right}, {0, 1, 0, -top}, {0, -1, 0, bottom}};
  }
  const View view_;
  Between& out_;
  std::vector<ClipPlane> frame_, guard_;
};

}  // namespace

bool before_viewer(const glm::dvec4& clip) { return clip.w > 0 && clip.z >= -kNearSlack * clip.w; }

FacePlaces::FacePlaces(const Scene& scene, const View& view) : view_(view) {
  const Viewpoint seen = viewpoint(scene, double(view.width) / view.height);
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    const Mesh& mesh = scene.meshes[instance.mesh];
    const bool mirrored = glm::determinant(glm::dmat3(instance.to_world)) < 0;
    Placed& placed = instances_.emplace_back(Placed{scene.materials[mesh.material].two_sided, {}});
    for (const glm::dvec3& position : mesh.positions)
      placed.positions.push_back(clip_position(seen, view, instance.to_world, position));
    for (std::array<std::uint32_t, 3> corner : mesh.triangles) {
      if (mirrored) std::swap(corner[1], corner[2]);
      faces_.push_back({i, corner});
    }
  }
}

std::array<glm::dvec4, 3> FacePlaces::clip(std::uint32_t face) const {
  const Face& f = faces_[face - 1];
  return {clip(f.instance, f.corner[0]), clip(f.instance, f.corner[1]), clip(f.instance, f.corner[2])};
}

std::optional<std::array<Vertex, 3>> FacePlaces::screen(std::uint32_t face) const {
  const auto corners = clip(face);
  std::array<Vertex, 3> places;
  for (int v = 0; v < 3; ++v) {
    if (corners[v].z < 0) return std::nullopt;
    places[v] = viewport(corners[v], view_);
  }
  return places;
}

Standing FacePlaces::standing(std::uint32_t face) const {
  const auto corners = clip(face);
  const auto behind = std::count_if(corners.begin(), corners.end(), [](const glm::dvec4& c) { return c.z < 0; });
  if (behind == 3) return Standing::kBehind;
  if (behind > 0) return Standing::kCrossing;
  const std::vector<ClipVertex> polygon{{corners[0], {1, 0, 0}}, {corners[1], {0, 1, 0}}, {corners[2], {0, 0, 1}}};
  if (outside_one(polygon, frame_planes(view_))) return Standing::kOutside;
  const bool front =
      faces_viewer({viewport(corners[0], view_), viewport(corners[1], view_), viewport(corners[2], view_)}, view_);
  return front || two_sided(face) ? Standing::kDrawn : Standing::kCulled;
}

Between follow(MotionMethod method, const Scene& first, const Scene& second, const Scene& between, double a,
               const View& view) {
  if (!same_faces(first, second) || !same_faces(first, between)) {
    throw Error(
        fmt::format("{}: its instances or faces are others at another time, so that none can be followed; export it "
                    "with faces that stay",
                    between.name));
  }
  const OfKeys<FacePlaces> keys{FacePlaces(first, view), FacePlaces(second, view)};
  Between out;
  const auto take = [&](const Geometry& geometry, std::size_t k) {
    out.list.triangles.push_back(geometry.positions().triangles[k]);
    out.list.face.push_back(geometry.positions().face[k]);
    out.traces.push_back(exact_trace(geometry, k, keys, view));
  };
  out.list = {view.width, view.height, {between.background.r, between.background.g, between.background.b}, {}, {}};
  if (method == MotionMethod::kExact) {
    const Geometry geometry(between, view);
    for (std::size_t k = 0; k < geometry.origins().size(); ++k) take(geometry, k);
    return out;
  }
  StraightFaces straight(view, out);
  std::optional<Geometry> exact;  // for faces without a line
  std::size_t k = 0;
  for (std::uint32_t face = 1; face <= keys[0].faces(); ++face) {
    const auto from = keys[0].screen(face), to = keys[1].screen(face);
    if (from && to) {
      straight.add(face, {*from, *to}, a, keys[0].two_sided(face));
      continue;
    }
    ++out.fallen_back;
    if (!exact) exact.emplace(between, view);
    const std::vector<std::uint32_t>& faces = exact->positions().face;
    while (k < faces.size() && faces[k] < face) ++k;
    for (; k < faces.size() && faces[k] == face; ++k) take(*exact, k);
  }
  return out;
}

OfKeys<std::optional<std::array<glm::dvec2, 3>>> vectors(const Between& between, std::size_t triangle) {
  OfKeys<std::optional<std::array<glm::dvec2, 3>>> result = between.traces[triangle].screen;
  for (auto& of_key : result) {
    for (int v = 0; of_key && v < 3; ++v) {
      const Vertex& here = between.list.triangles[triangle][v];
      (*of_key)[v] -= glm::dvec2(here.x, here.y);
    }
  }
  return result;
}

OfKeys<std::optional<std::array<FixedVector, 3>>> fixed_vectors(const Between& between, std::size_t triangle,
                                                                int subpixel_bits, const VectorFormat& format) {
  const double limit = std::ldexp(1.0, format.range_bits + format.fraction_bits);
  OfKeys<std::optional<std::array<FixedVector, 3>>> result;
  for (int key = 0; key < kKeys; ++key) {
    const auto& screen = between.traces[triangle].screen[key];
    if (!screen) continue;
    std::array<FixedVector, 3> fixed;
    bool within = true;
    for (int v = 0; v < 3; ++v) {
      const Vertex& here = between.list.triangles[triangle][v];
      for (int axis = 0; axis < 2; ++axis) {
        const double from = snapped_position(axis == 0 ? here.x : here.y, subpixel_bits);
        const double steps = snapped_position((*screen)[v][axis], subpixel_bits) - from;
        const double rounded = std::floor(std::ldexp(steps, format.fraction_bits - subpixel_bits) + 0.5);
        within = within && rounded >= -limit && rounded < limit;
        if (within) fixed[v][axis] = static_cast<std::int32_t>(rounded);
      }
    }
    if (within) result[key] = fixed;
  }
  return result;
}

}  // namespace halfspace::ref
