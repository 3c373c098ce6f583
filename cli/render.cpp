// SPDX-License-Identifier: Apache-2.0
// halfspace render
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <set>

#include "cli/commands.hpp"
#include "cli/picture.hpp"
#include "cli/scene_input.hpp"
#include "ref/error.hpp"
#include "vectors/dump.hpp"
#include "vectors/engine.hpp"

namespace halfspace::cli {
namespace {

struct Options {
  SceneInput input;
  std::string engine = "hls";
  int lanes = 16;
  std::string output, dump, json;
};

// Rounded to what a dump holds; the index is the number of a face of the scene.
ref::Frame rounded(const ref::IdealFrame& ideal, int depth_bits) {
  ref::Frame frame{ideal.width, ideal.height, ideal.face, {}, {}, {}, {}, {}};
  const double full = depth_bits ? ref::full_depth(depth_bits) : 0;
  for (std::size_t n = 0; n < ideal.face.size(); ++n) {
    frame.depth.push_back(std::uint32_t(std::round(ideal.depth[n] * full)));
    const auto& [r, g, b] = ideal.colour[n];
    frame.colour.push_back({std::uint8_t(std::round(r)), std::uint8_t(std::round(g)), std::uint8_t(std::round(b)), 255});
  }
  return frame;
}

ref::Frame render_with(const std::string& engine, const LoadedScene& loaded, int lanes) {
  const ref::SnappedList& scene = loaded.list;
  if (engine == "ref") return ref::render(scene);
  if (engine == "hls") return vectors::make_engine(loaded.configuration, lanes)->render(scene);
  return rounded(ref::ideal(loaded.project(ref::ideal_view(scene.width, scene.height))), scene.format.depth_bits);
}

void render(const Options& options) {
  const LoadedScene loaded = load_snapped(options.input);
  const ref::SnappedList& scene = loaded.list;
  const ref::Frame frame = render_with(options.engine, loaded, options.lanes);
  if (!options.output.empty()) write_picture(options.output, colour_picture(frame));
  if (!options.dump.empty()) vectors::write_dump(options.dump, scene, frame);

  std::uint64_t covered = 0;
  for (const std::uint32_t index : frame.index) covered += index != 0;
  std::uint64_t reduced = 0;
  for (const bool visible : frame.visible) reduced += visible;
  const std::uint64_t in_view = std::set<std::uint32_t>(frame.index.begin(), frame.index.end()).size() -
                                (covered < frame.index.size() ? 1 : 0);
  fmt::print("{} {} {}: {}x{}, {} triangles, {} passed the Z-test, {} in view, {} pixels covered\n", options.engine,
             options.input.scene, scene.format.name, scene.width, scene.height, scene.triangles.size(), reduced,
             in_view, covered);
  write_json(options.json, {{"scene", options.input.scene},
                            {"config", scene.format.name},
                            {"engine", options.engine},
                            {"width", scene.width},
                            {"height", scene.height},
                            {"triangles", scene.triangles.size()},
                            {"reduced_triangles", reduced},
                            {"visible_triangles", in_view},
                            {"covered_pixels", covered}});
}

}  // namespace

void add_render(CLI::App& app, int&) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("render", "render a scene with the reference or the kernels");
  add_scene_options(command, options->input);
  command->add_option("--engine", options->engine, "ref: floating-point reference; hls: fixed-point kernels; ideal: no position snapped (index: faces of the scene)")
      ->check(CLI::IsMember({"ref", "hls", "ideal"}))
      ->capture_default_str();
  command->add_option("--lanes", options->lanes, "pixels a stamp, for hls: 1, 2, 4, 8, 16 (the picture is the same)")
      ->capture_default_str();
  command->add_option("-o,--output", options->output, "picture to write; the ending chooses the format");
  command->add_option("--dump", options->dump,
                      "folder for index.u32, depth.u32, colour.rgba8 (little endian, row 0 on top) and triangles.tri");
  command->add_option("--json", options->json, "file for the numbers");
  command->callback([options] { render(*options); });
}

}  // namespace halfspace::cli
