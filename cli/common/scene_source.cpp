// SPDX-License-Identifier: Apache-2.0
#include "cli/common/scene_source.hpp"

#include <cstdio>
#include <set>
#include <utility>

namespace halfspace::cli {
namespace {

ref::SceneChoice with_textures(ref::SceneChoice choice, bool textured) {
  choice.textured = textured;
  return choice;
}

}  // namespace

void add_scene_choice(CLI::App* command, ref::SceneChoice& choice) {
  command->add_option("--animation", choice.animation,
                      "of a file with several: its name, or its number from 0 on; default: the first");
  command->add_option("--camera", choice.camera,
                      "of a file with several: its name, or its number from 0 on; auto: all of the scene is framed; "
                      "default: the first that the file has");
  command->add_flag("--two-sided", choice.two_sided, "draw faces that are seen from behind as well");
  command->add_flag("--trust", choice.trust,
                    "read the file in this process: a little faster, and a file that brings its reader down ends it");
}

SceneSource::SceneSource(const std::string& name, ref::SceneChoice choice, bool textured)
    : source_(name, with_textures(std::move(choice), textured)) {}

ref::Scene SceneSource::at(double seconds) const {
  static std::set<std::string> said;
  ref::Scene scene = source_.at(seconds);
  for (const std::string& remark : scene.remarks) {
    if (said.insert(scene.name + remark).second)
      std::fprintf(stderr, "halfspace: %s: %s\n", scene.name.c_str(), remark.c_str());
  }
  return scene;
}

}  // namespace halfspace::cli
