// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/gltf/meshes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "ref/scene/gltf/primitive.hpp"

namespace halfspace::ref::gltf {
namespace {

using tinygltf::Primitive;

constexpr std::size_t kMostVertices = std::size_t(1) << 24;

}  // namespace

const MeshParts& Meshes::of(int mesh) {
  const auto [at, is_new] = parts_.try_emplace(mesh);
  if (!is_new) return at->second;
  const tinygltf::Mesh& source = file_.model.meshes[std::size_t(mesh)];
  MeshParts& parts = at->second;
  for (std::size_t i = 0; i < source.primitives.size(); ++i) {
    const std::size_t targets = source.primitives[i].targets.size();
    if (i == 0) parts.targets = targets;
    if (targets != parts.targets) {
      file_.refuse(fmt::format("cannot be read as a mesh (primitives of mesh {} have {} and {} targets)", mesh,
                               parts.targets, targets));
    }
    add(source, source.primitives[i], &parts);
  }
  if (!source.weights.empty() && source.weights.size() != parts.targets) {
    file_.refuse(fmt::format("cannot be read as a mesh (mesh {} has {} weights of {} targets)", mesh,
                             source.weights.size(), parts.targets));
  }
  return parts;
}

void Meshes::add(const tinygltf::Mesh& mesh, const Primitive& primitive, MeshParts* parts) {
  if (primitive.mode == TINYGLTF_MODE_POINTS) return void(++points_);
  if (primitive.mode < TINYGLTF_MODE_TRIANGLES) return void(++lines_);
  if (accessor_of(primitive.attributes, "POSITION") < 0) return void(++without_positions_);
  const char* const draco = "KHR_draco_mesh_compression";
  const int positions = accessor_of(primitive.attributes, "POSITION");
  if (primitive.extensions.count(draco) && !file_.has_view(positions)) {
    throw Error(fmt::format("{}: is compressed by {}, which is not read; export it without", file_.path, draco));
  }
  const Surface& surface = materials_.of(primitive.material);
  if (!surface.is_drawn) return;
  PrimitiveReader reader(&file_, primitive, surface);
  vertices_ += reader.vertices() * (1 + primitive.targets.size());
  if (vertices_ > kMostVertices) {
    file_.refuse(fmt::format("has more than {} vertices; draw it in parts", kMostVertices));
  }
  bool lacks_coordinates = false;
  DocumentMesh out = reader.read(&lacks_coordinates);
  without_coordinates_ += lacks_coordinates;
  out.mesh.name = name_of(mesh.name);
  for (std::size_t i = 0; i < out.targets.size() && i < mesh.weights.size(); ++i)
    out.targets[i].weight = mesh.weights[i];
  for (const JointWeight& weight : out.joint_weights) parts->joints = std::max(parts->joints, int(weight.joint) + 1);
  parts->numbers.push_back(int(file_.document.meshes.size()));
  file_.document.meshes.push_back(std::move(out));
}

void Meshes::say_what_is_left_out() {
  const auto say = [&](std::size_t many, const char* what) {
    if (many != 0) file_.remark(fmt::format("{} {}", many, what));
  };
  say(points_, "primitives of points are left out");
  say(lines_, "primitives of lines are left out");
  say(without_positions_, "primitives without positions are left out");
  if (file_.choice.textured)
    say(without_coordinates_, "primitives lack the coordinates of their texture: drawn without");
}

}  // namespace halfspace::ref::gltf
