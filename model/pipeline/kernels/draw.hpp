// SPDX-License-Identifier: Apache-2.0
// Triangles of a frame into the kernels, as geometry sends them.
#ifndef HALFSPACE_MODEL_PIPELINE_KERNELS_DRAW_HPP_
#define HALFSPACE_MODEL_PIPELINE_KERNELS_DRAW_HPP_

#include <algorithm>
#include <vector>

#include "hls/pipeline/pipeline.hpp"
#include "model/motion/motion_records.hpp"
#include "model/pipeline/kernels/triangle_record.hpp"
#include "model/shade/lighting_records.hpp"
#include "model/texture/texture_records.hpp"
#include "ref/error.hpp"
#include "ref/geometry/snap.hpp"
#include "ref/raster/index_pool.hpp"

namespace halfspace::model {

// What a configuration may want of each triangle besides, and how their indices are given where index_pool does not.
struct TriangleAnswers {
  std::vector<RawNormals> normals;
  std::vector<RawCoordinates> coordinates;
  std::vector<RawMotionVectors> vectors;
  std::vector<std::uint32_t> objects;  // none: all are of object 1
  std::vector<std::uint32_t> faces;    // none: all are of face 1
  std::uint32_t window = 0;            // of index reuse
};

// The rule by which triangles get their indices.
template <class F>
ref::IndexReuse index_rule(const TriangleAnswers& answers) {
  return {F::kGivesIndices ? std::uint32_t(F::kIndexWindow) : answers.window, std::uint32_t(F::kTriangles)};
}

template <class F>
Frame<F> frame_registers(const ref::SnappedList& scene) {
  Frame<F> registers;
  registers.width = from_raw<typename F::X>(scene.width);
  registers.height = from_raw<typename F::Y>(scene.height);
  registers.r = from_raw<typename F::Colour>(scene.background[0]);
  registers.g = from_raw<typename F::Colour>(scene.background[1]);
  registers.b = from_raw<typename F::Colour>(scene.background[2]);
  return registers;
}

// Throws ref::Error for objects without a number in the configuration.
template <class F>
void check_objects(const std::vector<std::uint32_t>& objects, std::size_t triangles) {
  const std::uint32_t most = (1u << F::Object::width()) - 1;
  if (!objects.empty() && objects.size() != triangles) {
    throw ref::Error("a frame has another number of triangles than numbers of objects: this is a fault of the program");
  }
  for (const std::uint32_t object : objects) {
    if (object == 0 || object > most)
      throw ref::Error("an object's number does not fit its bits: raise object_bits of the configuration");
  }
}

// Throws ref::Error for a frame that the configuration cannot draw.
template <class F>
void check_frame(const ref::SnappedList& scene, const TriangleAnswers& answers, bool all, Pass pass) {
  const std::size_t count = scene.triangles.size();
  const bool too_many = all && index_rule<F>(answers).window == 0 && count > std::size_t(F::kTriangles);
  if (scene.width > F::kWidth || scene.height > F::kHeight || too_many) {
    throw ref::Error("a frame is larger than the configuration that is to draw it: snap it for that configuration");
  }
  if (F::kHasLighting && !moves<F>(pass) && answers.normals.size() != count) {
    throw ref::Error("the configuration lights triangles, and these came without normals: take one without lights");
  }
  if (F::kHasTexture && !moves<F>(pass) && answers.coordinates.size() != count) {
    throw ref::Error(
        "the configuration draws textures, and the triangles came without coordinates: take one without texture");
  }
  if (moves<F>(pass) && answers.vectors.size() != count) {
    throw ref::Error(
        "the configuration is of frames in between, and the triangles came without motion: take one that shades "
        "them");
  }
  if (F::kHasObjects) check_objects<F>(answers.objects, count);
}

// What geometry answers when triangle k is visible.
template <class F>
void answer(const Visible<F>& done, const TriangleAnswers& answers, std::size_t k, Pass pass, Streams<F>& s) {
  if (!raw(done.visible)) return;
  const int index = int(raw(done.index));
  const bool last = raw(done.last) != 0;
  if (moves<F>(pass)) s.motion_vectors.write(vectors_record<F>(answers.vectors[k], index, last));
  if (moves<F>(pass)) return;
  if (F::kHasLighting) s.normals.write(normals_record<F>(answers.normals[k], index, last));
  if (F::kHasTexture) s.texture_coordinates.write(coordinates_record<F>(answers.coordinates[k], index, last));
}

// As after a reset: a frame was left before its last triangle.
template <class F>
void reset_pool(Streams<F>& s, Buffers<F>& b) {
  while (!s.returned.empty()) s.returned.read();
  b.pool = PoolRegisters<F>{};
}

template <class F>
void send_triangle(const Triangle<F>& t, Streams<F>& s) {
  if (F::kGivesIndices) s.unnumbered.write(UnnumberedTriangle<F>{t});
  else s.triangle.write(t);
}

// Which triangles of a frame are drawn: all, and an Error if indices run out; those as far as there are indices; or all
// that index_pool finds one for.
enum class Drawn { kAll, kFirst, kNumbered };

// Into the buffers. Returns how many were sent.
template <class F>
std::size_t draw(const ref::SnappedList& scene, const TriangleAnswers& answers, Drawn which, Streams<F>& streams,
                 Buffers<F>& buffers, std::vector<bool>* visible, Pass pass = only_pass<F>()) {
  check_frame<F>(scene, answers, which != Drawn::kFirst, pass);
  if (visible) visible->resize(scene.triangles.size());
  const Frame<F> registers = frame_registers<F>(scene);
  const std::size_t count = scene.triangles.size();
  // Of index_pool it is the copy of a host, which knows the results as well.
  ref::IndexPool pool(index_rule<F>(answers));
  for (std::size_t k = 0; k < std::max<std::size_t>(count, 1); ++k) {
    if (which != Drawn::kNumbered && k < count && !pool.has_one()) {
      reset_pool(streams, buffers);
      if (which == Drawn::kFirst) return k;
    }
    Triangle<F> t{};  // none at all, which ends a frame without triangles
    if (k < count) {
      const std::uint32_t index = which == Drawn::kNumbered && F::kGivesIndices ? pool.take_or_none() : pool.take();
      t = triangle_record<F>(scene.triangles[k], index, answers.objects.empty() ? 1 : answers.objects[k]);
    }
    if (F::kUpConverts && k < count) t.face = from_raw<typename F::Face>(answers.faces.empty() ? 1 : answers.faces[k]);
    t.last = from_raw<Bit>(k + 1 >= count);
    send_triangle(t, streams);
    pipeline_triangle(registers, streams, buffers);
    const Visible<F> done = streams.visible.read();
    answer<F>(done, answers, k, pass, streams);
    pipeline_planes(pass, streams, buffers);
    pool.done(std::uint32_t(raw(done.index)), raw(done.visible) != 0);
    if (visible && k < count) (*visible)[k] = raw(done.visible) != 0;
  }
  return count;
}

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_PIPELINE_KERNELS_DRAW_HPP_
