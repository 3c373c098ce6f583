// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_SCENE_SCENE_HPP_
#define HALFSPACE_REF_SCENE_SCENE_HPP_

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ref/scene/texture.hpp"

namespace halfspace::ref {

// Coefficients of the Phong model, 0-1 a channel.
struct Material {
  glm::dvec3 ambient{0.8}, diffuse{0.8}, specular{0}, emission{0};  // Ka, Kd, Ks
  double shininess = 0;                                             // n
  bool two_sided = false;                                           // drawn from behind as well
  bool unlit = false;                                               // its colour is Kd, whatever light there is
  int texture = -1;                                                 // its colour multiplies what is lit; −1: none
};

// Triangles are counter-clockwise seen from outside.
struct Mesh {
  std::string name;
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> normals;              // one a position, of length 1
  std::vector<glm::dvec3> colours;              // one a position, or none at all; they multiply Ka and Kd
  std::vector<glm::dvec2> texture_coordinates;  // (u, v), one a position, or none at all
  std::vector<std::array<std::uint32_t, 3>> triangles;
  int material = 0;
};

// A mesh, placed. Meshes that are instanced stand once.
struct Instance {
  int mesh;
  glm::dmat4 to_world;
};

struct Light {
  enum class Kind { kDirectional, kPoint, kSpot };
  Kind kind = Kind::kDirectional;
  glm::dvec3 position{0}, direction{0, 0, -1};  // direction: the way the light goes, of length 1
  glm::dvec3 colour{1};                         // Ii
  glm::dvec3 attenuation{1, 0, 0};              // Ii / (a + b d + c d²) at distance d
  double cos_inner = 1, cos_outer = 1;          // of half the cone of a spot
};

struct Camera {
  glm::dvec3 position{0}, forward{0, 0, -1}, up{0, 1, 0};
  double half_width = 0;   // of the view at distance 1, or at any distance if orthographic; 0: not known
  double half_height = 0;  // likewise; if both are known the height counts, as the frame has its own aspect
  bool orthographic = false;
  double near = 0, far = 0;  // 0: taken from the geometry
};

// Distances from the eye at which depth is 0 and 1.
struct DepthPlanes {
  double near, far;
};

struct Scene {
  std::string name;
  std::vector<Mesh> meshes;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<Instance> instances;
  std::vector<Light> lights;          // none: one from the upper left behind the viewer
  glm::dvec3 ambient{0.32};           // Ia
  glm::dvec3 background{26, 32, 46};  // 0-255
  std::optional<Camera> camera;
  // Without a camera the scene is looked at along `view_direction`, from so far that all `framing` points are
  // seen. They are those of time 0: the view stays when the scene moves.
  glm::dvec3 view_direction{-0.5, -0.45, -0.75};
  std::vector<glm::dvec3> framing;
  // Held over the frames of an animation, so that depths of its times compare; else they follow the geometry at hand.
  std::optional<DepthPlanes> depth_planes;
  double duration = 0;               // seconds of the animation; 0 when the scene stands still
  std::vector<std::string> remarks;  // a sentence for each kind of thing that is not as its file says
};

// What of a scene is drawn.
struct SceneChoice {
  bool textured = false;    // textures are read; one that is missing is an error then
  std::string animation{};  // by name, or by number from 0 on; empty: the first, with a remark where there are more
  std::string camera{};     // likewise; empty: the first; "auto": all of the scene is framed
  bool two_sided = false;   // all faces are seen from behind as well
  bool trust = false;       // the file is read in this process: a little faster, and what brings its reader down brings
                            // this program down
};

struct Document;

// A built-in scene by its name, or a file: glTF, or any that Assimp reads, with its animation (nodes, bones and morph
// targets); of the built-in scenes the animated ones move. The file is read once, whatever the times.
class SceneSource {
 public:
  // Error on what cannot be read.
  explicit SceneSource(const std::string& name_or_path, const SceneChoice& = {});
  // Error on everything that cannot be drawn.
  Scene at(double seconds) const;

 private:
  std::string name_;
  SceneChoice choice_;
  std::shared_ptr<const Document> document_;  // null: built in
  std::vector<glm::dvec3> framing_;
};

inline Scene load_scene(const std::string& name_or_path, double time_seconds = 0, const SceneChoice& choice = {}) {
  return SceneSource(name_or_path, choice).at(time_seconds);
}

std::vector<std::string> builtin_scene_names();   // that stand still
std::vector<std::string> animated_scene_names();  // built in as well

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_SCENE_SCENE_HPP_
