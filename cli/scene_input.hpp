// SPDX-License-Identifier: Apache-2.0
// From the name of a scene to the snapped triangles of a frame.
#ifndef HALFSPACE_CLI_SCENE_INPUT_HPP_
#define HALFSPACE_CLI_SCENE_INPUT_HPP_

#include <CLI/CLI.hpp>
#include <string>

#include "ref/snap.hpp"
#include "vectors/configuration.hpp"
#include "vectors/trade.hpp"

namespace halfspace::cli {

struct SceneInput {
  std::string scene;   // built-in name, *.tri, or a mesh file
  std::string config;  // name or .toml; empty: middle, or high when the scene does not fit middle
  std::string size;    // "WxH"; empty: a *.tri's size, or the configuration's
  double time = 0;     // seconds into the file's animation
};

// Of the built-in scenes, for a help text.
std::string builtin_names();

// Adds the scene and its options to a subcommand.
void add_scene_options(CLI::App* command, SceneInput& input);

struct LoadedScene {
  ref::SnappedList list;
  vectors::Configuration configuration;  // of its format
  vectors::Projection project;           // the scene as another view sees it
};

struct FrameSize {
  int width = 0, height = 0;
};
// "WxH", both from 1 on. Throws ref::Error.
FrameSize parse_size(const std::string& text);

// Throws ref::Error.
LoadedScene load_snapped(const SceneInput& input);

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_SCENE_INPUT_HPP_
