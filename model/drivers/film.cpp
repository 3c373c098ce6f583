// SPDX-License-Identifier: Apache-2.0
#include "model/drivers/film.hpp"

#include <fmt/format.h>

#include <set>
#include <utility>

#include "model/drivers/up_convert.hpp"
#include "model/formats/config_fields.hpp"
#include "model/shade/frame_lighting.hpp"
#include "model/texture/texture.hpp"
#include "ref/error.hpp"
#include "ref/geometry/snap.hpp"
#include "ref/motion/motion.hpp"

namespace halfspace::model {
namespace {

std::vector<std::uint32_t> numbers_of_faces(const std::vector<std::uint32_t>& faces, const Config& config) {
  std::vector<std::uint32_t> numbers;
  for (const std::uint32_t face : faces) numbers.push_back(std::uint32_t(face_number(face, config)));
  return numbers;
}

template <class T>
std::vector<T> chosen(const std::vector<T>& all, const std::vector<std::size_t>& which) {
  std::vector<T> out;
  for (const std::size_t k : which) {
    if (!all.empty()) out.push_back(all[k]);
  }
  return out;
}

// The triangles of the faces that are asked for, in their order.
FilmPass of_faces(const FilmPass& whole, const std::vector<std::uint32_t>& asked) {
  const std::set<std::uint32_t> wanted(asked.begin(), asked.end());
  std::vector<std::size_t> which;
  for (std::size_t k = 0; k < whole.faces.size(); ++k) {
    if (wanted.count(whole.faces[k]) != 0) which.push_back(k);
  }
  FilmPass out = whole;
  out.faces = chosen(whole.faces, which);
  out.frame.scene.triangles = chosen(whole.frame.scene.triangles, which);
  out.frame.lighting.triangles = chosen(whole.frame.lighting.triangles, which);
  out.frame.texture.triangles = chosen(whole.frame.texture.triangles, which);
  return out;
}

}  // namespace

Configuration key_part(const Configuration& film) {
  Config c = film.config();
  clear_part(c, Part::kFilm), clear_part(c, Part::kMotion);
  if (!has_texture(c)) clear_part(c, Part::kCoordinates);
  if (!is_gouraud(c)) c.colour_fraction = 0;
  return Configuration("key_of_" + film.name(), c);
}

Configuration between_part(const Configuration& film) {
  Config c = film.config();
  clear_part(c, Part::kFilm), clear_part(c, Part::kLighting), clear_part(c, Part::kTexture);
  c.shading = Shading::kMotion;
  if (!relights(c)) c.colour_fraction = 0;
  return Configuration("between_of_" + film.name(), c);
}

FilmMaker::FilmMaker(const Configuration& configuration, int width, int height, int lanes, Told told)
    : configuration_(configuration),
      key_part_(key_part(configuration)),
      view_{width, height, configuration.config().range_bits, configuration.config().subpixel_bits},
      engine_(make_film_engine(configuration, lanes)),
      told_(std::move(told)) {}

FilmPass FilmMaker::shaded(const ref::Scene& scene) const {
  const Config config = configuration_.config();
  ref::Geometry geometry(scene, view_);
  FilmPass out;
  if (has_lighting(config)) out.frame.lighting = frame_lighting(geometry, config);
  if (has_texture(config)) out.frame.texture = texture_frame(geometry, config);
  const ref::TriangleList list = ref::lit_triangles(geometry);
  out.frame.scene = ref::snap(list, raster_format(configuration_));
  out.faces = numbers_of_faces(list.face, config);
  return out;
}

FilmPass FilmMaker::field(const ref::Scene& scene, int number) const {
  const Config config = configuration_.config();
  const double way = double(number) / (config.frames_between + 1);
  const ref::Between motion = ref::follow(ref::MotionMethod::kExact, *keys_[0], *keys_[1], scene, way, view_);
  ref::OfKeys<ref::LightChange> change;
  if (relights(config)) change = light_changes(scene, {&*keys_[0], &*keys_[1]}, view_, key_part_.config());
  FilmPass out;
  out.pass = Pass::kBetween;
  out.key = key_ - 1, out.field = number;
  out.frame.note = fmt::format("frame {} between keys {} and {}", number, key_ - 1, key_);
  out.frame.scene = ref::snap(motion.list, raster_format(configuration_));
  out.frame.motion = motion_frame(motion, config, change);
  out.faces = numbers_of_faces(motion.list.face, config);
  return out;
}

FilmDrawn FilmMaker::run(const FilmPass& pass) {
  FilmDrawn drawn = engine_->run(pass);
  if (told_) told_(pass, drawn);
  return drawn;
}

void FilmMaker::begin(const ref::Scene& first) {
  keys_[1] = first;
  FilmPass pass = shaded(first);
  pass.frame.note = "key 0";
  run(pass);
}

void FilmMaker::add(const ref::Scene& key, const std::vector<ref::Scene>& between) {
  if (int(between.size()) != configuration_.config().frames_between) {
    throw ref::Error(
        fmt::format("configuration {}: {} frames between two keys, and it makes {}: raise frames_between, "
                    "or give as many",
                    configuration_.name(), between.size(), configuration_.config().frames_between));
  }
  keys_[0] = std::move(keys_[1]), keys_[1] = key;
  FilmPass pass = shaded(key);
  pass.key = ++key_;
  pass.frame.note = fmt::format("key {}", key_);
  run(pass);
  for (std::size_t n = 0; n < between.size(); ++n) {
    const FilmPass whole = shaded(between[n]);
    FilmPass moving = field(between[n], int(n) + 1);
    moving.frame.scene.background = whole.frame.scene.background;
    const FilmDrawn drawn = run(moving);
    if (drawn.asked.empty()) continue;
    FilmPass fill = of_faces(whole, drawn.asked);
    fill.pass = Pass::kFill;
    fill.key = moving.key, fill.field = moving.field;
    fill.frame.note = "holes of " + moving.frame.note;
    run(fill);
  }
}

std::vector<FilmPass> film_passes(const Configuration& configuration, int width, int height, int lanes,
                                  const std::vector<ref::Scene>& frames) {
  const std::size_t step = std::size_t(configuration.config().frames_between) + 1;
  if (frames.size() % step != 1 || frames.size() == 1) {
    throw ref::Error(
        fmt::format("a film of {} frames, and one of configuration {} has a key frame, and then {} each: "
                    "take another number of frames",
                    frames.size(), configuration.name(), step));
  }
  std::vector<FilmPass> passes;
  FilmMaker maker(configuration, width, height, lanes,
                  [&](const FilmPass& pass, const FilmDrawn&) { passes.push_back(pass); });
  maker.begin(frames[0]);
  for (std::size_t n = step; n < frames.size(); n += step)
    maker.add(frames[n], {frames.begin() + std::ptrdiff_t(n - step + 1), frames.begin() + std::ptrdiff_t(n)});
  return passes;
}

}  // namespace halfspace::model
