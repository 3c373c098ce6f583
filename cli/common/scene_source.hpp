// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_CLI_COMMON_SCENE_SOURCE_HPP_
#define HALFSPACE_CLI_COMMON_SCENE_SOURCE_HPP_

#include <CLI/CLI.hpp>
#include <string>

#include "ref/scene/scene.hpp"

namespace halfspace::cli {

// Adds the options that choose what of a scene is drawn.
void add_scene_choice(CLI::App* command, ref::SceneChoice& choice);

// A scene that says on standard error what is not as its file has it, each sentence once a run.
class SceneSource {
 public:
  // Throws ref::Error, as at() does.
  SceneSource(const std::string& name, ref::SceneChoice choice, bool textured = false);
  ref::Scene at(double seconds) const;

 private:
  ref::SceneSource source_;
};

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_COMMON_SCENE_SOURCE_HPP_
