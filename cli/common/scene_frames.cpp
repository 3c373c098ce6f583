// SPDX-License-Identifier: Apache-2.0
#include "cli/common/scene_frames.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <memory>

#include "cli/common/numbers.hpp"
#include "cli/common/scene_input.hpp"
#include "ref/error.hpp"
#include "ref/scene/scene.hpp"

namespace halfspace::cli {
namespace {

// The view of the scene, about the vertical through its middle.
void turn(ref::Scene& scene, double angle) {
  if (angle == 0) return;
  const glm::dmat3 rotation(glm::rotate(glm::dmat4(1), angle, glm::dvec3(0, 1, 0)));
  scene.view_direction = rotation * scene.view_direction;
  if (!scene.camera) return;
  glm::dvec3 low(std::numeric_limits<double>::max()), high(std::numeric_limits<double>::lowest());
  for (const ref::Instance& placed : scene.instances) {
    for (const glm::dvec3& position : scene.meshes[placed.mesh].positions) {
      const glm::dvec3 point(placed.to_world * glm::dvec4(position, 1));
      low = glm::min(low, point), high = glm::max(high, point);
    }
  }
  const glm::dvec3 middle = (low + high) / 2.0;
  ref::Camera& camera = *scene.camera;
  camera.position = middle + rotation * (camera.position - middle);
  camera.forward = rotation * camera.forward, camera.up = rotation * camera.up;
}

}  // namespace

std::pair<int, int> parse_range(const std::string& text) {
  int first = -1, last = -1;
  const char* const end = text.data() + text.size();
  const auto a = std::from_chars(text.data(), end, first);
  const bool has_colon = a.ec == std::errc() && a.ptr != end && *a.ptr == ':';
  const auto b = has_colon ? std::from_chars(a.ptr + 1, end, last) : a;
  if (!has_colon || b.ec != std::errc() || b.ptr != end || first < 0 || last < first) {
    throw ref::Error(fmt::format("--frames {}: not a range of frames: write it like 0:24", text));
  }
  return {first, last};
}

void add_frame_options(CLI::App* command, FrameInput& input) {
  command
      ->add_option("SCENE", input.scene,
                   "a built-in scene (" + builtin_names() + "), a mesh file or a screen-space *.tri")
      ->required();
  command->add_option("--size", input.size, "frame, WxH; a *.tri has its own")->capture_default_str();
  command->add_option("--frames", input.frames, "frames A:B of the animation, from 0 on; default: all");
  command->add_option("--rate", input.rate, "frames a second")->capture_default_str()->check(above_zero());
  command
      ->add_option("--texture", input.texture,
                   "of the ideal picture: none, nearest, bilinear; auto: bilinear where a mesh file has textures")
      ->check(CLI::IsMember({"auto", "none", "nearest", "bilinear"}))
      ->capture_default_str();
  add_scene_choice(command, input.choice);
}

namespace {

// With textures, if they are to be looked at. A picture that is missing is an error where they were asked for.
std::optional<SceneSource> textured_source(const FrameInput& input) {
  if (input.texture == "none" || (input.texture == "auto" && !std::filesystem::is_regular_file(input.scene)))
    return std::nullopt;
  try {
    return SceneSource(input.scene, input.choice, true);
  } catch (const ref::Error& error) {
    if (input.texture != "auto") throw;
    std::fprintf(stderr, "halfspace: %s: looked at without its textures: %s\n", input.scene.c_str(), error.what());
    return std::nullopt;
  }
}

}  // namespace

std::optional<ref::TextureFilter> texture_of(const FrameInput& input, const model::FitScene& scene) {
  if (!scene.frames.front().has_textures()) return std::nullopt;
  return input.texture == "nearest" ? ref::TextureFilter::kNearest : ref::TextureFilter::kBilinear;
}

model::FitScene load_frames(const FrameInput& input) {
  model::FitScene result{input.scene, 0, 0, {}, {}};
  if (ref::is_tri_file(input.scene)) {
    const auto list = std::make_shared<ref::TriangleList>(ref::read_tri(input.scene));
    if (input.views > 1)
      throw ref::Error(fmt::format("{}: its triangles lie on the screen: leave out --views", input.scene));
    if (list->triangles.empty()) throw ref::Error(fmt::format("{}: no triangle: nothing to fit", input.scene));
    result.width = list->width, result.height = list->height;
    result.times = {0};
    result.frames.emplace_back(list);
    return result;
  }
  const FrameSize size = parse_size(input.size);
  result.width = size.width, result.height = size.height;
  const SceneSource source(input.scene, input.choice);
  const std::optional<SceneSource> textured = textured_source(input);
  const auto start = std::make_shared<ref::Scene>(source.at(0));
  std::pair<int, int> range{0, int(std::floor(start->duration * input.rate))};
  if (!input.frames.empty()) range = parse_range(input.frames);
  for (int side = 0; side < input.views; ++side) {
    for (int k = range.first; k <= range.second; ++k) {
      const double time = k / input.rate;
      const auto scene = std::make_shared<ref::Scene>(k == 0 ? *start : source.at(time));
      turn(*scene, 2 * glm::pi<double>() * side / input.views);
      result.times.push_back(time);
      std::shared_ptr<ref::Scene> with_textures;
      if (textured) {
        with_textures = std::make_shared<ref::Scene>(textured->at(time));
        turn(*with_textures, 2 * glm::pi<double>() * side / input.views);
      }
      result.frames.emplace_back(scene, with_textures);
    }
  }
  result.views = std::size_t(input.views);
  return result;
}

}  // namespace halfspace::cli
