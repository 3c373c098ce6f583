// SPDX-License-Identifier: Apache-2.0
#include "ref/objects/static_objects.hpp"

#include <algorithm>

namespace halfspace::ref {
namespace {

bool same(const ObjectPixel& a, const ObjectPixel& b) { return a.key == b.key && a.triangle == b.triangle; }

}  // namespace

StaticObjects::StaticObjects(const Scene& scene, const RasterFormat& format, int width, int height,
                             const StaticOptions& options)
    : scene_(scene),
      options_(options),
      states_(scene, double(width) / height, options.buffers, options.object_bits),
      raster_(scene, format, width, height),
      shader_(scene, format, raster_.view()),
      static_(std::size_t(options.buffers), ObjectBuffer(width, height, full_depth(format.depth_bits))),
      still_(width, height, full_depth(format.depth_bits)),
      dynamic_(still_),
      picture_(still_) {
  compose(still_.frame());
}

const FrameWork& StaticObjects::draw(const DrawSink& sink) {
  work_ = {};
  changed_ = {};
  shader_.forget();
  find_states();

  std::vector<std::vector<Box>> holes(static_.size());
  for (std::uint32_t n = 0; n < states_.objects(); ++n) {
    if (states_.has_to_leave(n)) leave(n, holes[buffer_of(n)]);
  }
  std::vector<bool> drawn_into(static_.size(), false);
  for (std::size_t k = 0; k < static_.size(); ++k) {
    const std::uint64_t before = work_.redrawn;
    fill(int(k), holes[k], sink);
    drawn_into[k] = work_.redrawn != before;
  }

  dynamic_.clear(moving_box_.cut(dynamic_.frame()));
  moving_box_ = {};
  for (std::uint32_t n = 0; n < states_.objects(); ++n) {
    if (state(n) == ObjectState::kSS) continue;
    const bool stops = state(n) == ObjectState::kDS;
    if (sink) sink(n);
    const Drawn drawn = raster_.draw(n, stops ? static_[buffer_of(n)] : dynamic_, dynamic_.frame());
    work_.triangles += drawn.triangles;
    if (stops) states_.stay(n, drawn.box);
    ++(stops ? work_.added : work_.moving);
    if (stops) drawn_into[std::size_t(buffer_of(n))] = true;
    (stops ? changed_ : moving_box_).add(drawn.box);
  }
  work_.drawn_into = std::uint64_t(std::count(drawn_into.begin(), drawn_into.end(), true));
  if (!changed_.empty()) compose(changed_);
  merge();
  return work_;
}

void StaticObjects::find_states() {
  states_.step();
  work_.new_view = states_.new_view();
  if (work_.new_view) {
    raster_.look_from(states_.viewpoint());
    shader_.look_from(states_.viewpoint());
    for (ObjectBuffer& buffer : static_) buffer.clear(buffer.frame());
    changed_ = still_.frame();
    return;
  }
  for (std::uint32_t n = 0; n < states_.objects(); ++n) work_.started += state(n) == ObjectState::kSD;
}

// Takes an object that starts to move out of its S-buffer. Pixels that have to be drawn again are put into `holes`.
void StaticObjects::leave(std::uint32_t instance, std::vector<Box>& holes) {
  states_.leave(instance);
  const Box& covered = states_.box(instance);
  ObjectBuffer& buffer = static_[buffer_of(instance)];
  if (options_.query) {
    ++work_.queries;
    work_.searched += covered.pixels();
    if (options_.query(buffer, instance + 1, covered) == 0) {
      ++work_.skipped;
      return;
    }
  }
  work_.searched += covered.pixels();
  const Box erased = buffer.erase(instance + 1, covered);
  const Box hole = options_.query ? erased : covered;
  if (!hole.empty()) holes.push_back(hole);
}

// Draws again what overlaps the holes of S-buffer k, an object once.
void StaticObjects::fill(int k, const std::vector<Box>& holes, const DrawSink& sink) {
  for (const Box& hole : holes) changed_.add(hole);
  states_.over(k, holes, [&](std::uint32_t n, const Box& region) {
    if (sink) sink(n);
    work_.triangles += raster_.draw(n, static_[k], region).triangles;
    ++work_.redrawn;
  });
}

// The S-buffers merged. What shows the same triangle as before keeps its colour: an object that has moved in between
// was erased in between.
void StaticObjects::compose(const Box& box) {
  for (int y = box.y0; y < box.y1; ++y) {
    for (int x = box.x0; x < box.x1; ++x) {
      const ObjectPixel* nearest = &static_[0].at(x, y);
      for (std::size_t k = 1; k < static_.size(); ++k) {
        if (static_[k].at(x, y).key < nearest->key) nearest = &static_[k].at(x, y);
      }
      ObjectPixel& pixel = still_.at(x, y);
      if (work_.new_view || !same(pixel, *nearest)) pixel = *nearest;
    }
  }
  work_.composed += box.pixels();
}

// Pixels that the D-buffer does not reach keep the colour that they get here.
void StaticObjects::merge() {
  for (int y = 0; y < picture_.height(); ++y) {
    for (int x = 0; x < picture_.width(); ++x) {
      ObjectPixel& still = still_.at(x, y);
      const ObjectPixel& moving = dynamic_.at(x, y);
      ObjectPixel& pixel = picture_.at(x, y);
      if (moving.key < still.key) {
        pixel = moving;
        shader_.shade(pixel, x, y);
      } else {
        shader_.shade(still, x, y);
        pixel = still;
      }
    }
  }
}

AllObjects::AllObjects(const Scene& scene, const RasterFormat& format, int width, int height)
    : scene_(scene),
      raster_(scene, format, width, height),
      shader_(scene, format, raster_.view()),
      picture_(width, height, full_depth(format.depth_bits)) {}

const FrameWork& AllObjects::draw(const std::function<void(std::size_t done)>& progress) {
  work_ = {};
  const Viewpoint from = viewpoint(scene_, double(picture_.width()) / picture_.height());
  raster_.look_from(from);
  shader_.look_from(from);
  picture_.clear(picture_.frame());
  for (std::uint32_t n = 0; n < scene_.instances.size(); ++n) {
    work_.triangles += raster_.draw(n, picture_, picture_.frame()).triangles;
    ++work_.moving;
    if (progress) progress(n + 1);
  }
  for (int y = 0; y < picture_.height(); ++y) {
    for (int x = 0; x < picture_.width(); ++x) shader_.shade(picture_.at(x, y), x, y);
  }
  return work_;
}

}  // namespace halfspace::ref
