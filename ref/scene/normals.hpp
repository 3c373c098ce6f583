// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_SCENE_NORMALS_HPP_
#define HALFSPACE_REF_SCENE_NORMALS_HPP_

#include <glm/glm.hpp>

#include "ref/scene/document.hpp"

namespace halfspace::ref {

// Turns normals as `to_world` turns the surface, but for their length: the cofactors, which are right under any
// scale, of mirrors too, and need no inverse.
glm::dmat3 normal_matrix(const glm::dmat4& to_world);

// Each corner of a triangle becomes a vertex of its own, with all that the old one has.
void split_vertices(DocumentMesh*);

// Normals of faces: each corner has that of its triangle. The vertices have been split.
void make_flat(Mesh*);

// Normals of a mesh that has none. A corner has the mean of the normals of the faces that meet at its place, weighted
// by their angles there; a face that is turned by more than the crease from its own counts for nothing. The vertices
// are split.
void make_smooth(DocumentMesh*, double crease_degrees);

// A normal that is zero or NaN becomes that of a face at the vertex; all have length 1 then.
void mend_normals(Mesh*);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_SCENE_NORMALS_HPP_
