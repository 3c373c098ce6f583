// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/normals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numeric>

namespace halfspace::ref {
namespace {

bool usable(double length) { return std::isfinite(length) && length > 0; }

glm::dvec3 face_normal(const Mesh& mesh, const std::array<std::uint32_t, 3>& corner) {
  const glm::dvec3& origin = mesh.positions[corner[0]];
  const glm::dvec3 normal = glm::cross(mesh.positions[corner[1]] - origin, mesh.positions[corner[2]] - origin);
  const double length = glm::length(normal);
  return usable(length) ? normal / length : glm::dvec3(0);
}

double angle_at(const Mesh& mesh, const std::array<std::uint32_t, 3>& corner, int v) {
  const glm::dvec3& here = mesh.positions[corner[v]];
  const glm::dvec3 a = mesh.positions[corner[(v + 1) % 3]] - here, b = mesh.positions[corner[(v + 2) % 3]] - here;
  const double lengths = glm::length(a) * glm::length(b);
  return lengths > 0 ? std::acos(std::clamp(glm::dot(a, b) / lengths, -1.0, 1.0)) : 0;
}

std::uint64_t hash_of(const glm::dvec3& p) {
  std::uint64_t hash = 0;
  for (int i = 0; i < 3; ++i) {
    const double value = p[i] + 0.0;  // -0 is 0
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    hash = (hash ^ bits) * 0x9E3779B97F4A7C15u;
    hash ^= hash >> 32;
  }
  return hash;
}

// The number of each point's place: points at one place have one. How many places there are comes behind.
std::vector<std::uint32_t> numbers_of_places(const std::vector<glm::dvec3>& points) {
  constexpr std::uint32_t kNone = 0xFFFFFFFF;
  std::size_t size = 16;
  while (size < 2 * points.size()) size *= 2;
  std::vector<std::uint32_t> first(size, kNone), numbers;  // first: a point at the place, by its hash
  numbers.reserve(points.size() + 1);
  std::uint32_t places = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::size_t slot = hash_of(points[i]) & (size - 1);
    while (first[slot] != kNone && points[first[slot]] != points[i]) slot = (slot + 1) & (size - 1);
    if (first[slot] == kNone) {
      first[slot] = std::uint32_t(i);
      numbers.push_back(places++);
    } else {
      numbers.push_back(numbers[first[slot]]);
    }
  }
  numbers.push_back(places);
  return numbers;
}

template <class T>
void gather(const std::vector<std::uint32_t>& from, std::vector<T>* values) {
  if (values->empty()) return;
  std::vector<T> gathered;
  gathered.reserve(from.size());
  for (const std::uint32_t i : from) gathered.push_back((*values)[i]);
  *values = std::move(gathered);
}

}  // namespace

glm::dmat3 normal_matrix(const glm::dmat4& to_world) {
  const glm::dmat3 m(to_world);
  const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
  return glm::determinant(m) < 0 ? -1.0 * cofactors : cofactors;
}

void split_vertices(DocumentMesh* source) {
  Mesh& mesh = source->mesh;
  std::vector<std::uint32_t> from;
  from.reserve(3 * mesh.triangles.size());
  for (auto& corner : mesh.triangles) {
    for (std::uint32_t& i : corner) {
      from.push_back(i);
      i = std::uint32_t(from.size() - 1);
    }
  }
  if (!source->joint_weights.empty()) {
    std::vector<std::vector<JointWeight>> of_vertex(mesh.positions.size());
    for (const JointWeight& weight : source->joint_weights) of_vertex[weight.vertex].push_back(weight);
    source->joint_weights.clear();
    for (std::size_t v = 0; v < from.size(); ++v) {
      for (const JointWeight& weight : of_vertex[from[v]])
        source->joint_weights.push_back({std::uint32_t(v), weight.joint, weight.weight});
    }
  }
  gather(from, &mesh.positions);
  gather(from, &mesh.normals);
  gather(from, &mesh.colours);
  gather(from, &mesh.texture_coordinates);
  for (MorphTarget& target : source->targets) {
    gather(from, &target.positions);
    gather(from, &target.normals);
  }
}

void make_flat(Mesh* mesh) {
  mesh->normals.assign(mesh->positions.size(), glm::dvec3(0, 1, 0));
  for (const auto& corner : mesh->triangles) {
    for (const std::uint32_t i : corner) mesh->normals[i] = face_normal(*mesh, corner);
  }
  mend_normals(mesh);
}

void make_smooth(DocumentMesh* source, double crease_degrees) {
  const double least = std::cos(crease_degrees * std::acos(-1.0) / 180);
  Mesh* const mesh = &source->mesh;
  const std::vector<std::uint32_t> numbers = numbers_of_places(mesh->positions);
  // The corners at each place, one place after the other.
  std::vector<std::uint32_t> place_of, first(numbers.back() + 1, 0);
  place_of.reserve(3 * mesh->triangles.size());
  for (const auto& corner : mesh->triangles) {
    for (const std::uint32_t i : corner) place_of.push_back(numbers[i]);
  }
  split_vertices(source);
  for (const std::uint32_t place : place_of) ++first[place + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  struct Meeting {
    std::uint32_t face;
    double angle;
  };
  std::vector<Meeting> meetings(place_of.size());
  std::vector<std::uint32_t> next = first;
  std::vector<glm::dvec3> of_face;
  of_face.reserve(mesh->triangles.size());
  for (std::size_t t = 0; t < mesh->triangles.size(); ++t) {
    of_face.push_back(face_normal(*mesh, mesh->triangles[t]));
    for (int v = 0; v < 3; ++v)
      meetings[next[place_of[3 * t + v]]++] = {std::uint32_t(t), angle_at(*mesh, mesh->triangles[t], v)};
  }
  mesh->normals.assign(mesh->positions.size(), glm::dvec3(0));
  for (std::size_t c = 0; c < place_of.size(); ++c) {
    glm::dvec3& normal = mesh->normals[mesh->triangles[c / 3][c % 3]];
    for (std::uint32_t m = first[place_of[c]]; m < first[place_of[c] + 1]; ++m) {
      const glm::dvec3& other = of_face[meetings[m].face];
      if (glm::dot(other, of_face[c / 3]) >= least) normal += meetings[m].angle * other;
    }
  }
  mend_normals(mesh);
}

void mend_normals(Mesh* mesh) {
  for (const auto& corner : mesh->triangles) {
    for (const std::uint32_t i : corner) {
      const double length = glm::length(mesh->normals[i]);
      if (usable(length)) {
        mesh->normals[i] /= length;
        continue;
      }
      const glm::dvec3 normal = face_normal(*mesh, corner);
      mesh->normals[i] = usable(glm::length(normal)) ? normal : glm::dvec3(0, 1, 0);
    }
  }
}

}  // namespace halfspace::ref
