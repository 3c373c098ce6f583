// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/gltf/primitive.hpp"

#include <fmt/format.h>

#include "ref/scene/normals.hpp"

namespace halfspace::ref::gltf {
namespace {

using tinygltf::Primitive;

constexpr double kEdge = 1e-4;  // of a picture, that coordinates miss 0 and 1 by without leaving it

}  // namespace

int accessor_of(const std::map<std::string, int>& attributes, const std::string& name) {
  const auto found = attributes.find(name);
  return found == attributes.end() ? -1 : found->second;
}

Attribute::Attribute(const File& file, int number, const std::string& name, const Corners& corners, std::size_t count,
                     std::initializer_list<int> components)
    : accessor_(file, number, name, components), corners_(corners) {
  if (accessor_.count() == count) return;
  accessor_.refuse(fmt::format("has {} elements beside {} positions", accessor_.count(), count));
}

std::vector<glm::dvec3> Attribute::all() const {
  std::vector<glm::dvec3> values;
  values.reserve(corners_.vertices.size());
  for (std::size_t v = 0; v < corners_.vertices.size(); ++v) values.push_back(vec3(v));
  return values;
}

PrimitiveReader::PrimitiveReader(File* file, const Primitive& primitive, const Surface& surface)
    : file_(*file), primitive_(primitive), surface_(surface) {
  const int positions = accessor_of(primitive.attributes, "POSITION");
  const Accessor accessor(file_, positions, "POSITION", {3});
  count_ = accessor.count();
  corners_ = corners_of(file_, primitive, count_);
}

DocumentMesh PrimitiveReader::read(bool* lacks_coordinates) {
  out_.mesh.material = surface_.material;
  out_.mesh.positions = named("POSITION", {3})->all();
  if (const auto normals = named("NORMAL", {3})) out_.mesh.normals = normals->all();
  out_.is_flat = out_.mesh.normals.empty();
  read_colours();
  read_coordinates(lacks_coordinates);
  read_joints();
  for (const auto& target : primitive_.targets) read_target(target);
  out_.mesh.triangles = std::move(corners_.triangles);
  if (out_.is_flat) {
    out_.mesh.normals.assign(vertices(), glm::dvec3(0, 1, 0));
    split_vertices(&out_);
  } else {
    mend_normals(&out_.mesh);
  }
  return std::move(out_);
}

std::optional<Attribute> PrimitiveReader::of(const std::map<std::string, int>& attributes, const std::string& name,
                                             std::initializer_list<int> components) const {
  const int number = accessor_of(attributes, name);
  if (number < 0) return std::nullopt;
  return std::optional<Attribute>(std::in_place, file_, number, name, corners_, count_, components);
}

void PrimitiveReader::read_colours() {
  const auto colours = named("COLOR_0", {3, 4});
  if (!colours) return;
  bool is_opaque = true;
  for (std::size_t v = 0; v < vertices(); ++v) {
    out_.mesh.colours.push_back(glm::clamp(colours->vec3(v), 0.0, 1.0));
    is_opaque = is_opaque && (colours->accessor().components() == 3 || colours->at(v, 3) >= 1);
  }
  if (surface_.has_alpha && !is_opaque) file_.remark("vertices that alpha lets shine through are drawn opaque");
}

void PrimitiveReader::read_coordinates(bool* lacks) {
  if (surface_.coordinates < 0) return;
  const auto coordinates = named(fmt::format("TEXCOORD_{}", surface_.coordinates), {2});
  if (!coordinates) {
    *lacks = true;
    return;
  }
  bool leaves = false;
  for (std::size_t v = 0; v < vertices(); ++v) {
    const glm::dvec2 uv = surface_.placed * glm::dvec3(coordinates->at(v, 0), coordinates->at(v, 1), 1);
    leaves = leaves || glm::clamp(uv, -kEdge, 1 + kEdge) != uv;
    out_.mesh.texture_coordinates.push_back(uv);
  }
  if (leaves && !surface_.repeats && file_.choice.textured) {
    file_.remark("textures that clamp or mirror at their edges are drawn as repeated");
  }
}

void PrimitiveReader::read_joints() {
  for (int set = 0;; ++set) {
    const auto joints = named(fmt::format("JOINTS_{}", set), {4}), weights = named(fmt::format("WEIGHTS_{}", set), {4});
    if (!joints || !weights) return;
    if (!joints->accessor().is_unsigned()) joints->accessor().refuse("is not of unsigned numbers");
    for (std::size_t v = 0; v < vertices(); ++v) {
      for (int i = 0; i < 4; ++i) {
        const double weight = weights->at(v, i), joint = joints->at(v, i);
        if (weight < 0) weights->accessor().refuse("has a weight below 0");
        if (joint > 65535) joints->accessor().refuse(fmt::format("has joint {}", joint));
        if (weight > 0) out_.joint_weights.push_back({std::uint32_t(v), std::uint32_t(joint), weight});
      }
    }
  }
}

void PrimitiveReader::read_target(const std::map<std::string, int>& attributes) {
  MorphTarget& target = out_.targets.emplace_back();
  if (const auto positions = of(attributes, "POSITION", {3})) target.positions = positions->all();
  if (out_.is_flat) return;
  if (const auto normals = of(attributes, "NORMAL", {3})) target.normals = normals->all();
}

}  // namespace halfspace::ref::gltf
