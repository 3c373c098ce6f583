// SPDX-License-Identifier: Apache-2.0
// From the name of a scene to the snapped triangles of a frame.
#ifndef HALFSPACE_CLI_COMMON_SCENE_INPUT_HPP_
#define HALFSPACE_CLI_COMMON_SCENE_INPUT_HPP_

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>
#include <memory>
#include <string>

#include "cli/common/scene_source.hpp"
#include "model/formats/configuration.hpp"
#include "model/motion/motion.hpp"
#include "model/pipeline/engine.hpp"
#include "model/shade/lighting.hpp"
#include "ref/geometry/snap.hpp"
#include "ref/geometry/surface.hpp"
#include "ref/motion/motion.hpp"
#include "ref/motion/relight.hpp"
#include "ref/raster/architecture.hpp"
#include "ref/raster/raster.hpp"
#include "ref/scene/scene.hpp"
#include "study/trade/trade.hpp"

namespace halfspace::cli {

struct SceneInput {
  std::string scene;     // built-in name, *.tri, or a mesh file
  std::string config;    // name or .toml; empty: middle, or high when the scene does not fit middle
  std::string size;      // "WxH"; empty: a *.tri's size, or the configuration's
  double time = 0;       // seconds into the animation
  std::string interval;  // "T0:T1", seconds: the key frames of a motion configuration, which draws the frame at `time`
                         // between them
  ref::SceneChoice choice;
  int window = 0;  // of index reuse; not 0: there may be more triangles than the configuration takes
};

// Of the built-in scenes, the animated ones last, for a help text.
std::string builtin_names();

// Adds the scene and its options to a subcommand.
void add_scene_options(CLI::App* command, SceneInput& input);

struct LoadedScene {
  std::string name;
  ref::SnappedList list;
  model::Configuration configuration;  // of its format
  model::Projection project;           // the scene as another view sees it
  std::shared_ptr<ref::Scene> scene;   // null of a *.tri
  std::shared_ptr<ref::Between>
      between;  // of a motion configuration: the triangles of `list`, and where they are in the key frames
  ref::OfKeys<ref::LightChange> change{};  // of one that relights: what the light changes on them from each key
};

// The times of the key frames, around that of the input. Throws ref::Error.
ref::OfKeys<double> interval_of(const SceneInput& input);

// The lights, materials and normals of the triangles. Throws ref::Error where there are none.
model::LightingFrame lighting_of(const LoadedScene& loaded);
// The textures, and the coordinates of the triangles. Throws ref::Error likewise.
model::TextureFrame texture_of(const LoadedScene& loaded);

// Where the triangles are in the key frames; colours as if they were the same in these.
model::MotionFrame motion_of(const LoadedScene& loaded);

// On standard error, where a picture covers no pixel: why.
void tell_if_unseen(const LoadedScene& loaded, bool covers);

// On standard error, where the configuration of the motion has fewer numbers than the scene has faces.
void tell_if_faces_share(const ref::Scene& scene, const Config& motion);

// The kernels of its configuration, with its lighting, its textures or its motion if they take them.
std::unique_ptr<model::Engine> kernels_of(const LoadedScene& loaded, int lanes);

// The picture of a drawing, with its buffers.
ref::Frame frame_of(const ref::SnappedList& list, ref::Drawing drawing);

using model::texture_mode;

// What the reference draws. If the kernels light, lights and viewer are at infinity.
ref::Frame reference_of(const LoadedScene& loaded);

// The one of that name, which there is.
template <class Kind, std::size_t N>
Kind kind_of(const Kind (&kinds)[N], const std::string& name) {
  return *std::find_if(std::begin(kinds), std::end(kinds), [&](Kind kind) { return name_of(kind) == name; });
}

struct FrameSize {
  int width = 0, height = 0;
};
// "WxH", both from 1 on. Throws ref::Error.
FrameSize parse_size(const std::string& text);

// Throws ref::Error.
LoadedScene load_snapped(const SceneInput& input);

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_COMMON_SCENE_INPUT_HPP_
