// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "model/formats/runtime_formats.hpp"
#include "model/pipeline/engine_impl.hpp"
#include "model/pipeline/kernels/film.hpp"

namespace halfspace::model {
namespace {

// The engine of the kernels, with its formats made the thread's before each use.
template <class S>
class RuntimeEngine : public Engine {
 public:
  RuntimeEngine(const Config& config, const FormatTable& table) : config_(config), table_(table) {
    activate();
    kernels_ = std::make_unique<KernelEngine<RuntimeFormats<S>>>();
  }

  int lanes_x() const override { return S::kX; }
  int lanes_y() const override { return S::kY; }
  std::vector<Layout> layouts() const override {
    activate();
    return kernels_->layouts();
  }
  void light(const LightingFrame& frame) override {
    activate();
    kernels_->light(frame);
  }
  void texture(const TextureFrame& frame) override {
    activate();
    kernels_->texture(frame);
  }
  void move(const MotionFrame& frame) override {
    activate();
    kernels_->move(frame);
  }
  void number(const std::vector<std::uint32_t>& objects) override { kernels_->number(objects); }
  void reuse_indices(int window) override { kernels_->reuse_indices(window); }
  std::size_t fits(const ref::SnappedList& scene) override {
    activate();
    return kernels_->fits(scene);
  }
  ref::Frame render(const ref::SnappedList& scene) override {
    activate();
    return kernels_->render(scene);
  }
  void render_colour(const ref::SnappedList& scene, std::vector<std::array<std::uint8_t, 4>>& colour) override {
    activate();
    kernels_->render_colour(scene, colour);
  }
  std::vector<RawMotion> motion(const ref::SnappedList& scene, ref::Frame* frame) override {
    activate();
    return kernels_->motion(scene, frame);
  }
  std::vector<RawEntry> entries(const ref::SnappedList& scene) override {
    activate();
    return kernels_->entries(scene);
  }
  std::vector<int> visits(const ref::SnappedList& scene) override {
    activate();
    return kernels_->visits(scene);
  }
  std::vector<PlaneTests> plane_tests(const ref::SnappedList& scene) override {
    activate();
    return kernels_->plane_tests(scene);
  }
  void capture(const ref::SnappedList& scene, const WordSink& sink) override {
    activate();
    kernels_->capture(scene, sink);
  }

 private:
  void activate() const { RuntimeFormats<S>::activate(config_, table_); }

  Config config_;
  FormatTable table_;
  std::unique_ptr<KernelEngine<RuntimeFormats<S>>> kernels_;
};

template <class S, int N>
class RuntimeFilm : public FilmEngine {
 public:
  explicit RuntimeFilm(const Configuration& configuration) : configuration_(configuration) {
    activate();
    kernels_ = std::make_unique<FilmKernels<RuntimeFormats<S>, N>>();
  }

  int lanes_x() const override { return S::kX; }
  int lanes_y() const override { return S::kY; }
  std::vector<Layout> layouts() const override {
    activate();
    return kernels_->layouts();
  }
  FilmDrawn run(const FilmPass& pass, const WordSink& sink) override {
    activate();
    return kernels_->run(pass, configuration_.config(), sink);
  }

 private:
  void activate() const { RuntimeFormats<S>::activate(configuration_.config(), format_table(configuration_.config())); }

  Configuration configuration_;
  std::unique_ptr<FilmKernels<RuntimeFormats<S>, N>> kernels_;
};

}  // namespace

std::unique_ptr<FilmEngine> make_film_engine(const Configuration& configuration, int lanes) {
  const Config config = configuration.config();
  if (!up_converts(config)) {
    throw ref::Error(
        fmt::format("configuration {} makes no films: take one with frames_between = 1 to 9", configuration.name()));
  }
  return with_stamp<std::unique_ptr<FilmEngine>>(lanes, [&](auto stamp) -> std::unique_ptr<FilmEngine> {
    using S = decltype(stamp);
    if (key_side(config.filter) == 4) return std::make_unique<RuntimeFilm<S, 4>>(configuration);
    return std::make_unique<RuntimeFilm<S, 2>>(configuration);
  });
}

std::unique_ptr<Engine> make_runtime_engine(const Config& config, const FormatTable& table, int lanes) {
  return with_stamp<std::unique_ptr<Engine>>(lanes, [&](auto stamp) -> std::unique_ptr<Engine> {
    return std::make_unique<RuntimeEngine<decltype(stamp)>>(config, table);
  });
}

}  // namespace halfspace::model
