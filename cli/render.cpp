// SPDX-License-Identifier: Apache-2.0
// halfspace render
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <set>

#include "cli/commands.hpp"
#include "cli/common/output.hpp"
#include "cli/common/scene_input.hpp"
#include "cli/plots/picture.hpp"
#include "model/pipeline/accesses.hpp"
#include "model/pipeline/cycles.hpp"
#include "model/pipeline/engine.hpp"
#include "model/pipeline/rates.hpp"
#include "model/texture/texture.hpp"
#include "ref/error.hpp"
#include "ref/geometry/triangle_list.hpp"
#include "ref/raster/architecture.hpp"
#include "vectors/dump.hpp"

namespace halfspace::cli {
namespace {

struct RenderOptions {
  SceneInput input;
  std::string engine = "hls";
  int lanes = 0;
  std::string architecture, shading, texture, mapping = "perspective";
  std::string output, dump, json;
};

// Rounded to what a dump holds; the index is the number of a face of the scene.
ref::Frame rounded(const ref::IdealFrame& ideal, int depth_bits) {
  ref::Frame frame{ideal.width, ideal.height, ideal.face, {}, {}, {}, {}, {}};
  const double full = depth_bits ? ref::full_depth(depth_bits) : 0;
  for (std::size_t n = 0; n < ideal.face.size(); ++n) {
    frame.depth.push_back(std::uint32_t(std::round(ideal.depth[n] * full)));
    const auto& [r, g, b] = ideal.colour[n];
    frame.colour.push_back(
        {std::uint8_t(std::round(r)), std::uint8_t(std::round(g)), std::uint8_t(std::round(b)), 255});
  }
  return frame;
}

// What a frame took.
struct Counts {
  Json rates, buffers;
};

Json json_of(const model::Cycles& c) {
  return {{"frame", c.frame},
          {"triangle_setup", c.triangle_setup},
          {"shade_setup", c.shade_setup},
          {"raster", c.raster},
          {"test", c.test},
          {"scan_out", c.scan_out}};
}

// The circuit of the kernels, if its lanes are named; else the paper's.
ref::Circuit circuit_of(const model::Configuration& configuration, int lanes) {
  if (lanes == 0) return {};
  const auto engine = model::make_engine(configuration, lanes);
  return {engine->lanes_x(), engine->lanes_y(), !is_deferred(configuration.config())};
}

// Of an entry of each buffer. A wide pixel of beta is a copy of the planes.
model::BufferBits bits_of(ref::Architecture architecture, Config config) {
  const bool indexed = is_index_rendering(architecture);
  config.architecture = architecture == ref::Architecture::kGamma ? Architecture::kGamma : Architecture::kDelta;
  model::BufferBits bits = model::entry_bits(config);
  if (architecture == ref::Architecture::kAlpha) bits.frame = 3 * config.colour_bits;
  if (architecture == ref::Architecture::kBeta) bits.pixel = bits.shading;
  if (!indexed) bits.index = bits.shading = 0;
  return bits;
}

// The reference by one of the four architectures.
ref::Frame draw_by(const RenderOptions& options, const LoadedScene& loaded, Counts& counts) {
  const ref::SnappedList& list = loaded.list;
  const Config config = loaded.configuration.config();
  const ref::Architecture architecture =
      kind_of(ref::kArchitectures, options.architecture.empty() ? "delta" : options.architecture);
  std::optional<ref::Scene> scene;
  std::optional<ref::Geometry> geometry;
  std::unique_ptr<ref::Surface> surface;
  if (loaded.between) {
    surface = ref::given_surface(list);  // black: it gives no picture
  } else if (ref::is_tri_file(options.input.scene)) {
    if (options.shading == "phong")
      throw ref::Error(options.input.scene + ": its triangles have colours and no normals: leave out --shading phong");
    surface = ref::given_surface(list);
  } else {
    // Textures of a configuration that has them are as it can hold them.
    scene =
        has_texture(config)
            ? *loaded.scene
            : SceneSource(options.input.scene, options.input.choice, !options.texture.empty()).at(options.input.time);
    geometry.emplace(*scene, ref::frame_view(list.format, list.width, list.height));
    const std::string given = model::find_field("shading")->text(config);
    surface = ref::lit_surface(*geometry, list,
                               kind_of(ref::kShadingModes, options.shading.empty() ? given : options.shading));
    if (!options.texture.empty()) {
      const ref::TextureMode mode{
          options.texture == "nearest" ? ref::TextureFilter::kNearest : ref::TextureFilter::kBilinear,
          options.mapping == "affine" ? ref::TextureMapping::kAffine : ref::TextureMapping::kPerspective};
      surface = ref::textured_surface(std::move(surface), *geometry, list, mode);
    } else if (has_texture(config)) {
      surface = ref::textured_surface(std::move(surface), *geometry, list, texture_mode(config));
    }
  }
  ref::Drawing drawing =
      ref::draw(list, *surface, architecture, true, {}, circuit_of(loaded.configuration, options.lanes));
  counts.rates = all_rates(drawing.rates);
  if (options.shading.empty() || options.shading == model::find_field("shading")->text(config)) {
    if (has_objects(config))
      model::add_object_uses(list.width * std::uint64_t(list.height), drawing.rates.triangles, drawing.buffers);
    counts.buffers = to_json(drawing.buffers, bits_of(architecture, config));
  }
  fmt::print("{}: {} fragments, {} passed the Z-test; {} lightings, {} texels\n", name_of(architecture),
             drawing.rates.fragments, drawing.rates.reduced_fragments, drawing.rates.lightings,
             drawing.rates.texture_fetches);
  return frame_of(list, std::move(drawing));
}

// With the lights of the configuration, if it has some, and the textures as they are in the file.
ref::IdealFrame ideal_of(const SceneInput& input, const LoadedScene& loaded) {
  const ref::View view = ref::ideal_view(loaded.list.width, loaded.list.height);
  const Config config = loaded.configuration.config();
  if (!has_lighting(config) && !has_texture(config)) return ref::ideal(loaded.project(view));
  if (!loaded.scene) throw ref::Error(input.scene + ": its triangles have colours, and are neither lit nor textured");
  return ref::ideal(SceneSource(input.scene, input.choice, has_texture(config)).at(input.time), view,
                    model::look_of(config));
}

ref::Frame render_with(const std::string& engine, const SceneInput& input, const LoadedScene& loaded, int lanes) {
  const ref::SnappedList& scene = loaded.list;
  if (engine == "ref") return reference_of(loaded);
  if (engine == "hls") return kernels_of(loaded, lanes)->render(scene);
  return rounded(ideal_of(input, loaded), scene.format.depth_bits);
}

void render(const RenderOptions& options) {
  LoadedScene loaded = load_snapped(options.input);
  const ref::SnappedList& scene = loaded.list;
  const int lanes = options.lanes ? options.lanes : 16;
  const bool moves = !shades(loaded.configuration.config());
  if (moves && (options.engine == "ideal" || !options.shading.empty() || !options.texture.empty() ||
                !options.output.empty() || !options.dump.empty())) {
    throw ref::Error(fmt::format(
        "configuration {} gives motion and no picture: leave out --engine ideal, --shading, --texture, -o and --dump",
        loaded.configuration.name()));
  }
  Counts counts;
  const bool chosen = !options.architecture.empty() || !options.shading.empty() || !options.texture.empty();
  if (chosen && options.engine == "hls") {
    if (options.architecture != "gamma" && options.architecture != "delta") {
      throw ref::Error(
          "--architecture and --shading: the kernels are of type gamma or delta, with the shading of their "
          "configuration: "
          "take --engine ref for the rest");
    }
    if (!options.shading.empty() || !options.texture.empty()) {
      throw ref::Error(
          "--shading, --texture: the kernels have the shading and the texture of their configuration: name one with "
          "--config, or take --engine ref");
    }
    Config numbers = loaded.configuration.config();
    numbers.architecture = options.architecture == "gamma" ? Architecture::kGamma : Architecture::kDelta;
    loaded.configuration = model::Configuration(loaded.configuration.name(), numbers);
  }
  Json memories, cycles;
  if (options.engine == "hls" && !options.json.empty()) {
    const Config config = loaded.configuration.config();
    const auto engine = kernels_of(loaded, lanes);
    counts.rates = to_json(model::count_rates(*engine, scene, loaded.configuration.config()));
    const model::Accesses accesses = model::count_accesses(config, *engine, scene);
    counts.buffers = to_json(accesses.needed, model::entry_bits(config), &accesses.words);
    memories = to_json(model::memory_bits(config, engine->lanes_x(), engine->lanes_y()));
    // The model knows no pipeline that waits for normals.
    if (!is_deferred(config)) cycles = json_of(model::model_cycles(config, *engine, scene, engine->render(scene)));
  }
  const ref::Frame frame = chosen && options.engine == "ref"
                               ? draw_by(options, loaded, counts)
                               : render_with(options.engine, options.input, loaded, lanes);
  if (!options.output.empty()) write_picture(options.output, colour_picture(frame));
  if (!options.dump.empty()) model::write_dump(options.dump, scene, frame);

  std::uint64_t covered = 0;
  for (const std::uint32_t index : frame.index) covered += index != 0;
  tell_if_unseen(loaded, covered != 0);
  std::uint64_t reduced = 0;
  for (const bool visible : frame.visible) reduced += visible;
  const std::uint64_t in_view =
      std::set<std::uint32_t>(frame.index.begin(), frame.index.end()).size() - (covered < frame.index.size() ? 1 : 0);
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
                            {"covered_pixels", covered},
                            // With --architecture, or of the kernels.
                            {"rates", counts.rates},
                            {"buffers", counts.buffers},
                            {"memory_bits", memories},
                            {"modelled_cycles", cycles}});
}

}  // namespace

void add_render(CLI::App& app, int&) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = app.add_subcommand("render", "render a scene with the reference or the kernels");
  command->footer(
      "  halfspace render teapot -o teapot.png                                  by the kernels, with the bits of the "
      "RTL\n"
      "  halfspace render castle --config high --size 1280x720 -o castle.png\n"
      "  halfspace render castle --engine ref --shading phong -o phong.png      by the reference\n"
      "  halfspace render drone --time 0.5 --size 320x240 --json -              numbers alone, of a moment of an "
      "animation\n");
  add_scene_options(command, options->input);
  command
      ->add_option("--engine", options->engine,
                   "ref: floating-point reference; hls: fixed-point kernels; ideal: no position snapped (index: faces "
                   "of the scene)")
      ->check(CLI::IsMember({"ref", "hls", "ideal"}))
      ->capture_default_str();
  command->add_option("--lanes", options->lanes,
                      "pixels a stamp: 1, 2, 4, 8, 16 (the picture is the same); default for hls: 16; for ref with "
                      "--architecture: pixel by pixel");
  command
      ->add_option(
          "--architecture", options->architecture,
          "alpha, traditional; beta, deferred shading; gamma, delta, index rendering without and with a Z-buffer")
      ->check(CLI::IsMember({"alpha", "beta", "gamma", "delta"}));
  command->add_option("--shading", options->shading, "for --engine ref: flat, gouraud or phong")
      ->check(CLI::IsMember({"flat", "gouraud", "phong"}));
  command
      ->add_option("--texture", options->texture,
                   "for --engine ref: draw the textures of the scene, nearest or bilinear")
      ->check(CLI::IsMember({"nearest", "bilinear"}));
  command->add_option("--mapping", options->mapping, "of textures: affine on the screen, or perspective")
      ->check(CLI::IsMember({"affine", "perspective"}))
      ->capture_default_str();
  add_output_file(command, "-o,--output", options->output, "picture to write; the ending chooses the format");
  add_output_folder(command, "--dump", options->dump,
                    "folder for index.u32, depth.u32, colour.rgba8 (little endian, row 0 on top) and triangles.tri");
  add_json(command, options->json);
  command->callback([options] { render(*options); });
}

}  // namespace halfspace::cli
