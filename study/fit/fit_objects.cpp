// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "ref/geometry/geometry.hpp"
#include "ref/objects/static_instances.hpp"
#include "study/fit/fit.hpp"

namespace halfspace::model {

FitObjects choose_objects(Config& c, const FitScene& scene,
                          const std::function<std::uint64_t(const FitScene&, const Config&)>& cycles_of) {
  FitObjects found;
  const auto because = [&](std::string why) {
    found.why = std::move(why);
    return found;
  };
  if (!has_depth(c)) return because("no depth is compared");
  if (!scene.frames.front().scene()) return because("a list of triangles has no objects");
  if (scene.frames.size() < 2 * scene.views) return because("one frame has no motion");
  found.objects = scene.frames.front().scene()->instances.size();
  const double aspect = double(scene.width) / scene.height;
  FitScene moving = scene;
  moving.frames.clear(), moving.views = 1;
  // Depths of two frames compare if they are of the same planes.
  std::vector<const ref::Scene*> times;
  for (const Subject& at : scene.frames) times.push_back((has_texture(c) ? at.textured() : at.scene()).get());
  const ref::DepthPlanes planes = ref::held_planes(times, aspect);
  const auto held = [&](std::size_t k) {
    ref::Scene result = *times[k];
    result.depth_planes = planes;
    return result;
  };
  ref::Scene before = held(0);
  for (std::size_t k = 1; k < times.size(); ++k) {
    ref::Scene now = held(k);
    if (scene.begins_view(k)) {
      before = std::move(now);
      continue;
    }
    const std::vector<bool> stands = ref::same_instances(before, now, aspect);
    const std::size_t standing = std::size_t(std::count(stands.begin(), stands.end(), true));
    found.standing = k == 1 ? standing : std::min(found.standing, standing);
    found.moving = std::max(found.moving, stands.size() - standing);
    const auto part = std::make_shared<ref::Scene>(ref::without(now, stands));
    moving.frames.emplace_back(part, has_texture(c) ? part : nullptr);
    before = std::move(now);
  }
  if (found.moving == 0) return because("nothing moves");
  if (found.standing == 0) return because("in some frame nothing stands still, or the viewpoint or a light moves");
  Config numbered = c;
  numbered.object_bits = bits_for(int(found.objects));
  if (const Refusal reason = refusal(numbered); reason != Refusal::kNone)
    return because("refused: " + refusal_text(reason));
  found.cycles_all = cycles_of(scene, c), found.cycles_moving = cycles_of(moving, numbered);
  if (found.cycles_moving >= found.cycles_all) {
    return because(fmt::format("what moves takes {} cycles a frame, no fewer than all of it", found.cycles_moving));
  }
  c = numbered;
  return because(fmt::format("what moves, {} of {} objects at most, takes {} cycles a frame, all of it {}",
                             found.moving, found.objects, found.cycles_moving, found.cycles_all));
}

}  // namespace halfspace::model
