// SPDX-License-Identifier: Apache-2.0
// What is drawn, before anything of a configuration is known: a scene at one time, or a list of triangles. A
// configuration is handed its triangles, and the lights, normals, materials, textures and coordinates that it takes.
#ifndef HALFSPACE_STUDY_TRADE_SUBJECT_HPP_
#define HALFSPACE_STUDY_TRADE_SUBJECT_HPP_

#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "model/pipeline/named_frame.hpp"
#include "ref/geometry/triangle_list.hpp"
#include "ref/raster/ideal_scene.hpp"
#include "ref/raster/raster.hpp"
#include "ref/scene/scene.hpp"

namespace halfspace::model {

class Subject {
 public:
  Subject() = default;
  explicit Subject(std::shared_ptr<const ref::TriangleList> list) : list_(std::move(list)) {}
  // `textured` is the same scene, loaded with its textures; null: they are not looked at.
  explicit Subject(std::shared_ptr<const ref::Scene> scene, std::shared_ptr<const ref::Scene> textured = nullptr)
      : scene_(std::move(scene)), textured_(std::move(textured)) {}

  // Null of a list.
  const std::shared_ptr<const ref::Scene>& scene() const { return scene_; }
  const std::shared_ptr<const ref::Scene>& textured() const { return textured_; }
  bool has_textures() const { return textured_ && !textured_->textures.empty(); }

  // The triangles, lit at their vertices by the host.
  ref::TriangleList triangles(const ref::View&) const;

  // What an engine of the configuration draws, with the faces that its triangles are parts of. Throws ref::Error when
  // it does not fit, or asks for what a list does not have.
  struct Drawn {
    ref::TriangleList list;
    NamedFrame frame;
  };
  Drawn drawn(const Config&, int width, int height, double shift_x = 0, double shift_y = 0) const;

  // The reference of that. If the kernels light, lights and viewer are at infinity; textures are as the configuration
  // holds them. exact_colour is empty where a pixel's colour is more than a plane: with Phong shading or textures.
  ref::Frame reference(const Config&, const Drawn&) const;

  ref::IdealFrame ideal(const ref::IdealLook&, int width, int height, double shift_x = 0, double shift_y = 0) const;

 private:
  // The textured scene as the configuration's memory holds it.
  std::shared_ptr<const ref::Scene> fitted(const Config&) const;
  const ref::Scene& needed(const Config&) const;

  // By texels and textures of configurations. Points of a sweep are computed by several threads.
  struct Fitted {
    std::mutex mutex;
    std::map<std::pair<int, int>, std::shared_ptr<const ref::Scene>> scenes;
  };

  std::shared_ptr<const ref::TriangleList> list_;
  std::shared_ptr<const ref::Scene> scene_, textured_;
  std::shared_ptr<Fitted> fitted_ = std::make_shared<Fitted>();
};

// How the scene of a configuration is to be looked at: at least as its features have it, and as fine as `finest`, where
// several are held against one ideal. The lights are those that the kernels have, or those at the vertices.
ref::IdealLook look_of(const Config&, const ref::IdealLook& finest = {});
ref::TextureMode texture_mode(const Config&);

}  // namespace halfspace::model

#endif  // HALFSPACE_STUDY_TRADE_SUBJECT_HPP_
