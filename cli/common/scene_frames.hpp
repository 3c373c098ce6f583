// SPDX-License-Identifier: Apache-2.0
// The frames of a scene, before anything of a configuration is known.
#ifndef HALFSPACE_CLI_COMMON_SCENE_FRAMES_HPP_
#define HALFSPACE_CLI_COMMON_SCENE_FRAMES_HPP_

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <utility>

#include "cli/common/scene_source.hpp"
#include "study/fit/fit.hpp"

namespace halfspace::cli {

struct FrameInput {
  std::string scene;
  std::string size = "640x480";  // a *.tri has its own
  std::string frames;            // "A:B", both included; empty: all of the animation
  double rate = 25;              // frames a second
  int views = 1;                 // from so many sides
  std::string texture = "auto";  // none, nearest, bilinear; auto: bilinear where a mesh file has textures
  ref::SceneChoice choice;
};

// "A:B" as the first frame and the last. Throws ref::Error.
std::pair<int, int> parse_range(const std::string& text);

void add_frame_options(CLI::App* command, FrameInput& input);

// Throws ref::Error.
model::FitScene load_frames(const FrameInput& input);

// How the textures of those are looked at.
std::optional<ref::TextureFilter> texture_of(const FrameInput& input, const model::FitScene& scene);

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_COMMON_SCENE_FRAMES_HPP_
