// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_SCENE_GLTF_PRIMITIVE_HPP_
#define HALFSPACE_REF_SCENE_GLTF_PRIMITIVE_HPP_

#include <initializer_list>
#include <map>
#include <optional>
#include <string>

#include "ref/scene/gltf/corners.hpp"
#include "ref/scene/gltf/file/accessor.hpp"
#include "ref/scene/gltf/materials.hpp"

namespace halfspace::ref::gltf {

// −1: there is none of that name.
int accessor_of(const std::map<std::string, int>& attributes, const std::string& name);

// An accessor of a primitive, for the vertices that it uses.
class Attribute {
 public:
  Attribute(const File&, int number, const std::string& name, const Corners&, std::size_t count,
            std::initializer_list<int> components);
  const Accessor& accessor() const { return accessor_; }
  double at(std::size_t vertex, int component) const { return accessor_.at(corners_.vertices[vertex], component); }
  glm::dvec3 vec3(std::size_t vertex) const { return {at(vertex, 0), at(vertex, 1), at(vertex, 2)}; }
  std::vector<glm::dvec3> all() const;

 private:
  const Accessor accessor_;
  const Corners& corners_;
};

// A primitive of triangles, strips or fans.
class PrimitiveReader {
 public:
  PrimitiveReader(File*, const tinygltf::Primitive&, const Surface&);

  std::size_t vertices() const { return corners_.vertices.size(); }
  DocumentMesh read(bool* lacks_coordinates);

 private:
  std::optional<Attribute> of(const std::map<std::string, int>& attributes, const std::string& name,
                              std::initializer_list<int> components) const;
  std::optional<Attribute> named(const std::string& name, std::initializer_list<int> components) const {
    return of(primitive_.attributes, name, components);
  }
  void read_colours();
  void read_coordinates(bool* lacks);
  void read_joints();
  void read_target(const std::map<std::string, int>& attributes);

  File& file_;
  const tinygltf::Primitive& primitive_;
  const Surface& surface_;
  std::size_t count_ = 0;
  Corners corners_;
  DocumentMesh out_;
};

}  // namespace halfspace::ref::gltf

#endif  // HALFSPACE_REF_SCENE_GLTF_PRIMITIVE_HPP_
