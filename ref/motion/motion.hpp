// SPDX-License-Identifier: Apache-2.0
// Motion of the faces of a scene between two key frames, as a frame between them sees it. docs/frames.md has the rules.
#ifndef HALFSPACE_REF_MOTION_MOTION_HPP_
#define HALFSPACE_REF_MOTION_MOTION_HPP_

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "ref/geometry/geometry.hpp"
#include "ref/motion/of_keys.hpp"
#include "ref/scene/scene.hpp"

namespace halfspace::ref {

enum class MotionMethod {
  kStraight,  // a corner goes along the straight line between its places on the screen at the keys
  kExact,     // a corner is where the scene has it at the time between them
};

// Of a face in a key frame, the first that holds.
enum class Standing {
  kBehind,    // all of it is nearer than the near plane, or behind the viewer: it has no place on the screen
  kCrossing,  // a part of it is
  kOutside,   // it is beyond one side of the frame, or the far plane
  kCulled,    // it is one-sided and turns its back
  kDrawn,
};

// A scene at a time: where the corners of its faces are. Faces are numbered from 1 on, as Geometry numbers them, and
// have their corners in its order, counter-clockwise seen from outside.
class FacePlaces {
 public:
  FacePlaces(const Scene&, const View&);

  std::size_t faces() const { return faces_.size(); }
  // A vertex of the mesh of an instance, in clip space.
  const glm::dvec4& clip(std::uint32_t instance, std::uint32_t vertex) const {
    return instances_[instance].positions[vertex];
  }
  std::array<glm::dvec4, 3> clip(std::uint32_t face) const;
  // On the screen; none if a corner is nearer than the near plane.
  std::optional<std::array<Vertex, 3>> screen(std::uint32_t face) const;
  Standing standing(std::uint32_t face) const;
  bool two_sided(std::uint32_t face) const { return instances_[faces_[face - 1].instance].two_sided; }

 private:
  struct Face {
    std::uint32_t instance;
    std::array<std::uint32_t, 3> corner;
  };
  struct Placed {
    bool two_sided;
    std::vector<glm::dvec4> positions;  // of its mesh
  };
  const View view_;
  std::vector<Placed> instances_;
  std::vector<Face> faces_;
};

// Not nearer than the near plane: such a point has a place on the screen.
bool before_viewer(const glm::dvec4& clip);

// What a triangle of the frame between the keys is at them: vertices as that frame has them.
struct Trace {
  std::uint32_t face;                        // of the scene
  bool straight;                             // moved by the straight line
  std::array<double, 3> w;                   // of the vertices in clip space; 1 if straight
  OfKeys<std::array<glm::dvec4, 3>> at_key;  // the same points of the surface in clip space; 0 if straight
  // In pixels; none if one of them is nearer than the near plane.
  OfKeys<std::optional<std::array<glm::dvec2, 3>>> screen;
};

// The frame at fraction `a` of the way from the first key to the second, and what became of its triangles.
struct Between {
  TriangleList list;              // black; in the order of faces
  std::vector<Trace> traces;      // one a triangle
  std::uint32_t fallen_back = 0;  // faces of kStraight that have no line, so that they are at their exact places
};

// `between` is the scene at the time in between; of kExact the list is that of its Geometry. Error when the three
// differ in more than positions, or when nothing is left in the frame.
Between follow(MotionMethod, const Scene& first, const Scene& second, const Scene& between, double a, const View&);

// Vectors from the vertices of a triangle to the same points in a key frame, in pixels: backward (key 0) and forward
// (key 1).
OfKeys<std::optional<std::array<glm::dvec2, 3>>> vectors(const Between&, std::size_t triangle);

// Components are multiples of 2^-fraction_bits in [-2^range_bits, 2^range_bits) pixels.
struct VectorFormat {
  int range_bits, fraction_bits;
};
using FixedVector = std::array<std::int32_t, 2>;  // x, y

// Between the vertices as they are snapped in either frame, rounded half up. A triangle that has a component beyond the
// range at one vertex has no vectors to that key: cut off there, its plane would be wrong everywhere.
OfKeys<std::optional<std::array<FixedVector, 3>>> fixed_vectors(const Between&, std::size_t triangle, int subpixel_bits,
                                                                const VectorFormat&);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_MOTION_MOTION_HPP_
