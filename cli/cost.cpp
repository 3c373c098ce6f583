// SPDX-License-Identifier: Apache-2.0
// halfspace cost
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>

#include "cli/commands.hpp"
#include "cli/common/numbers.hpp"
#include "cli/common/output.hpp"
#include "cli/common/sequence.hpp"
#include "cli/motion/frame_cost.hpp"
#include "model/drivers/up_convert.hpp"
#include "model/pipeline/cycles.hpp"
#include "ref/error.hpp"
#include "ref/geometry/viewpoint.hpp"
#include "ref/motion/quality.hpp"
#include "ref/objects/static_instances.hpp"

namespace halfspace::cli {
namespace {

struct CostOptions {
  ref::SceneChoice choice;
  std::string scene, config = "middle", size = "320x240", json;
  int first = 0, lanes = 4, lights = 4;
  bool half = false, markdown = false;
};

// A frame with an S-buffer, of which an entry {depth, object, colour} a pixel is read, rendered and made of keys, and
// last the drawing of that buffer, which writes them. Each merge takes a stamp a cycle.
std::vector<Cost> with_static_buffer(const model::KernelUpConversion& mode, const ref::Scene& first,
                                     const ref::Scene& between, const ref::Scene& second,
                                     const std::vector<bool>& still, double picture_pixels,
                                     const CostOptions& options) {
  const Config colour = mode.colour.config();
  const int samples = mode.motion.config().samples;
  const ref::View view{mode.width * samples, mode.height * samples, colour.range_bits, colour.subpixel_bits};
  model::KernelUpConversion with = mode;
  with.static_buffer = true;
  model::KernelUpConverter converter(with);
  converter.set_keys(first, second);
  std::vector<bool> moves = still;
  moves.flip();
  const ref::TriangleList drawn = ref::project(between, view);
  const FrontEnd moving = front_end(mode.colour, ref::project(ref::without(between, still), view), options.lanes);
  const model::KernelFrameBetween frame = converter.at(between, 0.4);
  const FrontEnd standing = front_end(mode.colour, ref::project(ref::without(between, moves), view), options.lanes);
  const double entry = colour.depth_bits + bits_for(still.size()) + 3 * colour.colour_bits;
  const double entries = double(view.width) * view.height * entry / 8 / picture_pixels;
  const bool one = samples == 1;
  std::vector<Cost> costs{rendered(one ? "rendered, Gouraud, S-buffer" : "rendered, 4x4, Gouraud, S-buffer", moving,
                                   picture_pixels, false, 0),
                          rendered(one ? "rendered, Phong, S-buffer" : "rendered, 4x4, Phong, S-buffer", moving,
                                   picture_pixels, false, options.lights),
                          made(one ? "made of key frames, S-buffer" : "made, 4x4 samples, S-buffer", moving,
                               holes_end(drawn, frame, with, options.lanes), picture_pixels, frame, with),
                          rendered(one ? "the S-buffer, once, Gouraud" : "the S-buffer, once, 4x4, Gouraud", standing,
                                   picture_pixels, false, 0)};
  for (Cost& cost : costs) {
    take(cost, "ztest_merge", double(moving.stamps + 1));
    cost.bytes += entries;
  }
  costs.back().bytes = entries;
  return costs;
}

void cost(const CostOptions& options) {
  const FrameSize size = parse_size(options.size);
  const double aspect = double(size.width) / size.height;
  const SceneSource source(options.scene, options.choice);
  const auto scene_at = [&](int n) { return source.at(double(options.first + n) / kFramesASecond); };
  const ref::Scene first = scene_at(0), between = scene_at(2), second = scene_at(5);
  if (first.duration <= 0)
    throw ref::Error(fmt::format("{}: nothing moves in it: take an animated scene", options.scene));

  if (options.half) {
    if (size.width % 2 != 0 || size.height % 2 != 0)
      throw ref::Error(fmt::format("--size {}: half a field is of an even number of pixels each way", options.size));
    const model::Configuration chosen = model::find_configuration(options.config);
    const model::Configuration named = has_lighting(chosen.config()) ? model::unlit_configuration(chosen) : chosen;
    const HalfField halves = half_field(first, between, second, size.width, size.height, named, options.lanes);
    fmt::print("{}", text_of(table_of(halves, short_name(options.scene)), options.markdown));
    write_json(options.json, to_json(halves, options.scene));
    return;
  }

  std::array<ref::Scene, 3> held{first, between, second};
  const ref::DepthPlanes planes = ref::held_planes({&first, &between, &second}, aspect);
  for (ref::Scene& scene : held) scene.depth_planes = planes;
  const std::vector<bool> still = ref::static_instances(held[0], held[2], held[1], aspect);
  const auto standing = std::count(still.begin(), still.end(), true);

  Json json = {{"scene", options.scene},
               {"width", size.width},
               {"height", size.height},
               {"static_instances", standing},
               {"rows", Json::array()}};
  fmt::print(
      "{} {}: a frame between two keys five apart, rendered and made of them; {} lanes, {} lights\n\n"
      "{:<34} {:>10}  {:<18} {:>9} {:>9} {:>9} {:>9} {:>8} {:>8} {:>6} {:>7} {:>8}\n",
      options.scene, options.size, options.lanes, options.lights, "", "cycles", "slowest unit", "MUL/pixel", "B/pixel",
      "of cycles", "triangles", "words", "tiles", "again", "holes", "PSNR_Y");
  for (const int samples : {1, 4}) {
    const model::Configuration chosen = model::find_configuration(samples == 1 ? options.config : "high");
    const model::Configuration named = has_lighting(chosen.config()) ? model::unlit_configuration(chosen) : chosen;
    const int scale = samples;
    const ref::View view{size.width * scale, size.height * scale, named.config().range_bits,
                         named.config().subpixel_bits};
    const ref::TriangleList drawn = ref::project(between, view);
    const FrontEnd front = front_end(named, drawn, options.lanes);
    if (front.pixels == 0)
      throw ref::Error(
          fmt::format("{}: nothing of it is in frame {}: choose another by --first", options.scene, options.first + 2));
    const double picture_pixels = front.pixels / (samples * samples);
    Config numbers = model::default_motion(named.config(), &between);
    numbers.samples = samples;
    const model::Configuration motion = model::motion_configuration(named, numbers, view.width, view.height);
    const model::KernelUpConversion mode{size.width, size.height, named, motion};
    model::KernelUpConverter converter(mode);
    converter.set_keys(first, second);
    const model::KernelFrameBetween frame = converter.at(between, 0.4);
    const Cost up = made(samples == 1 ? "made of key frames" : "made, 4x4 samples", front,
                         holes_end(drawn, frame, mode, options.lanes), picture_pixels, frame, mode);
    const bool one = samples == 1;
    std::vector<Cost> rows = {
        rendered(one ? "rendered, Gouraud" : "rendered, 4x4 samples, Gouraud", front, picture_pixels, false, 0),
        rendered(one ? "rendered, texture" : "rendered, 4x4 samples, texture", front, picture_pixels, true, 0),
        rendered(one ? "rendered, Phong" : "rendered, 4x4 samples, Phong", front, picture_pixels, false,
                 options.lights),
        up};
    if (one && size.width % 2 == 0 && size.height % 2 == 0) {
      model::KernelUpConversion half = mode;
      half.half_field = true;
      const ref::View half_view{size.width / 2, size.height / 2, view.range_bits, view.subpixel_bits};
      const FrontEnd half_front = front_end(named, ref::project(between, half_view), options.lanes);
      model::KernelUpConverter half_converter(half);
      half_converter.set_keys(first, second);
      const model::KernelFrameBetween of_half = half_converter.at(between, 0.4);
      rows.push_back(made("made, a vector for 2x2 pixels", half_front, holes_end(drawn, of_half, half, options.lanes),
                          picture_pixels, of_half, half));
    }
    if (standing != 0) {
      const std::vector<Cost> with =
          with_static_buffer(mode, held[0], held[1], held[2], still, picture_pixels, options);
      rows.insert(rows.end(), with.begin(), with.end());
    }
    for (const Cost& row : rows) {
      fmt::print("{:<34} {:>10.0f}  {:<18} {:>9.1f} {:>9.1f} {:>8.0f}% {:>9} {:>8} {:>8} {:>6} {:>7} {:>8}\n", row.name,
                 row.cycles, row.slowest, row.multiplications, row.bytes, 100 * up.cycles / row.cycles, row.triangles,
                 row.words, row.tiles, row.again, row.holes, row.psnr ? fmt::format("{:.2f}", *row.psnr) : "");
      json["rows"].push_back({{"name", row.name},
                              {"samples", samples},
                              {"made", row.made},
                              {"cycles", row.cycles},
                              {"slowest", row.slowest},
                              {"multiplications_a_pixel", row.multiplications},
                              {"bytes_a_pixel", row.bytes},
                              {"made_of_this", up.cycles / row.cycles},
                              {"triangles", row.triangles},
                              {"motion_words", row.words},
                              {"cache_misses", row.tiles},
                              {"triangles_again", row.again},
                              {"hole_pixels", row.holes}});
      if (row.psnr) json["rows"].back()["psnr_y_db"] = *row.psnr;
    }
  }
  fmt::print(
      "\nA pixel is a covered one of the picture. Of cycles: those of the made frame, of this one's. Words are of "
      "motion, tiles of key frames. Again: triangles that are drawn once more, and shaded at holes alone, pixels or "
      "samples that no key shows; their cycles are in those of the units. dB of the made frame against the rendered "
      "one.\n");
  if (standing == 0) {
    fmt::print(
        "No instance stands still in all three frames, or the view or a light changes: an S-buffer would be empty.\n");
  } else {
    fmt::print(
        "{} of {} instances stand still. The S-buffer is drawn for all frames in which they do, and read in each.\n",
        standing, still.size());
  }
  write_json(options.json, json);
}

}  // namespace

void add_cost(CLI::App& app, int&) {
  auto options = std::make_shared<CostOptions>();
  CLI::App* command =
      app.add_subcommand("cost", "what a frame between key frames costs against rendering it, by shading");
  command->footer(
      "  halfspace cost cube_fast --size 160x120    cycles, multiplications and bytes, drawn and made of key frames\n");
  command
      ->add_option("SCENE", options->scene,
                   "an animated scene (" + builtin_names() + ") or a mesh file with an animation")
      ->required();
  add_scene_choice(command, options->choice);
  command->add_option("--config", options->config, "of the frames")->capture_default_str();
  command->add_option("--size", options->size, "frame, WxH")->capture_default_str();
  command->add_option("--first", options->first, "number of the first key frame")
      ->capture_default_str()
      ->check(zero_or_more());
  command->add_option("--lanes", options->lanes, "pixels a stamp: 1, 2, 4, 8, 16")->capture_default_str();
  command->add_option("--lights", options->lights, "of Phong shading, 1 to 4")
      ->capture_default_str()
      ->check(CLI::Range(1, 4));
  command->add_flag("--half", options->half, "only what a motion vector for 2x2 pixels saves and costs, unit by unit");
  command->add_flag("--markdown", options->markdown, "the table of --half for a page");
  add_json(command, options->json);
  command->callback([options] { cost(*options); });
}

}  // namespace halfspace::cli
