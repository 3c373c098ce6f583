// SPDX-License-Identifier: Apache-2.0
// Static objects buffers: what stands still is drawn once into S-buffers, what moves each frame into the D-buffer,
// and the frame is the nearer of both. docs/static.md has the rules, and why the frame is that of drawing everything.
#ifndef HALFSPACE_REF_OBJECTS_STATIC_OBJECTS_HPP_
#define HALFSPACE_REF_OBJECTS_STATIC_OBJECTS_HPP_

#include <cstdint>
#include <functional>
#include <vector>

#include "ref/objects/object_buffer.hpp"
#include "ref/objects/object_raster.hpp"
#include "ref/objects/object_shader.hpp"
#include "ref/objects/object_states.hpp"
#include "ref/scene/scene.hpp"

namespace halfspace::ref {

// How many pixels of an S-buffer show an object; all of them are in the box.
using OcclusionQuery = std::function<std::uint64_t(const ObjectBuffer& buffer, std::uint32_t object, const Box& box)>;
inline std::uint64_t visible_pixels(const ObjectBuffer& buffer, std::uint32_t object, const Box& box) {
  return buffer.count(object, box);
}

struct StaticOptions {
  int buffers = 1;       // S-buffers; instance n is in number n mod buffers while it stands still
  int object_bits = 32;  // of the number of an object in a pixel; 0 is the background
  // Asked for an object that starts to move; 0: its S-buffer stays as it is. Without a query each update is done, in
  // the whole box of the object; with it in the box of the pixels that are seen.
  OcclusionQuery query;
};

// What a frame took.
struct FrameWork {
  bool new_view = false;                             // all is dynamic, and the S-buffers are empty
  std::uint64_t moving = 0, added = 0, redrawn = 0;  // objects drawn: SD and DD; DS; others of an S-buffer, for an SD
  std::uint64_t started = 0, queries = 0, skipped = 0;  // SD, seen from where the last frame was; asked; skipped
  std::uint64_t triangles = 0;                          // of the objects drawn, handed to the rasterizer
  std::uint64_t composed = 0;                           // pixels that were merged anew of all S-buffers
  std::uint64_t searched = 0;    // pixels of S-buffers in which an object was asked for, or erased
  std::uint64_t drawn_into = 0;  // S-buffers into which objects were drawn
  std::uint64_t drawn() const { return moving + added + redrawn; }
};

// Told of each object that is drawn.
using DrawSink = std::function<void(std::uint32_t instance)>;

class StaticObjects {
 public:
  // The scene as it stands in the frame before the first; it outlives this, and its instances move between two
  // frames. In that frame all objects are dynamic. Error for less than one S-buffer, for more objects than there are
  // numbers, and for a format without depth.
  StaticObjects(const Scene&, const RasterFormat&, int width, int height, const StaticOptions&);

  // The scene as it stands now, from where it is looked at now.
  const FrameWork& draw(const DrawSink& sink = {});
  // Other lights, materials or meshes: the next frame begins as after a movement of the viewpoint.
  void start_anew() { states_.start_anew(); }

  const ObjectBuffer& picture() const { return picture_; }
  ObjectState state(std::uint32_t instance) const { return states_.state(instance); }
  const ObjectBuffer& static_buffer(int k) const { return static_[k]; }
  int buffers() const { return states_.buffers(); }
  int buffer_of(std::uint32_t instance) const { return states_.buffer_of(instance); }
  bool is_static(std::uint32_t instance) const { return states_.is_static(instance); }
  ObjectRaster& raster() { return raster_; }

 private:
  void find_states();
  void leave(std::uint32_t instance, std::vector<Box>& holes);
  void fill(int k, const std::vector<Box>& holes, const DrawSink&);
  void compose(const Box&);
  void merge();

  const Scene& scene_;
  const StaticOptions options_;
  ObjectStates states_;
  ObjectRaster raster_;
  ObjectShader shader_;
  std::vector<ObjectBuffer> static_;
  ObjectBuffer still_;    // all S-buffers merged, with colours
  ObjectBuffer dynamic_;  // the D-buffer
  ObjectBuffer picture_;
  Box changed_, moving_box_;  // of the S-buffers in this frame; of the D-buffer
  FrameWork work_;
};

// Everything drawn, in order: what the picture of StaticObjects has to be.
class AllObjects {
 public:
  AllObjects(const Scene&, const RasterFormat&, int width, int height);
  const FrameWork& draw(const std::function<void(std::size_t done)>& progress = {});
  const ObjectBuffer& picture() const { return picture_; }

 private:
  const Scene& scene_;
  ObjectRaster raster_;
  ObjectShader shader_;
  ObjectBuffer picture_;
  FrameWork work_;
};

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_OBJECTS_STATIC_OBJECTS_HPP_
