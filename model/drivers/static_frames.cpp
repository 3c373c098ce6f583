// SPDX-License-Identifier: Apache-2.0
#include "model/drivers/static_frames.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "model/formats/stamps.hpp"
#include "model/shade/frame_lighting.hpp"
#include "model/texture/texture.hpp"
#include "ref/objects/object_raster.hpp"

namespace halfspace::model {
namespace {

using ref::Box;
using ref::ObjectState;

bool same(const LightingFrame& a, const LightingFrame& b) {
  const auto same_reflection = [](const RawReflection& x, const RawReflection& y) {
    return x.base == y.base && x.diffuse == y.diffuse && x.specular == y.specular;
  };
  const auto same_material = [&](const RawMaterial& x, const RawMaterial& y) {
    return x.gloss == y.gloss && std::equal(x.reflections.begin(), x.reflections.end(), y.reflections.begin(),
                                            y.reflections.end(), same_reflection);
  };
  const auto same_light = [](const RawLight& x, const RawLight& y) {
    return x.to_light == y.to_light && x.half == y.half;
  };
  return std::equal(a.lights.begin(), a.lights.end(), b.lights.begin(), b.lights.end(), same_light) &&
         std::equal(a.materials.begin(), a.materials.end(), b.materials.begin(), b.materials.end(), same_material);
}

// Triangles [from, to) of a frame.
template <class T>
void cut(std::vector<T>& of_triangles, std::size_t from, std::size_t to) {
  if (of_triangles.empty()) return;
  of_triangles.erase(of_triangles.begin() + long(to), of_triangles.end());
  of_triangles.erase(of_triangles.begin(), of_triangles.begin() + long(from));
}
NamedFrame part(const NamedFrame& frame, std::size_t from, std::size_t to) {
  NamedFrame out = frame;
  cut(out.scene.triangles, from, to), cut(out.objects, from, to);
  cut(out.lighting.triangles, from, to), cut(out.texture.triangles, from, to);
  return out;
}

Box covered(const NamedFrame& frame, std::size_t k) {
  return ref::pixel_box(frame.scene.triangles[k], frame.scene.format.subpixel_bits, frame.scene.width,
                        frame.scene.height);
}

}  // namespace

StaticFrames::StaticFrames(const ref::Scene& scene, const StaticFramesOptions& options)
    : scene_(scene),
      options_(options),
      config_(options.configuration.config()),
      frame_{0, 0, options.width, options.height},
      engine_(make_engine(options.configuration, options.lanes)),
      merger_(options.configuration, options.lanes),
      states_(scene, double(options.width) / options.height, options.buffers, config_.object_bits),
      static_(std::size_t(options.buffers), std::vector<RawEntry>(std::size_t(options.width) * options.height)),
      filled_(std::size_t(options.buffers)) {
  engine_->reuse_indices(options.window);
}

const StaticFrameWork& StaticFrames::draw(const StaticFramesSink& sink) {
  work_ = {};
  changed_ = {};
  sink_ = &sink;
  look();
  states_.step();
  work_.new_view = states_.new_view();
  if (work_.new_view) filled_.assign(filled_.size(), false);

  std::vector<std::vector<Box>> holes(static_.size());
  for (std::uint32_t n = 0; n < states_.objects(); ++n) {
    work_.started += !work_.new_view && states_.state(n) == ObjectState::kSD;
    if (states_.has_to_leave(n)) leave(n, holes[std::size_t(states_.buffer_of(n))]);
  }
  for (std::size_t k = 0; k < static_.size(); ++k) update(int(k), holes[k]);
  compose();
  show();
  return work_;
}

// Where everything is, and what it is lit by.
void StaticFrames::look() {
  const Config& c = config_;
  geometry_.emplace(scene_, ref::View{options_.width, options_.height, c.range_bits, c.subpixel_bits});
  if (has_lighting(c)) {
    LightingFrame lighting = frame_lighting(*geometry_, c);
    if (!lighting_.lights.empty() && !same(lighting, lighting_)) start_anew();
    lighting_ = std::move(lighting);
  }
  for (int i = 0; i < 3; ++i)
    background_[std::size_t(i)] = ref::snapped_colour(geometry_->positions().background[std::size_t(i)], c.colour_bits);
  if (has_texture(c)) texture_ = texture_frame(*geometry_, c);
}

NamedFrame StaticFrames::triangles(const std::vector<std::uint32_t>& instances) {
  NamedFrame out;
  ref::TriangleList list = geometry_->positions();
  list.triangles.clear(), list.face.clear();
  out.lighting = lighting_, out.texture = texture_;
  out.lighting.triangles.clear(), out.texture.triangles.clear();
  const ref::TriangleList& all = geometry_->positions();
  for (std::size_t k = 0; k < all.triangles.size(); ++k) {
    const std::uint32_t n = geometry_->origins()[k].instance;
    if (!std::binary_search(instances.begin(), instances.end(), n)) continue;
    out.objects.push_back(n + 1);
    auto& triangle = list.triangles.emplace_back(all.triangles[k]);
    if (has_lighting(config_)) out.lighting.triangles.push_back(lighting_.triangles[k]);
    if (has_texture(config_)) out.texture.triangles.push_back(texture_.triangles[k]);
    if (!has_colours(config_)) continue;
    const auto colours = geometry_->colours(k);
    for (std::size_t v = 0; v < 3; ++v)
      triangle[v].r = colours[v].r, triangle[v].g = colours[v].g, triangle[v].b = colours[v].b;
  }
  ref::RasterFormat format = raster_format(options_.configuration);
  format.triangles = std::numeric_limits<int>::max();  // of all passes
  out.scene = ref::snap(list, format);
  return out;
}

std::vector<RawEntry> StaticFrames::entries(Engine& engine, const Configuration& configuration,
                                            const NamedFrame& frame) {
  load_frame(engine, configuration.config(), frame);
  return engine.entries(frame.scene);
}

std::vector<RawEntry> StaticFrames::draw_pass(const NamedFrame& pass) {
  ++work_.passes;
  work_.triangles += pass.scene.triangles.size();
  if (sink_->pass) sink_->pass(pass);
  return entries(*engine_, options_.configuration, pass);
}

// As many as the triangles take. Those that cover nothing of the region are left out.
std::vector<StaticFrames::Pass> StaticFrames::passes(const NamedFrame& frame, const Box& region) {
  std::vector<Pass> out;
  const std::size_t count = frame.scene.triangles.size();
  for (std::size_t from = 0; from < count;) {
    const NamedFrame rest = part(frame, from, count);
    load_frame(*engine_, config_, rest);
    const std::size_t fits = engine_->fits(rest.scene);
    Pass pass{part(rest, 0, fits), {}};
    from += fits;
    for (std::size_t k = 0; k < fits; ++k) pass.covered.add(covered(pass.frame, k).cut(region));
    if (!pass.covered.empty()) out.push_back(std::move(pass));
  }
  return out;
}

MergeInput StaticFrames::input(const std::vector<RawEntry>& stored, const std::vector<RawEntry>* drawn,
                               const Box& box) const {
  MergeInput input;
  input.width = options_.width, input.height = options_.height;
  input.box = box;
  input.stored = &stored, input.drawn = drawn;
  input.background = background_;
  return input;
}

std::uint64_t StaticFrames::stamps(const Box& box) const {
  const StampSize stamp = stamp_size(options_.lanes);
  const auto along = [](int from, int to, int side) { return std::uint64_t((to - 1) / side - from / side + 1); };
  return along(box.x0, box.x1, stamp.x) * along(box.y0, box.y1, stamp.y);
}

void StaticFrames::tell(const char* what, const MergeInput& input, RawCommand buffers) {
  buffers.box = input.box;
  buffers.sends = input.sends;
  buffers.merges = buffers.passes || input.drawn != nullptr;
  if (!buffers.anew) buffers.first = input.first, buffers.last = input.last;
  buffers.background = input.background;
  if (sink_->command) sink_->command(what, buffers);
  ++work_.runs;
  // From one command to the next; without words to be sent it is the last stamp that ends it.
  constexpr std::uint64_t kSending = 4, kAsking = 2;
  work_.run_cycles += (buffers.passes ? 0 : stamps(input.box)) + (buffers.sends ? kSending : kAsking);
}

MergeResult StaticFrames::run(const char* what, const MergeInput& input, const RawCommand& buffers) {
  if (sink_->run) sink_->run(what, input);
  tell(what, input, buffers);
  return merger_.run(input);
}

// Takes an object that starts to move out of its S-buffer. What has to be drawn again is put into `holes`.
void StaticFrames::leave(std::uint32_t n, std::vector<Box>& holes) {
  states_.leave(n);
  Box hole = states_.box(n);
  if (hole.empty()) return;
  std::vector<RawEntry>& buffer = static_[std::size_t(states_.buffer_of(n))];
  MergeInput of_object = input(buffer, nullptr, hole);
  of_object.first = of_object.last = n + 1;
  RawCommand buffers;
  buffers.stored = buffers.kept = static_buffer_number(states_.buffer_of(n));
  if (options_.query) {
    of_object.sends = false;
    const MergeResult found = run("query", of_object, buffers);
    ++work_.queries;
    if (found.count == 0) {
      ++work_.skipped;
      return;
    }
    of_object.box = hole = found.box;
    of_object.sends = true;
  }
  buffer = run("erase", of_object, buffers).merged;
  ++work_.erased;
  holes.push_back(hole);
}

// Draws into S-buffer k what overlaps its holes, and what has just stopped.
void StaticFrames::update(int k, const std::vector<Box>& holes) {
  for (const Box& hole : holes) changed_.add(hole);
  std::vector<std::uint32_t> instances;
  Box region;
  states_.over(k, holes, [&](std::uint32_t n, const Box& overlap) {
    instances.push_back(n), region.add(overlap);
    ++work_.redrawn;
  });
  std::vector<Box> stopped(states_.objects());
  for (std::uint32_t n = std::uint32_t(k); n < states_.objects(); n += std::uint32_t(states_.buffers())) {
    if (states_.state(n) == ObjectState::kDS) instances.push_back(n), ++work_.added;
  }
  if (instances.empty()) return;
  std::sort(instances.begin(), instances.end());
  const NamedFrame frame = triangles(instances);
  for (std::size_t t = 0; t < frame.objects.size(); ++t) stopped[frame.objects[t] - 1].add(covered(frame, t));
  for (const std::uint32_t n : instances) {
    if (states_.state(n) == ObjectState::kDS) states_.stay(n, stopped[n]), region.add(stopped[n]);
  }
  changed_.add(region);
  const auto k_at = std::size_t(k);
  for (const Pass& pass : passes(frame, region)) {
    const std::vector<RawEntry> drawn = draw_pass(pass.frame);
    MergeInput add = input(static_[k_at], &drawn, pass.covered);
    RawCommand buffers;
    buffers.passes = true;
    buffers.stored = buffers.kept = static_buffer_number(k);
    if (!filled_[k_at]) {
      add.box = frame_, add.last = (1u << config_.object_bits) - 1;  // all that is there goes
      buffers.anew = true;
      changed_ = frame_;
    }
    static_[k_at] = run("add", add, buffers).merged;
    filled_[k_at] = true;
  }
}

// All S-buffers merged where one has changed.
void StaticFrames::compose() {
  std::vector<std::size_t> filled;
  for (std::size_t k = 0; k < filled_.size(); ++k) {
    if (filled_[k]) filled.push_back(k);
  }
  const int still = still_buffer_number(options_.buffers);
  behind_ = filled.empty() ? nullptr : filled.size() == 1 ? &static_[filled[0]] : &still_;
  behind_number_ = filled.size() == 1 ? static_buffer_number(int(filled[0])) : still;
  if (filled.size() < 2 || changed_.empty()) return;
  std::vector<RawEntry> merged = static_[filled[0]];
  for (std::size_t i = 1; i < filled.size(); ++i) {
    RawCommand buffers;
    buffers.stored = i == 1 ? static_buffer_number(int(filled[0])) : still;
    buffers.drawn = static_buffer_number(int(filled[i]));
    buffers.kept = still;
    merged = run("compose", input(merged, &static_[filled[i]], changed_), buffers).merged;
  }
  still_.resize(merged.size());
  for (int y = changed_.y0; y < changed_.y1; ++y) {
    for (int x = changed_.x0; x < changed_.x1; ++x) {
      const std::size_t at = std::size_t(y) * std::size_t(options_.width) + std::size_t(x);
      still_[at] = merged[at];
    }
  }
}

// The frame is sent whole with the last pass. If there are others, the first takes what stands still into the D-buffer.
void StaticFrames::show() {
  std::vector<std::uint32_t> instances;
  for (std::uint32_t n = 0; n < states_.objects(); ++n) {
    const ObjectState state = states_.state(n);
    if (state == ObjectState::kSD || state == ObjectState::kDD) instances.push_back(n);
  }
  work_.moving = instances.size();
  const NamedFrame frame = triangles(instances);
  std::vector<Pass> all = passes(frame, frame_);
  if (all.empty() && !behind_) all.push_back({frame, {}});  // a frame of background
  RawCommand buffers;
  buffers.anew = !behind_, buffers.stored = behind_number_;
  buffers.kept = kDynamicBuffer;
  if (all.empty()) {
    buffers.shows = true;
    picture_ = run("frame", input(*behind_, nullptr, frame_), buffers).merged;
  }
  for (std::size_t p = 0; p < all.size(); ++p) {
    buffers.passes = true, buffers.shows = p + 1 == all.size();
    const std::vector<RawEntry> drawn = draw_pass(all[p].frame);
    if (buffers.anew) {
      tell("frame", input(drawn, &drawn, frame_), buffers);
      picture_ = drawn;
    } else {
      const Box& box = p == 0 || buffers.shows ? frame_ : all[p].covered;
      picture_ = run("frame", input(p == 0 ? *behind_ : picture_, &drawn, box), buffers).merged;
    }
    buffers.anew = false, buffers.stored = kDynamicBuffer;
  }
}

}  // namespace halfspace::model
