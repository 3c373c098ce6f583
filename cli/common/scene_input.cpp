// SPDX-License-Identifier: Apache-2.0
#include "cli/common/scene_input.hpp"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>

#include "cli/common/numbers.hpp"
#include "model/drivers/up_convert.hpp"
#include "model/pipeline/engine.hpp"
#include "model/shade/frame_lighting.hpp"
#include "ref/error.hpp"
#include "ref/geometry/distant_lighting.hpp"
#include "ref/geometry/geometry.hpp"
#include "ref/geometry/surface.hpp"
#include "ref/geometry/triangle_list.hpp"
#include "ref/scene/scene.hpp"

namespace halfspace::cli {
namespace {

// snap() knows a list, and not where it came from.
ref::SnappedList snap_scene(const std::string& name, const ref::TriangleList& list, const ref::RasterFormat& format) {
  try {
    return ref::snap(list, format, model::raster_formats());
  } catch (const ref::Misfit& misfit) {
    throw ref::Misfit(fmt::format("{}: {}", name, misfit.what()));
  }
}

bool fits(const FrameSize& size, const ref::RasterFormat& format) {
  return size.width <= format.width && size.height <= format.height;
}

}  // namespace

FrameSize parse_size(const std::string& text) {
  FrameSize size;
  const char* const end = text.data() + text.size();
  const auto w = std::from_chars(text.data(), end, size.width);
  const bool has_x = w.ec == std::errc() && w.ptr != end && *w.ptr == 'x';
  const auto h = has_x ? std::from_chars(w.ptr + 1, end, size.height) : w;
  if (!has_x || h.ec != std::errc() || h.ptr != end || size.width < 1 || size.height < 1) {
    throw ref::Error(fmt::format("--size {}: not a frame size: write it like 640x480", text));
  }
  return size;
}

std::string builtin_names() {
  std::string names;
  for (const std::string& name : ref::builtin_scene_names()) names += (names.empty() ? "" : ", ") + name;
  names += "; animated:";
  for (const std::string& name : ref::animated_scene_names()) names += " " + name;
  return names;
}

void add_scene_options(CLI::App* command, SceneInput& input) {
  command
      ->add_option(
          "SCENE", input.scene,
          "a built-in scene (" + builtin_names() + "), a mesh file (OBJ, glTF, Collada, …) or a screen-space *.tri")
      ->required();
  command->add_option("--config", input.config,
                      "number formats: low (320x200), middle (640x480), high (1920x1080) or a .toml file; default: "
                      "middle, or high when the scene does not fit");
  command->add_option("--size", input.size, "frame, WxH; default: the size in the file, or the configuration's own");
  command->add_option("--time", input.time, "seconds into the animation")->capture_default_str()->check(finite());
  command->add_option("--interval", input.interval,
                      "of a motion configuration: seconds T0:T1 of the key frames, with --time between them");
  add_scene_choice(command, input.choice);
}

namespace {

// Of a scene whose configuration asks for more than a *.tri has.
ref::Geometry geometry_of(const LoadedScene& loaded) {
  if (!loaded.scene) {
    throw ref::Error(
        fmt::format("configuration {} lights or textures triangles, and those of a *.tri have colours alone: take a "
                    "mesh file, or a "
                    "configuration without lights and texture",
                    loaded.configuration.name()));
  }
  return {*loaded.scene, ref::frame_view(loaded.list.format, loaded.list.width, loaded.list.height)};
}

}  // namespace

model::LightingFrame lighting_of(const LoadedScene& loaded) {
  return model::frame_lighting(geometry_of(loaded), loaded.configuration.config());
}

model::TextureFrame texture_of(const LoadedScene& loaded) {
  return model::texture_frame(geometry_of(loaded), loaded.configuration.config());
}

model::MotionFrame motion_of(const LoadedScene& loaded) {
  return model::motion_frame(*loaded.between, loaded.configuration.config(), loaded.change);
}

void tell_if_faces_share(const ref::Scene& scene, const Config& motion) {
  const int bits = model::face_bits_of(scene);
  if (bits <= motion.face_bits) return;
  std::fprintf(stderr,
               "halfspace: %s: faces share the %d numbers of configuration %s, so that a pixel may take the colour of "
               "another face: raise face_bits to %d\n",
               scene.name.c_str(), (1 << motion.face_bits) - 1, motion.name, bits);
}

void tell_if_unseen(const LoadedScene& loaded, bool covers) {
  if (covers || !loaded.scene) return;
  const ref::View view = ref::frame_view(loaded.list.format, loaded.list.width, loaded.list.height);
  std::fprintf(stderr, "halfspace: %s: nothing is in view: %s\n", loaded.name.c_str(),
               ref::why_unseen(*loaded.scene, view).c_str());
}

std::unique_ptr<model::Engine> kernels_of(const LoadedScene& loaded, int lanes) {
  auto engine = model::make_engine(loaded.configuration, lanes);
  if (has_lighting(loaded.configuration.config())) engine->light(lighting_of(loaded));
  if (has_texture(loaded.configuration.config())) engine->texture(texture_of(loaded));
  if (!shades(loaded.configuration.config())) engine->move(motion_of(loaded));
  return engine;
}

ref::Frame frame_of(const ref::SnappedList& list, ref::Drawing drawing) {
  ref::Frame frame{
      list.width, list.height, std::move(drawing.triangle), std::move(drawing.depth), std::move(drawing.colour), {},
      {},         {}};
  frame.visible = std::move(drawing.visible);
  return frame;
}

ref::Frame reference_of(const LoadedScene& loaded) {
  const Config config = loaded.configuration.config();
  if ((!has_lighting(config) && !has_texture(config)) || !loaded.scene) return ref::render(loaded.list);
  ref::Geometry geometry = geometry_of(loaded);
  ref::SnappedList list = loaded.list;
  if (has_lighting(config) && !is_phong(config))
    list = ref::distantly_lit(std::move(list), geometry, model::most_squarings(config));
  auto surface = is_phong(config)
                     ? ref::lit_surface(geometry, list, ref::ShadingMode::kPhong, model::most_squarings(config))
                     : ref::given_surface(list);
  if (has_texture(config)) {
    surface = ref::textured_surface(std::move(surface), geometry, list, texture_mode(config));
  }
  return frame_of(list, ref::draw(list, *surface, ref::Architecture::kDelta));
}

// "T0:T1", T0 before T1.
ref::OfKeys<double> interval_of(const SceneInput& input) {
  const std::string& text = input.interval;
  ref::OfKeys<double> times{};
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, times[0]);
  const bool has_colon = first.ec == std::errc() && first.ptr != end && *first.ptr == ':';
  const auto second = has_colon ? std::from_chars(first.ptr + 1, end, times[1]) : first;
  if (!has_colon || second.ec != std::errc() || second.ptr != end || !(times[0] < times[1]) ||
      !std::isfinite(times[0]) || !std::isfinite(times[1])) {
    throw ref::Error(fmt::format("--interval {}: not the times of two key frames: write it like 0.1:0.3", text));
  }
  if (input.time < times[0] || input.time > times[1]) {
    throw ref::Error(
        fmt::format("--time {}: not between the key frames of --interval {}: choose another", input.time, text));
  }
  return times;
}

namespace {

// The triangles in between, by their exact positions.
LoadedScene load_between(const SceneInput& input, const model::Configuration& configuration) {
  if (input.interval.empty() || ref::is_tri_file(input.scene)) {
    throw ref::Error(fmt::format(
        "{}: configuration {} is of frames between key frames: name an animated scene, and the times by --time and "
        "--interval T0:T1",
        input.scene, configuration.name()));
  }
  const ref::OfKeys<double> times = interval_of(input);
  const ref::RasterFormat format = model::raster_format(configuration);
  const FrameSize size = input.size.empty() ? FrameSize{format.width, format.height} : parse_size(input.size);
  const SceneSource source(input.scene, input.choice);
  const auto scene = std::make_shared<ref::Scene>(source.at(input.time));
  tell_if_faces_share(*scene, configuration.config());
  const ref::View view{size.width, size.height, format.range_bits, format.subpixel_bits};
  const ref::OfKeys<ref::Scene> keys{source.at(times[0]), source.at(times[1])};
  const double a = (input.time - times[0]) / (times[1] - times[0]);
  const auto between =
      std::make_shared<ref::Between>(ref::follow(ref::MotionMethod::kExact, keys[0], keys[1], *scene, a, view));
  LoadedScene loaded{input.scene,   snap_scene(input.scene, between->list, format),
                     configuration, [scene](const ref::View& v) { return ref::project(*scene, v); },
                     scene,         between};
  if (!relights(configuration.config())) return loaded;
  loaded.change =
      model::light_changes(*scene, {&keys[0], &keys[1]}, view, model::colour_configuration(configuration).config());
  return loaded;
}

}  // namespace

LoadedScene load_snapped(const SceneInput& input) {
  FrameSize size;
  if (!input.size.empty()) size = parse_size(input.size);
  const model::Configuration chosen = model::find_configuration(input.config.empty() ? "middle" : input.config);
  if (!shades(chosen.config())) return load_between(input, chosen);
  if (!input.interval.empty()) {
    throw ref::Error(
        fmt::format("--interval {}: configuration {} shades frames: leave it out, or name a configuration with shading "
                    "= \"motion\"",
                    input.interval, chosen.name()));
  }
  const ref::RasterFormat first = model::raster_format(chosen);

  model::Projection project;
  std::shared_ptr<ref::Scene> scene;
  if (ref::is_tri_file(input.scene)) {
    const auto list = std::make_shared<ref::TriangleList>(ref::read_tri(input.scene));
    if (!input.size.empty() && (size.width != list->width || size.height != list->height)) {
      throw ref::Error(fmt::format("{}: its frame is {}x{}, not {}: leave out --size", input.scene, list->width,
                                   list->height, input.size));
    }
    project = [list](const ref::View&) { return *list; };
  } else {
    if (size.width == 0) size = {first.width, first.height};
    if (!input.config.empty() && !fits(size, first)) {  // before the work of reading a mesh
      ref::TriangleList empty;
      empty.width = size.width;
      empty.height = size.height;
      snap_scene(input.scene, empty, first);  // throws
    }
    scene = std::make_shared<ref::Scene>(
        SceneSource(input.scene, input.choice, has_texture(chosen.config())).at(input.time));
    for (const std::string& loss : model::fit_textures(*scene, chosen.config()))
      std::fprintf(stderr, "warning: %s\n", loss.c_str());
    project = [scene](const ref::View& view) { return ref::project(*scene, view); };
  }
  auto snapped = [&](const model::Configuration& configuration) -> LoadedScene {
    ref::RasterFormat format = model::raster_format(configuration);
    if (input.window != 0 || gives_indices(configuration.config())) format.triangles = std::numeric_limits<int>::max();
    const ref::TriangleList list = project(ref::frame_view(format, size.width, size.height));
    return {input.scene, snap_scene(input.scene, list, format), configuration, project, scene, nullptr};
  };
  if (!input.config.empty()) return snapped(chosen);
  // Not said: middle if the scene fits it.
  try {
    return snapped(chosen);
  } catch (const ref::Misfit&) {
    return snapped(model::find_configuration("high"));
  }
}

}  // namespace halfspace::cli
