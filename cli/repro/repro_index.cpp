// SPDX-License-Identifier: Apache-2.0
#include "cli/repro/repro_index.hpp"

#include <fmt/format.h>

#include <memory>

#include "cli/commands.hpp"
#include "cli/common/progress.hpp"
#include "cli/repro/index_tables.hpp"
#include "cli/repro/repro_options.hpp"
#include "cli/repro/repro_plots.hpp"
#include "ref/builtin/box_texture.hpp"

namespace halfspace::cli {
namespace {

using model::HardwareLevel;
using model::WidePixel;
using ref::ShadingMode;

std::vector<DrawnModel> draw_all(const ReproModelOptions& options) {
  std::vector<DrawnModel> all;
  Progress progress("repro A: pictures");
  std::size_t total = 0;
  for (const HardwareLevel& level : model::hardware_levels()) total += level.sizes.size();
  total *= 2 * options.scenes.size() * std::size(ref::kShadingModes);
  for (const std::string& name : options.scenes) {
    const ref::Scene scene = ref::load_scene(name);
    for (const bool cull : {true, false}) {
      const ref::Scene plain = model::culled(scene, cull);
      ref::Scene bricks = plain;  // on all of it, so that every pixel takes a texel
      add_box_texture(bricks);
      for (const HardwareLevel& level : model::hardware_levels()) {
        for (const auto& [width, height] : level.sizes) {
          for (const ShadingMode mode : ref::kShadingModes) {
            const ref::Scene& drawn = mode == ShadingMode::kGouraud ? bricks : plain;
            all.push_back({name, cull, &level, width, height, mode,
                           model::measure_architectures(drawn, level.config, width, height, mode)});
            progress.tell(all.size(), total);
          }
        }
      }
    }
  }
  return all;
}

Json json_of(const model::BufferBytes& b) {
  return {{"depth_buffer", b.depth},
          {"frame_buffer", b.frame},
          {"pixel_buffer", b.pixel},
          {"index_buffer", b.index},
          {"visibility_database", b.visibility},
          {"shading_database", b.shading},
          {"total", b.total()}};
}

Json json_of(const DrawnModel& m) {
  Json row = {{"scene", m.scene}, {"culled", m.culled}, {"level", m.level->config},
              {"width", m.width}, {"height", m.height}, {"shading", name_of(m.mode)}};
  for (std::size_t n = 0; n < 4; ++n) row[name_of(ref::kArchitectures[n])] = all_rates(m.rates[n].rates);
  return row;
}

Json json_of(const BufferRow& r) {
  Json row = {{"scene", r.scene},   {"culled", r.culled},        {"level", r.level->config},  {"width", r.width},
              {"height", r.height}, {"frames", r.level->frames}, {"shading", name_of(r.mode)}};
  for (std::size_t n = 0; n < 4; ++n) row[name_of(ref::kArchitectures[n])] = json_of(r.bytes[n]);
  row["beta_colour"] = json_of(r.beta_colour);
  row["even_pixel_bits"] = r.even_bits;
  row["wide_pixel_bits"] = r.wide_bits;
  row["shading_database_every_pixel"] = r.shading_every_pixel;
  return row;
}

template <class Row>
Json all_json(const std::vector<Row>& rows) {
  Json json = Json::array();
  for (const Row& row : rows) json.push_back(json_of(row));
  return json;
}

void index_rendering(const ReproModelOptions& options) {
  // The others need no pictures.
  const bool pictures = !options.json.empty() || !options.out.empty() ||
                        (options.tables.only != "sizes" && options.tables.only != "worst");
  const std::vector<DrawnModel> drawn = pictures ? draw_all(options) : std::vector<DrawnModel>{};
  const std::vector<BufferRow> sizes = size_rows(), worst = worst_rows(), simulated = simulated_rows(drawn);
  print_tables({lightings_table(drawn), sizes_table(sizes), worst_table(worst), simulated_table(simulated),
                claims_table(worst, simulated)},
               options.tables);
  Json json = {{"paper", "index rendering"}};
  json["lightings"] = all_json(drawn);
  json["sizes"] = all_json(sizes);
  json["worst"] = all_json(worst);
  json["simulated"] = all_json(simulated);
  write_json(options.json, json);
  if (options.out.empty()) return;
  for (const std::string& picture : plot_index_rendering(json, options.out)) fmt::print("{}\n", picture);
}

}  // namespace

void add_repro_index(CLI::App& repro) {
  auto options = std::make_shared<ReproModelOptions>();
  CLI::App* paper = repro.add_subcommand("A", "index rendering");
  add_model_options(paper, *options, {"lightings", "sizes", "worst", "simulated", "claims"});
  paper->callback([options] {
    if (!options->out.empty()) model::make_folder(options->out);
    index_rendering(*options);
  });
}

}  // namespace halfspace::cli
