// SPDX-License-Identifier: Apache-2.0
// Engine for one configuration and one stamp.
#ifndef HALFSPACE_MODEL_PIPELINE_ENGINE_IMPL_HPP_
#define HALFSPACE_MODEL_PIPELINE_ENGINE_IMPL_HPP_

#include <algorithm>
#include <cstring>
#include <memory>
#include <string>

#include "hls/pipeline/pipeline.hpp"
#include "model/formats/stamps.hpp"
#include "model/motion/motion_records.hpp"
#include "model/objects/object_records.hpp"
#include "model/pipeline/engine.hpp"
#include "model/shade/lighting_records.hpp"
#include "model/texture/texture_records.hpp"
#include "ref/error.hpp"
#include "ref/raster/index_pool.hpp"

namespace halfspace::model {

template <class F>
class KernelEngine : public Engine {
 public:
  int lanes_x() const override { return F::kLanesX; }
  int lanes_y() const override { return F::kLanesY; }

  std::vector<Layout> layouts() const override {
    std::vector<Layout> layouts;
    if (F::kHasLighting) layouts = {layout<Light<F>>(), layout<Material<F>>()};
    if (F::kHasTexture) layouts.push_back(layout<TextureEntry<F>>()), layouts.push_back(layout<Texel<F>>());
    for (const Layout& next : {layout<Triangle<F>>(), layout<Setup<F>>(), layout<Attributes<F>>()})
      layouts.push_back(next);
    if (F::kDeferred) layouts.push_back(visible_attributes_layout());
    if (F::kHasLighting) layouts.push_back(layout<Normals<F>>());
    if (F::kHasLighting && !F::kPhong) layouts.push_back(layout<Colours<F>>());
    if (!F::kHasMotion) layouts.push_back(F::kPhong ? layout<NormalPlanes<F>>() : layout<Planes<F>>());
    if (F::kHasTexture)
      layouts.push_back(layout<TextureCoordinates<F>>()), layouts.push_back(layout<TexturePlanes<F>>());
    if (F::kHasMotion) layouts.push_back(layout<MotionVectors<F>>()), layouts.push_back(layout<MotionPlanes<F>>());
    if (F::kTestsPlanes) layouts.push_back(layout<TriangleDepth<F>>());
    for (const Layout& next : {layout<Stamp<F>>(), layout<Update<F>>(), layout<Visible<F>>(), layout<Scan<F>>()})
      layouts.push_back(next);
    if (F::kHasTexture) layouts.push_back(layout<LitPixel<F>>());
    layouts.push_back(F::kHasMotion ? layout<Motion<F>>() : F::kHasObjects ? layout<Entry<F>>() : layout<Pixel<F>>());
    return layouts;
  }

  void light(const LightingFrame& frame) override {
    lights_ = load_lights<F>(frame, buffers_->lights);
    materials_ = load_materials<F>(frame, buffers_->materials);
    normals_ = frame.triangles;
  }

  void texture(const TextureFrame& frame) override {
    textures_ = load_textures<F>(frame, buffers_->textures);
    texels_ = load_texels<F>(frame, buffers_->texels);
    coordinates_ = frame.triangles;
  }

  void move(const MotionFrame& frame) override { motion_vectors_ = frame.triangles; }

  void number(const std::vector<std::uint32_t>& objects) override { objects_ = objects; }

  void reuse_indices(int window) override { window_ = std::uint32_t(window); }

  std::size_t fits(const ref::SnappedList& scene) override {
    const std::size_t indices = std::size_t(F::kTriangles);
    if (window_ == 0 || scene.triangles.size() <= indices) return std::min(scene.triangles.size(), indices);
    const std::size_t drawn = draw(scene, nullptr, false);
    std::vector<std::array<std::uint8_t, 4>> colour;
    scan(scene, colour);
    return drawn;
  }

  ref::Frame render(const ref::SnappedList& scene) override {
    ref::Frame frame;
    draw(scene, &frame.visible);
    copy_buffers(scene, frame);
    scan(scene, frame.colour);
    return frame;
  }

  void render_colour(const ref::SnappedList& scene, std::vector<std::array<std::uint8_t, 4>>& colour) override {
    draw(scene, nullptr);
    scan(scene, colour);
  }

  std::vector<RawMotion> motion(const ref::SnappedList& scene, ref::Frame* frame) override {
    std::vector<Motion<F>> words;
    streams_->motion.tap(&words);
    draw(scene, nullptr);
    if (frame) copy_buffers(scene, *frame);
    std::vector<std::array<std::uint8_t, 4>> colour;
    scan(scene, colour);
    streams_->motion.tap(nullptr);
    std::vector<RawMotion> field;
    field.reserve(words.size());
    for (const Motion<F>& word : words) {
      if (raw(word.face) != 0) field.push_back(plain_motion<F>(word));
    }
    return field;
  }

  std::vector<RawEntry> entries(const ref::SnappedList& scene) override {
    std::vector<Entry<F>> words;
    streams_->entry.tap(&words);
    std::vector<std::array<std::uint8_t, 4>> colour;
    render_colour(scene, colour);
    streams_->entry.tap(nullptr);
    std::vector<RawEntry> out(std::size_t(scene.width) * scene.height);
    for (const Entry<F>& word : words) put_entry(word, scene.width, scene.height, out);
    return out;
  }

  std::vector<int> visits(const ref::SnappedList& scene) override {
    std::vector<int> counts = heard(streams_->visits, scene);
    counts.resize(scene.triangles.size());  // a frame without triangles has one that is none
    return counts;
  }

  std::vector<PlaneTests> plane_tests(const ref::SnappedList& scene) override {
    std::vector<PlaneTests> tests = heard(streams_->tests, scene);
    tests.resize(scene.triangles.size());
    return tests;
  }

  void capture(const ref::SnappedList& scene, const WordSink& sink) override {
    Streams<F>& s = *streams_;
    std::vector<Triangle<F>> triangle;
    std::vector<Setup<F>> setup;
    std::vector<Attributes<F>> attributes;
    std::vector<Attributes<F>> visible_attributes;
    std::vector<Normals<F>> normals;
    std::vector<Colours<F>> colours;
    std::vector<Planes<F>> planes;
    std::vector<NormalPlanes<F>> normal_planes;
    std::vector<TextureCoordinates<F>> texture_coordinates;
    std::vector<TexturePlanes<F>> texture_planes;
    std::vector<TriangleDepth<F>> triangle_depth;
    std::vector<Stamp<F>> stamp;
    std::vector<Update<F>> update;
    std::vector<Visible<F>> visible;
    std::vector<Scan<F>> scan;
    std::vector<Pixel<F>> lit, pixel;
    std::vector<MotionVectors<F>> motion_vectors;
    std::vector<MotionPlanes<F>> motion_planes;
    std::vector<Motion<F>> motion;
    std::vector<Entry<F>> entry;
    s.entry.tap(&entry);
    s.motion_vectors.tap(&motion_vectors), s.motion_planes.tap(&motion_planes), s.motion.tap(&motion);
    s.triangle.tap(&triangle), s.setup.tap(&setup), s.attributes.tap(&attributes), s.planes.tap(&planes);
    s.visible_attributes.tap(&visible_attributes), s.normals.tap(&normals), s.colours.tap(&colours);
    s.normal_planes.tap(&normal_planes), s.texture_coordinates.tap(&texture_coordinates),
        s.texture_planes.tap(&texture_planes);
    s.triangle_depth.tap(&triangle_depth), s.lit.tap(&lit);
    s.stamp.tap(&stamp), s.update.tap(&update), s.visible.tap(&visible), s.scan.tap(&scan), s.pixel.tap(&pixel);
    render(scene);
    s.entry.tap(nullptr);
    s.motion_vectors.tap(nullptr), s.motion_planes.tap(nullptr), s.motion.tap(nullptr);
    s.triangle.tap(nullptr), s.setup.tap(nullptr), s.attributes.tap(nullptr), s.planes.tap(nullptr);
    s.visible_attributes.tap(nullptr), s.normals.tap(nullptr), s.colours.tap(nullptr);
    s.normal_planes.tap(nullptr), s.texture_coordinates.tap(nullptr), s.texture_planes.tap(nullptr);
    s.triangle_depth.tap(nullptr), s.lit.tap(nullptr);
    s.stamp.tap(nullptr), s.update.tap(nullptr), s.visible.tap(nullptr), s.scan.tap(nullptr), s.pixel.tap(nullptr);
    if (F::kHasLighting) tell(lights_, sink), tell(materials_, sink);
    if (F::kHasTexture) tell(textures_, sink), tell(texels_, sink);
    tell(triangle, sink), tell(setup, sink), tell(attributes, sink);
    if (F::kDeferred) tell(visible_attributes, sink, visible_attributes_layout());
    if (F::kHasLighting) tell(normals, sink);
    if (F::kHasLighting && !F::kPhong) tell(colours, sink);
    if (F::kPhong) tell(normal_planes, sink);
    else if (!F::kHasMotion) tell(planes, sink);
    if (F::kHasTexture) tell(texture_coordinates, sink), tell(texture_planes, sink);
    if (F::kHasMotion) tell(motion_vectors, sink), tell(motion_planes, sink);
    if (F::kTestsPlanes) tell(triangle_depth, sink);
    tell(stamp, sink), tell(update, sink), tell(visible, sink), tell(scan, sink);
    if (F::kHasTexture) tell(lit, sink, layout<LitPixel<F>>());
    if (F::kHasMotion) tell(motion, sink);
    else if (F::kHasObjects) tell(entry, sink);
    else tell(pixel, sink);
  }

 private:
  // What a probe hears of a frame.
  template <class T>
  std::vector<T> heard(Probe<T>& probe, const ref::SnappedList& scene) {
    std::vector<T> values;
    probe.tap(&values);
    std::vector<std::array<std::uint8_t, 4>> colour;
    render_colour(scene, colour);
    probe.tap(nullptr);
    return values;
  }

  static Layout visible_attributes_layout() {
    Layout result = layout<Attributes<F>>();
    result.stream = "visible_attributes";
    return result;
  }

  template <class Record>
  static void tell(const std::vector<Record>& records, const WordSink& sink) {
    tell(records, sink, layout<Record>());
  }
  template <class Record>
  static void tell(const std::vector<Record>& records, const WordSink& sink, const Layout& words_layout) {
    std::vector<Word> words;
    words.reserve(records.size());
    for (const Record& record : records) words.push_back(pack(record, words_layout.bits));
    sink(words_layout, words.data(), words.size());
  }

  static Frame<F> frame_registers(const ref::SnappedList& scene) {
    Frame<F> registers;
    registers.width = from_raw<typename F::X>(scene.width);
    registers.height = from_raw<typename F::Y>(scene.height);
    registers.r = from_raw<typename F::Colour>(scene.background[0]);
    registers.g = from_raw<typename F::Colour>(scene.background[1]);
    registers.b = from_raw<typename F::Colour>(scene.background[2]);
    return registers;
  }

  // Draws all triangles into the buffers; else those that there are indices for. Returns how many.
  std::size_t draw(const ref::SnappedList& scene, std::vector<bool>* visible, bool all = true) {
    const bool too_many = all && window_ == 0 && scene.triangles.size() > std::size_t(F::kTriangles);
    if (scene.width > F::kWidth || scene.height > F::kHeight || too_many) {
      throw ref::Error("a frame is larger than the configuration that is to draw it: snap it for that configuration");
    }
    if (F::kHasLighting && normals_.size() != scene.triangles.size()) {
      throw ref::Error("the configuration lights triangles, and these came without normals: take one without lights");
    }
    if (F::kHasTexture && coordinates_.size() != scene.triangles.size()) {
      throw ref::Error(
          "the configuration draws textures, and the triangles came without coordinates: take one without texture");
    }
    if (F::kHasMotion && motion_vectors_.size() != scene.triangles.size()) {
      throw ref::Error(
          "the configuration is of frames in between, and the triangles came without motion: take one that shades "
          "them");
    }
    if (F::kHasObjects) check_objects(scene);
    if (visible) visible->resize(scene.triangles.size());
    const Frame<F> registers = frame_registers(scene);
    const std::size_t count = scene.triangles.size();
    ref::IndexPool pool({window_, std::uint32_t(F::kTriangles)});
    for (std::size_t k = 0; k < std::max<std::size_t>(count, 1); ++k) {
      if (!all && k < count && !pool.has_one()) return k;
      Triangle<F> t{};
      t.last = from_raw<Bit>(k + 1 >= count);
      if (k < count) {
        const ref::SnappedTriangle& in = scene.triangles[k];
        t.index = from_raw<typename F::Index>(pool.take());
        if (F::kHasObjects) t.object = from_raw<typename F::Object>(objects_.empty() ? 1 : objects_[k]);
        for (int v = 0; v < 3; ++v) {
          t.x[v] = from_raw<typename F::Coord>(in.x[v]);
          t.y[v] = from_raw<typename F::Coord>(in.y[v]);
          t.depth[v] = from_raw<typename F::Depth>(in.depth[v]);
          t.r[v] = from_raw<typename F::Colour>(in.rgb[v][0]);
          t.g[v] = from_raw<typename F::Colour>(in.rgb[v][1]);
          t.b[v] = from_raw<typename F::Colour>(in.rgb[v][2]);
        }
      }
      streams_->triangle.write(t);
      pipeline_triangle(registers, *streams_, *buffers_);
      const Visible<F> done = streams_->visible.read();
      if (F::kHasLighting && raw(done.visible)) {
        streams_->normals.write(normals_record<F>(normals_[k], int(raw(done.index)), raw(done.last) != 0));
      }
      if (F::kHasTexture && raw(done.visible)) {
        streams_->texture_coordinates.write(
            coordinates_record<F>(coordinates_[k], int(raw(done.index)), raw(done.last) != 0));
      }
      if (F::kHasMotion && raw(done.visible)) {
        streams_->motion_vectors.write(
            vectors_record<F>(motion_vectors_[k], int(raw(done.index)), raw(done.last) != 0));
      }
      pipeline_planes(*streams_, *buffers_);
      pool.done(std::uint32_t(raw(done.index)), raw(done.visible) != 0);
      if (visible && k < count) (*visible)[k] = raw(done.visible) != 0;
    }
    return count;
  }

  void check_objects(const ref::SnappedList& scene) const {
    const std::uint32_t most = (1u << F::Object::width()) - 1;
    if (!objects_.empty() && objects_.size() != scene.triangles.size()) {
      throw ref::Error(
          "a frame has another number of triangles than numbers of objects: this is a fault of the program");
    }
    for (const std::uint32_t object : objects_) {
      if (object == 0 || object > most)
        throw ref::Error("an object's number does not fit its bits: raise object_bits of the configuration");
    }
  }

  static std::uint32_t displayed(const typename F::Colour& colour) {
    return ref::displayed_colour(std::uint32_t(raw(colour)), F::kColourBits);
  }

  // The depth of a pixel, in lane `lane` of a stamp, that triangle `index` > 0 has drawn.
  std::uint32_t stored_depth(int x, int y, int lane, std::uint32_t, std::false_type) const {
    return std::uint32_t(raw(buffers_->depth.depth[y * F::kStampsX + x][lane]));
  }
  std::uint32_t stored_depth(int x, int y, int lane, std::uint32_t index, std::true_type) const {
    if (!F::kTestsPlanes) return stored_depth(x, y, lane, index, std::false_type());
    Bit lanes[F::kLanes] = {};
    lanes[lane] = from_raw<Bit>(1);
    typename F::Depth depth[F::kLanes] = {};
    const DepthEntry<F> plane = buffers_->visibility.entry[int(index) - 1];
    plane_lanes<F>(plane.origin, plane.dx, plane.dy, x << F::kLog2LanesX, y << F::kLog2LanesY, lanes, depth);
    return std::uint32_t(raw(depth[lane]));
  }

  // The I-buffer, before the scan-out clears it, and the depths: of the Z-buffer or of TdbV.
  void copy_buffers(const ref::SnappedList& scene, ref::Frame& frame) const {
    frame.width = scene.width;
    frame.height = scene.height;
    frame.index.resize(std::size_t(scene.width) * scene.height);
    frame.depth.resize(frame.index.size());
    const std::uint32_t farthest = ref::full_depth(F::kDepthBits);
    for (int y = 0; y < scene.height; ++y) {
      for (int x = 0; x < scene.width; ++x) {
        const int stamp_x = x >> F::kLog2LanesX, stamp_y = y >> F::kLog2LanesY;
        const int lane = y % F::kLanesY * F::kLanesX + x % F::kLanesX;
        const std::uint32_t index = raw(buffers_->index.index[stamp_y * F::kStampsX + stamp_x][lane]);
        frame.index[std::size_t(y) * scene.width + x] = index;
        frame.depth[std::size_t(y) * scene.width + x] =
            index == 0 || !F::kHasDepth ? farthest
                                        : stored_depth(stamp_x, stamp_y, lane, index, typename F::CompilesPlaneTest());
      }
    }
  }

  // Scans the frame out and clears the I-buffer. What a motion configuration gives goes to a tap or nowhere.
  void scan(const ref::SnappedList& scene, std::vector<std::array<std::uint8_t, 4>>& colour) {
    colour.resize(F::kHasMotion ? 0 : std::size_t(scene.width) * scene.height);
    const Frame<F> registers = frame_registers(scene);
    for (int stamp_y = 0; stamp_y * F::kLanesY < scene.height; ++stamp_y) {
      pipeline_scan(registers, stamp_y, *streams_, *buffers_);
      while (F::kHasMotion && !streams_->scan.empty()) {
        pipeline_motion(*streams_, *buffers_);
        while (!streams_->motion.empty()) streams_->motion.read();
      }
      while (!streams_->scan.empty()) {
        pipeline_shade(registers, *streams_, *buffers_);
        const Pixel<F> in = F::kHasObjects ? Pixel<F>(streams_->entry.read()) : streams_->pixel.read();
        std::uint32_t rgba[F::kLanes];  // little endian: r first in memory
        for (int l = 0; l < F::kLanes; ++l) {
          rgba[l] = displayed(in.r[l]) | displayed(in.g[l]) << 8 | displayed(in.b[l]) << 16 | 255u << 24;
        }
        const int x = int(raw(in.x)) * F::kLanesX, y = int(raw(in.y)) * F::kLanesY;
        const int columns = scene.width - x, rows = std::min(F::kLanesY, scene.height - y);
        for (int j = 0; j < rows; ++j) {
          auto* row = &colour[std::size_t(y + j) * scene.width + x];
          if (columns >= F::kLanesX) std::memcpy(row, rgba + j * F::kLanesX, sizeof(*rgba) * F::kLanesX);
          else std::memcpy(row, rgba + j * F::kLanesX, sizeof(*rgba) * columns);
        }
      }
    }
  }

  std::unique_ptr<Streams<F>> streams_ = std::make_unique<Streams<F>>();
  std::unique_ptr<Buffers<F>> buffers_ = std::make_unique<Buffers<F>>();
  std::uint32_t window_ = 0;  // of index reuse
  // Of the next frames.
  std::vector<Light<F>> lights_;
  std::vector<Material<F>> materials_;
  std::vector<RawNormals> normals_;
  std::vector<TextureEntry<F>> textures_;
  std::vector<Texel<F>> texels_;
  std::vector<RawCoordinates> coordinates_;
  std::vector<RawMotionVectors> motion_vectors_;
  std::vector<std::uint32_t> objects_;
};

// Engine of configuration C with the given number of lanes.
template <class C>
std::unique_ptr<Engine> make_kernel_engine(int lanes) {
  return with_stamp<std::unique_ptr<Engine>>(lanes, [](auto stamp) -> std::unique_ptr<Engine> {
    return std::make_unique<KernelEngine<Formats<C, decltype(stamp)>>>();
  });
}

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_PIPELINE_ENGINE_IMPL_HPP_
