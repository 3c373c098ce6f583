// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/check_document.hpp"

#include <fmt/format.h>

#include <cmath>

#include "ref/error.hpp"

namespace halfspace::ref {
namespace {

constexpr std::size_t kMostNodes = std::size_t(1) << 20;
constexpr std::size_t kMostTriangles = std::size_t(1) << 24;  // drawn: a mesh counts as often as it is placed
constexpr std::size_t kMostTexels = std::size_t(1) << 28;     // of all textures together

template <class V>
bool finite(const V& v) {
  for (int i = 0; i < V::length(); ++i) {
    if (!std::isfinite(v[i])) return false;
  }
  return true;
}
bool finite(const glm::dmat4& m) { return finite(m[0]) && finite(m[1]) && finite(m[2]) && finite(m[3]); }

bool within(int number, std::size_t size) { return number >= 0 && std::size_t(number) < size; }
bool within_or_none(int number, std::size_t size) { return number == -1 || within(number, size); }

class Checker {
 public:
  explicit Checker(const Document& document) : d_(document) {}

  void run() const {
    nodes();
    for (const DocumentMesh& mesh : d_.meshes) this->mesh(mesh);
    for (const Skin& skin : d_.skins) {
      for (const Joint& joint : skin) {
        expect(within_or_none(joint.node, d_.nodes.size()), "a skin has a joint that is no node");
        expect(finite(joint.from_mesh), "a joint's matrix has NaN or infinity");
      }
    }
    for (const Animation& animation : d_.animations) {
      for (const Channel& channel : animation.channels) this->channel(animation, channel);
    }
    for (const DocumentCamera& camera : d_.cameras)
      expect(within_or_none(camera.node, d_.nodes.size()), "a camera stands at a node that is not there");
    for (const DocumentLight& light : d_.lights)
      expect(within_or_none(light.node, d_.nodes.size()), "a light stands at a node that is not there");
    for (const Material& material : d_.materials)
      expect(within_or_none(material.texture, d_.textures.size()), "a material has a texture that is not there");
    textures();
  }

 private:
  void expect(bool holds, const std::string& what) const {
    if (!holds) throw Error(fmt::format("{}: {}; export the file again", d_.name, what));
  }

  void nodes() const {
    expect(d_.nodes.size() <= kMostNodes, fmt::format("{} nodes, and {} are the most", d_.nodes.size(), kMostNodes));
    std::size_t triangles = 0;
    for (std::size_t n = 0; n < d_.nodes.size(); ++n) {
      const Node& node = d_.nodes[n];
      expect(node.parent == -1 || within(node.parent, n), "a node comes before its parent");
      expect(within_or_none(node.skin, d_.skins.size()), "a node has a skin that is not there");
      if (!finite(node.matrix) || !finite(node.translation) || !finite(node.scale))
        expect(false, fmt::format("node '{}' is placed by NaN or infinity", node.name));
      for (const int mesh : node.meshes) {
        expect(within(mesh, d_.meshes.size()), "a node has a mesh that is not there");
        triangles += d_.meshes[mesh].mesh.triangles.size();
        placed(node, d_.meshes[mesh]);
      }
    }
    expect(triangles <= kMostTriangles,
           fmt::format("{} triangles are drawn in it, and {} are the most", triangles, kMostTriangles));
  }

  void placed(const Node& node, const DocumentMesh& mesh) const {
    const int skin = node.skin >= 0 ? node.skin : mesh.skin;
    if (skin < 0) return;
    expect(within(skin, d_.skins.size()), "a mesh has a skin that is not there");
    for (const JointWeight& weight : mesh.joint_weights) {
      if (weight.joint >= d_.skins[skin].size())
        expect(false, fmt::format("mesh '{}': its skin has no joint {}", mesh.mesh.name, weight.joint));
    }
  }

  void mesh(const DocumentMesh& source) const {
    const Mesh& m = source.mesh;
    const std::size_t count = m.positions.size();
    const auto one_each = [&](std::size_t size) { return size == 0 || size == count; };
    if (m.normals.size() != count && !(source.is_flat && m.normals.empty()))
      expect(false, fmt::format("mesh '{}' has {} normals for {} vertices", m.name, m.normals.size(), count));
    if (!one_each(m.colours.size()) || !one_each(m.texture_coordinates.size()))
      expect(false, fmt::format("mesh '{}' has colours or coordinates for some of its vertices alone", m.name));
    for (std::size_t i = 0; i < count; ++i) {
      if (!finite(m.positions[i]) || (!m.normals.empty() && !finite(m.normals[i])) ||
          (!m.colours.empty() && !finite(m.colours[i]))) {
        throw Error(
            fmt::format("{}: mesh '{}', vertex {}: a coordinate is NaN or infinite; export the file again without it",
                        d_.name, m.name, i));
      }
      if (!m.texture_coordinates.empty() && !finite(m.texture_coordinates[i])) {
        throw Error(fmt::format(
            "{}: mesh '{}', vertex {}: a texture coordinate is NaN or infinite; export the file again without it",
            d_.name, m.name, i));
      }
    }
    for (std::size_t t = 0; t < m.triangles.size(); ++t) {
      for (const std::uint32_t i : m.triangles[t]) {
        if (i >= count)
          expect(false, fmt::format("mesh '{}', face {}: index {} is beyond its {} vertices", m.name, t, i, count));
      }
    }
    for (const MorphTarget& target : source.targets) {
      expect(one_each(target.positions.size()) && one_each(target.normals.size()),
             "a morph target moves some of its mesh's vertices alone");
      for (const auto* values : {&target.positions, &target.normals}) {
        for (const glm::dvec3& v : *values) expect(finite(v), "a morph target has NaN or infinity");
      }
    }
    for (const JointWeight& weight : source.joint_weights) {
      if (weight.vertex >= count || !std::isfinite(weight.weight))
        expect(false, fmt::format("mesh '{}' has weights of a joint that are no numbers or of no vertex", m.name));
    }
  }

  void channel(const Animation& animation, const Channel& c) const {
    const auto holds = [&](bool fact) {
      if (!fact) expect(false, fmt::format("animation '{}' has keys that do not belong together", animation.name));
    };
    holds(within(c.node, d_.nodes.size()) && !c.times.empty());
    const std::size_t parts = c.interpolation == Interpolation::kCubic ? 3 : 1, keys = c.times.size() * parts;
    const std::size_t width = c.path == ChannelPath::kRotation ? 4 : 3;
    holds(c.path == ChannelPath::kWeights ? c.values.size() % keys == 0 : c.values.size() == keys * width);
    for (std::size_t i = 0; i < c.times.size(); ++i)
      holds(std::isfinite(c.times[i]) && (i == 0 || c.times[i - 1] <= c.times[i]));
    for (const double value : c.values) holds(std::isfinite(value));
    holds(std::isfinite(animation.duration));
  }

  void textures() const {
    std::size_t texels = 0;
    for (const Texture& t : d_.textures) {
      expect(t.width > 0 && t.height > 0 && t.texels.size() == std::size_t(t.width) * std::size_t(t.height),
             fmt::format("texture '{}' is not whole", t.name));
      texels += t.texels.size();
    }
    expect(texels <= kMostTexels, fmt::format("{} texels in its textures, and {} are the most", texels, kMostTexels));
  }

  const Document& d_;
};

}  // namespace

void check_document(const Document& document) { Checker(document).run(); }

}  // namespace halfspace::ref
