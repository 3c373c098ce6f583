// SPDX-License-Identifier: Apache-2.0
// Engine for one configuration and one stamp.
#ifndef HALFSPACE_MODEL_PIPELINE_ENGINE_IMPL_HPP_
#define HALFSPACE_MODEL_PIPELINE_ENGINE_IMPL_HPP_

#include <algorithm>
#include <memory>
#include <utility>

#include "model/formats/recorder.hpp"
#include "model/formats/stamps.hpp"
#include "model/objects/object_records.hpp"
#include "model/pipeline/engine.hpp"
#include "model/pipeline/kernels/buffers.hpp"
#include "model/pipeline/kernels/draw.hpp"
#include "model/pipeline/kernels/scan.hpp"

namespace halfspace::model {

template <class F>
class KernelEngine : public Engine {
 public:
  int lanes_x() const override { return F::kLanesX; }
  int lanes_y() const override { return F::kLanesY; }

  std::vector<Layout> layouts() const override { return stream_layouts(*streams_); }

  void light(const LightingFrame& frame) override {
    streams_->light.words = load_lights<F>(frame, buffers_->lights);
    streams_->material.words = load_materials<F>(frame, buffers_->materials);
    answers_.normals = frame.triangles;
  }

  void texture(const TextureFrame& frame) override {
    streams_->texture.words = load_textures<F>(frame, buffers_->textures);
    streams_->texel.words = load_texels<F>(frame, buffers_->texels);
    answers_.coordinates = frame.triangles;
  }

  void move(const MotionFrame& frame) override { answers_.vectors = frame.triangles; }

  void number(const std::vector<std::uint32_t>& objects) override { answers_.objects = objects; }

  void reuse_indices(int window) override { answers_.window = std::uint32_t(window); }

  std::size_t fits(const ref::SnappedList& scene) override {
    const std::size_t indices = std::size_t(F::kTriangles);
    if (index_rule<F>(answers_).window == 0 || scene.triangles.size() <= indices)
      return std::min(scene.triangles.size(), indices);
    const std::size_t drawn = draw(scene, nullptr, Drawn::kFirst);
    Colours8 colour;
    scan(scene, colour);
    return drawn;
  }

  ref::Frame render(const ref::SnappedList& scene) override {
    ref::Frame frame;
    draw(scene, &frame.visible);
    copy_buffers<F>(*buffers_, scene, frame);
    scan(scene, frame.colour);
    return frame;
  }

  void render_colour(const ref::SnappedList& scene, Colours8& colour) override {
    draw(scene, nullptr);
    scan(scene, colour);
  }

  std::vector<RawMotion> motion(const ref::SnappedList& scene, ref::Frame* frame) override {
    std::vector<RawMotion> field;
    for (const Motion<F>& word : heard<Motion<F>>(streams_->motion, scene, frame)) {
      if (raw(word.face) != 0) field.push_back(plain_motion<F>(word));
    }
    return field;
  }

  std::vector<RawEntry> entries(const ref::SnappedList& scene) override {
    std::vector<RawEntry> out(std::size_t(scene.width) * scene.height);
    for (const Entry<F>& word : heard<Entry<F>>(streams_->entry, scene))
      put_entry(word, scene.width, scene.height, out);
    return out;
  }

  std::vector<int> visits(const ref::SnappedList& scene) override {
    std::vector<int> counts = heard<int>(streams_->visits, scene);
    counts.resize(scene.triangles.size());  // a frame without triangles has one that is none
    return counts;
  }

  std::vector<PlaneTests> plane_tests(const ref::SnappedList& scene) override {
    std::vector<PlaneTests> tests = heard<PlaneTests>(streams_->tests, scene);
    tests.resize(scene.triangles.size());
    return tests;
  }

  void capture(const ref::SnappedList& scene, const WordSink& sink) override {
    const Recorder recorder(*streams_);
    draw(scene, nullptr, Drawn::kNumbered);
    Colours8 colour;
    scan(scene, colour);
    recorder.tell(sink);
  }

 protected:
  std::unique_ptr<Streams<F>> streams_ = std::make_unique<Streams<F>>();
  std::unique_ptr<Buffers<F>> buffers_ = std::make_unique<Buffers<F>>();
  TriangleAnswers answers_;  // of the next frames

 private:
  // What passes through a stream or a probe while a frame is drawn. `frame`, unless it is null, takes the buffers.
  template <class Record, class Stream>
  std::vector<Record> heard(Stream& stream, const ref::SnappedList& scene, ref::Frame* frame = nullptr) {
    struct Listener {
      Stream& stream;
      std::vector<Record> records;
      explicit Listener(Stream& heard) : stream(heard) { stream.tap(&records); }
      ~Listener() { stream.tap(nullptr); }
    } listener(stream);
    draw(scene, nullptr);
    if (frame) copy_buffers<F>(*buffers_, scene, *frame);
    Colours8 colour;
    scan(scene, colour);
    return std::move(listener.records);
  }

  std::size_t draw(const ref::SnappedList& scene, std::vector<bool>* visible, Drawn which = Drawn::kAll) {
    return model::draw<F>(scene, answers_, which, *streams_, *buffers_, visible);
  }
  void scan(const ref::SnappedList& scene, Colours8& colour) {
    scan_out<F>(scene, frame_registers<F>(scene), *streams_, *buffers_, colour);
  }
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
