// SPDX-License-Identifier: Apache-2.0
// What a scene file says, before a time, an animation and a camera are chosen: what its reader makes of it, and what
// scene_at() takes. Everything is named by number; names are for people alone, and need not differ.
#ifndef HALFSPACE_REF_SCENE_DOCUMENT_HPP_
#define HALFSPACE_REF_SCENE_DOCUMENT_HPP_

#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ref/scene/scene.hpp"

namespace halfspace::ref {

// What a mesh is moved by: v + Σ weight · difference.
struct MorphTarget {
  std::vector<glm::dvec3> positions, normals;  // differences, one a vertex, or none at all
  double weight = 0;                           // where neither node nor animation says another
};

struct JointWeight {
  std::uint32_t vertex, joint;  // joint: in its Skin
  double weight;
};

struct DocumentMesh {
  Mesh mesh;
  bool is_flat =
      false;  // normals are to be made from the faces as they are posed, one a face; its own count for nothing
  std::vector<MorphTarget> targets;
  std::vector<JointWeight> joint_weights;  // those of a vertex are divided by their sum; none: moved with its node
  int skin = -1;                           // of its own, where the format has one for each mesh
};

struct Joint {
  int node;
  glm::dmat4 from_mesh;  // into the joint's own space, as it was bound
};
using Skin = std::vector<Joint>;

struct Node {
  std::string name;
  int parent = -1;  // a smaller number, or −1
  glm::dmat4 matrix{1};
  // The same in parts, which an animation replaces one by one: translation · rotation · scale.
  glm::dvec3 translation{0}, scale{1};
  glm::dquat rotation{1, 0, 0, 0};
  std::vector<int> meshes;
  int skin = -1;                // −1: that of the mesh, if any
  std::vector<double> weights;  // of the targets of its meshes; none: those of the targets
};

enum class Interpolation { kStep, kLinear, kCubic };
enum class ChannelPath { kTranslation, kRotation, kScale, kWeights };

// Keys of one part of a node. `values` has 3 a key, 4 of a rotation (x, y, z, w), or as many as there are targets; and
// three times that of a cubic one: tangent in, value, tangent out.
struct Channel {
  int node = 0;
  ChannelPath path = ChannelPath::kTranslation;
  Interpolation interpolation = Interpolation::kLinear;
  std::vector<double> times;  // seconds, not falling
  std::vector<double> values;
};

struct Animation {
  std::string name;
  double duration = 0;  // seconds; it is held at its ends outside
  std::vector<Channel> channels;
};

// Places and directions are those of the node.
struct DocumentCamera {
  std::string name;
  int node = -1;  // −1: those of the world
  Camera camera;
  bool is_doubtful = false;  // its reader may have turned it the wrong way: it counts if it has anything in view
};
struct DocumentLight {
  int node = -1;
  Light light;
};

struct Document {
  std::string name;         // the path
  std::vector<Node> nodes;  // parents before children, in the order in which they are drawn
  std::vector<DocumentMesh> meshes;
  std::vector<Skin> skins;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<Animation> animations;
  std::vector<DocumentCamera> cameras;
  std::vector<DocumentLight> lights;
  std::optional<glm::dvec3> ambient;
  std::vector<std::string> remarks;  // a sentence for each kind of thing that is not drawn as the file says
};

struct ReadChoice {
  bool textured = false;
};

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_SCENE_DOCUMENT_HPP_
