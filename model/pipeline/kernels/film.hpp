// SPDX-License-Identifier: Apache-2.0
// The passes of a film through the kernels, of formats at run time.
#ifndef HALFSPACE_MODEL_PIPELINE_KERNELS_FILM_HPP_
#define HALFSPACE_MODEL_PIPELINE_KERNELS_FILM_HPP_

#include <cstddef>
#include <memory>
#include <vector>

#include "hls/pipeline/up_convert.hpp"
#include "model/formats/recorder.hpp"
#include "model/motion/key_tables.hpp"
#include "model/pipeline/film_engine.hpp"
#include "model/pipeline/kernels/draw.hpp"
#include "model/pipeline/kernels/scan.hpp"

namespace halfspace {

// Memories of the size that was active when they were made.
template <class S>
struct MotionBuffer<RuntimeFormats<S>> {
  using F = RuntimeFormats<S>;
  std::vector<Motion<F>> word = decltype(word)(std::size_t(frame_words<F>()));
};
template <class S>
struct FilmBuffer<RuntimeFormats<S>> {
  using F = RuntimeFormats<S>;
  std::vector<FoundPixel<F>> pixel = decltype(pixel)(std::size_t(frame_words<F>()));
};
template <class S, int N>
struct FilmKeys<RuntimeFormats<S>, N> {
  using F = RuntimeFormats<S>;
  std::vector<std::vector<KeyPixel<F>>> bank =
      decltype(bank)(std::size_t(N * N), std::vector<KeyPixel<F>>(std::size_t(kKeySlots* key_slot_words<F, N>())));
};

namespace model {

template <class F, int N>
class FilmKernels {
 public:
  std::vector<Layout> layouts() {
    std::vector<Layout> all = stream_layouts(*streams_);
    for (Layout& layout : stream_layouts(*film_streams_)) all.push_back(std::move(layout));
    return all;
  }

  FilmDrawn run(const FilmPass& pass, const Config& config, const WordSink& sink) {
    check_turn(pass, config);
    std::unique_ptr<Recorder> recorders[2];
    if (sink) {
      recorders[0] = std::make_unique<Recorder>(*streams_);
      recorders[1] = std::make_unique<Recorder>(*film_streams_);
    }
    TriangleAnswers answers;
    answers.normals = pass.frame.lighting.triangles;
    answers.coordinates = pass.frame.texture.triangles;
    answers.vectors = pass.frame.motion.triangles;
    answers.faces = pass.faces;
    load(pass);
    FilmDrawn out;
    std::vector<bool> visible;
    draw<F>(pass.frame.scene, answers, Drawn::kAll, *streams_, *buffers_, &visible, pass.pass);
    for (const bool is_visible : visible) out.answers += is_visible;
    scan(pass, out);
    if (pass.pass == Pass::kBetween) compensate(pass, config, out);
    last_ = {pass.pass, pass.key, pass.field, !out.asked.empty()};
    show(pass, config, out);
    for (const auto& recorder : recorders) {
      if (recorder) recorder->tell(sink);
    }
    return out;
  }

 private:
  // The pass before the next one, and whether it left holes.
  struct Turn {
    Pass pass = Pass::kBetween;
    int key = -1, field = 0;
    bool asks = false;
  };

  void check_turn(const FilmPass& pass, const Config& config) const {
    const bool first = last_.key < 0, of_key = last_.pass == Pass::kKey;
    Turn due;
    if (last_.asks) due = {Pass::kFill, last_.key, last_.field, false};
    else if (first || (of_key && last_.key == 0)) due = {Pass::kKey, last_.key + 1, 0, false};
    else if (of_key) due = {Pass::kBetween, last_.key - 1, 1, false};
    else if (last_.field < config.frames_between) due = {Pass::kBetween, last_.key, last_.field + 1, false};
    else due = {Pass::kKey, last_.key + 2, 0, false};
    if (pass.pass != due.pass || pass.key != due.key || pass.field != due.field || pass.faces.size() != triangles(pass))
      throw ref::Error(
          "a pass of a film does not come next, or its faces are not those of its triangles: this is a "
          "fault of the program");
  }
  static std::size_t triangles(const FilmPass& pass) { return pass.frame.scene.triangles.size(); }

  // Lights and textures of a pass that shades. Texels that are there already are not loaded again.
  void load(const FilmPass& pass) {
    streams_->light.words.clear(), streams_->material.words.clear();
    streams_->texture.words.clear(), streams_->texel.words.clear();
    if (moves<F>(pass.pass)) return;
    if (F::kHasLighting) {
      streams_->light.words = load_lights<F>(pass.frame.lighting, buffers_->lights);
      streams_->material.words = load_materials<F>(pass.frame.lighting, buffers_->materials);
    }
    if (!F::kHasTexture) return;
    auto textures = load_textures<F>(pass.frame.texture, buffers_->textures);
    auto texels = load_texels<F>(pass.frame.texture, buffers_->texels);
    const std::vector<Word> words = packed_words(textures, texels);
    if (words == loaded_) return;
    loaded_ = words;
    streams_->texture.words = std::move(textures), streams_->texel.words = std::move(texels);
  }
  template <class Textures, class Texels>
  static std::vector<Word> packed_words(const Textures& textures, const Texels& texels) {
    std::vector<Word> words;
    for (const auto& each : textures) words.push_back(pack(each, model::layout<TextureEntry<F>>().bits));
    for (const auto& each : texels) words.push_back(pack(each, model::layout<Texel<F>>().bits));
    return words;
  }

  void scan(const FilmPass& pass, FilmDrawn& out) {
    const ref::SnappedList& scene = pass.frame.scene;
    const Frame<F> registers = frame_registers<F>(scene);
    for (int stamp_y = 0; stamp_y * F::kLanesY < scene.height; ++stamp_y) {
      pipeline_scan(registers, stamp_y, *streams_, *buffers_);
      while (!streams_->scan.empty()) {
        pipeline_mask(pass.pass, *streams_, *buffers_);
        if (streams_->masked.empty()) continue;
        if (moves<F>(pass.pass)) move(out);
        else shade(pass, registers, out);
      }
    }
  }
  void move(FilmDrawn& out) {
    pipeline_motion(*streams_, *buffers_);
    while (!streams_->motion.empty()) {
      store_motion(streams_->motion, memories_->motion);
      ++out.words;
    }
  }
  void shade(const FilmPass& pass, const Frame<F>& registers, FilmDrawn& out) {
    pipeline_shade(registers, *streams_, *buffers_);
    pixel_store(registers, streams_->stored_scan, streams_->pixel, buffers_->faces, streams_->shown);
    while (!streams_->shown.empty()) {
      const ShownPixel<F> pixel = streams_->shown.read();
      film_store<F, N>(pixel, pass.pass, pass.key, *memories_);
      out.filled += pass.pass == Pass::kFill && is_set(pixel.shown);
    }
  }

  void compensate(const FilmPass& pass, const Config& config, FilmDrawn& out) {
    const auto weight = from_raw<typename F::KeyWeight>(field_weight(config, pass.field));
    const KeyWeights<F> weights;
    film_compensate<F, N>(frame_registers<F>(pass.frame.scene), weight, weights, pass.key, *film_streams_, *buffers_,
                          *memories_);
    while (!film_streams_->asked.empty()) {
      const auto face = std::uint32_t(raw(film_streams_->asked.read().face));
      if (face != 0) out.asked.push_back(face);
    }
    for (int stamp = 0; stamp < F::kStamps; ++stamp) {
      for (int l = 0; l < F::kLanes; ++l) out.holes += is_set(Bit(buffers_->holes.hole[stamp][l]));
    }
  }

  // What comes out once the pass is done.
  void show(const FilmPass& pass, const Config& config, FilmDrawn& out) {
    const Frame<F> registers = frame_registers<F>(pass.frame.scene);
    const auto frame = [&](bool of_key, int key) {
      film_scan<F, N>(registers, of_key, key_slot(key), memories_->keys, memories_->film, film_streams_->film);
      auto& picture = out.shown.emplace_back();
      while (!film_streams_->film.empty()) {
        const FilmPixel<F> in = film_streams_->film.read();
        picture.push_back({std::uint8_t(displayed<F>(in.r)), std::uint8_t(displayed<F>(in.g)),
                           std::uint8_t(displayed<F>(in.b)), 255});
      }
    };
    if (pass.pass == Pass::kKey && pass.key == 0) frame(true, 0);
    if (pass.pass == Pass::kKey || !out.asked.empty()) return;
    frame(false, 0);
    if (pass.field == config.frames_between) frame(true, pass.key + 1);
  }

  std::unique_ptr<Streams<F>> streams_ = std::make_unique<Streams<F>>();
  std::unique_ptr<FilmStreams<F, N>> film_streams_ = std::make_unique<FilmStreams<F, N>>();
  std::unique_ptr<Buffers<F>> buffers_ = std::make_unique<Buffers<F>>();
  std::unique_ptr<FilmMemories<F, N>> memories_ = std::make_unique<FilmMemories<F, N>>();
  Turn last_;
  std::vector<Word> loaded_;  // of textures
};

}  // namespace model
}  // namespace halfspace

#endif  // HALFSPACE_MODEL_PIPELINE_KERNELS_FILM_HPP_
