// SPDX-License-Identifier: Apache-2.0
// A film of an animated scene by the kernels of one design, passes and all: what KernelUpConverter makes of two
// designs.
#ifndef HALFSPACE_MODEL_DRIVERS_FILM_HPP_
#define HALFSPACE_MODEL_DRIVERS_FILM_HPP_

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "model/formats/configuration.hpp"
#include "model/pipeline/film_engine.hpp"
#include "ref/geometry/geometry.hpp"

namespace halfspace::model {

// Of a configuration with frames_between, one that draws its key frames alone, and one that draws its frames in between
// alone: with the same bits.
Configuration key_part(const Configuration& film);
Configuration between_part(const Configuration& film);

class FilmMaker {
 public:
  // Hears each pass, and what came of it.
  using Told = std::function<void(const FilmPass&, const FilmDrawn&)>;

  // Frames of width × height pixels. Throws ref::Error for a configuration that makes no films.
  FilmMaker(const Configuration& configuration, int width, int height, int lanes, Told told);

  // The first key frame. Textures of all scenes are as fit_textures leaves them.
  void begin(const ref::Scene& first);
  // The next one, and the frames between it and the one before it, as many as the configuration has. Throws ref::Error
  // where ref::follow does.
  void add(const ref::Scene& key, const std::vector<ref::Scene>& between);

 private:
  // A frame as it is shaded, all its triangles; with what they are shaded by.
  FilmPass shaded(const ref::Scene& scene) const;
  FilmPass field(const ref::Scene& scene, int number) const;
  FilmDrawn run(const FilmPass& pass);

  const Configuration configuration_, key_part_;
  const ref::View view_;
  std::unique_ptr<FilmEngine> engine_;
  Told told_;
  std::optional<ref::Scene> keys_[2];  // the last two
  int key_ = 0;                        // number of the last one
};

// The passes of a whole film: `frames` has key frames and those between them, in their order.
std::vector<FilmPass> film_passes(const Configuration& configuration, int width, int height, int lanes,
                                  const std::vector<ref::Scene>& frames);

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_DRIVERS_FILM_HPP_
