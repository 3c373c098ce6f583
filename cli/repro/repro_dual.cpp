// SPDX-License-Identifier: Apache-2.0
#include "cli/repro/repro_dual.hpp"

#include <fmt/format.h>

#include <memory>

#include "cli/commands.hpp"
#include "cli/repro/repro_options.hpp"
#include "cli/repro/repro_plots.hpp"
#include "study/papers/lighting_cost.hpp"

namespace halfspace::cli {
namespace {

using model::Operations;
using model::TriangleCounts;

// As printed: of one model the counts but c, of the other shares alone, of which 10,000 triangles are taken.
constexpr std::uint64_t kDolphinsA = 3000, kDolphinsB = 1451;
constexpr model::PrintedShares kDolphinsShares{83, 40, 78.4, 52.6};
constexpr TriangleCounts kCastle{10000, 4545, 2000};

// A model, and what its c counts.
struct Counted {
  std::string name, visible;
  TriangleCounts counts;
};

struct Type {
  const char* name;
  Operations (*of)(const TriangleCounts&);
};
constexpr Type kTypes[] = {{"type I", model::type_1}, {"type II", model::type_2}, {"dual", model::dual}};

// Multiplications of a type, from those of the operations.
std::string formula_of(const Type& type) {
  const std::uint64_t view = model::kViewing.multiplications, perspective = model::kPerspective.multiplications,
                      light = model::kLighting.multiplications;
  if (type.of == model::type_1) return fmt::format("3·[a·({} + {} + {}) + b·{}]", view, perspective, view, light);
  if (type.of == model::type_2) return fmt::format("3·a·({} + {} + {} + {})", view, perspective, view, light);
  return fmt::format("3·[a·({} + {}) + c·({} + {})]", view, perspective, view, light);
}

double cost(const Operations& operations) { return double(operations.cost()); }
std::string thousands(double number) { return grouped(std::uint64_t(number / 1e3 + 0.5)) + "k"; }

std::pair<std::uint64_t, std::uint64_t> dolphins_visible() {
  return model::visible_of(kDolphinsA, kDolphinsB, kDolphinsShares);
}

Table table_of_counts(const std::vector<Counted>& models) {
  Table table{
      "counts",
      fmt::format("Triangles, 320x200, and the instructions of the geometry stage by the paper's cost model; a: "
                  "of the model; b: face the viewer in the frame;\n"
                  "c: visible: \"seen\", that the finished picture shows, as the paper counts, or \"passed\", of "
                  "which a fragment passed the Z-test,\nwhich is what the mechanism knows when it lights. The "
                  "c of dolphins is inferred: {} to {} give the four percentages printed;\n"
                  "castle, printed: of 10,000 triangles",
                  grouped(dolphins_visible().first), grouped(dolphins_visible().second)),
      {{"320x200", "c", "a", "b", "c", "c/b", "c/a", "type I", "type II", "dual", "of type I", "of type II"}}};
  for (const Counted& m : models) {
    const TriangleCounts& n = m.counts;
    const double one = cost(type_1(n)), two = cost(type_2(n)), both = cost(dual(n));
    table.rows.push_back({m.name, m.visible, grouped(n.a), grouped(n.b), grouped(n.c), share(double(n.c), double(n.b)),
                          share(double(n.c), double(n.a)), thousands(one), thousands(two), thousands(both),
                          share(both, one), share(both, two)});
  }
  return table;
}

Table table_of_operations(const std::vector<Counted>& models) {
  std::string formulas;
  for (const Type& type : kTypes) formulas += fmt::format("\n  {:<8} MUL = {}", type.name, formula_of(type));
  Table table{
      "operations",
      "Operations. A vertex takes 12 MUL and 9 ADD to transform its position, 5 and 1 for the perspective, 12 "
      "and 9 to transform its normal,\n34, 19 and 3 reciprocal roots (RSQ) to light; instructions = 2 MUL + ADD "
      "+ 16 RSQ; three vertices a triangle:" +
          formulas + "\nThe paper prints 409,002 MUL, 254k ADD, 13k RSQ and 1,281k instructions of dolphins, type I",
      {{"320x200", "c", "", "MUL", "ADD", "RSQ", "instructions"}}};
  for (const Counted& m : models) {
    for (const Type& type : kTypes) {
      if (m.visible == "passed" && type.of != model::dual) continue;  // the others go by a and b alone
      const Operations n = type.of(m.counts);
      table.rows.push_back({m.name, m.visible, type.name, grouped(n.multiplications), grouped(n.additions),
                            grouped(n.reciprocal_roots), grouped(n.cost())});
    }
  }
  return table;
}

Table table_of_time(const std::vector<std::pair<std::string, model::LightingCost>>& costs) {
  Table table{"time",
              "Time of our geometry stage, ms, one thread; a corner that triangles share is lit once",
              {{"320x200", "positions", "lighting all b", "lighting passed c", "of all b", "corners lit"}}};
  for (const auto& [name, cost] : costs) {
    table.rows.push_back({short_name(name), fmt::format("{:.3f}", cost.positions_ms),
                          fmt::format("{:.3f}", cost.light_facing_ms), fmt::format("{:.3f}", cost.light_visible_ms),
                          share(cost.light_visible_ms, cost.light_facing_ms),
                          fmt::format("{} of {}", grouped(cost.corners_visible), grouped(cost.corners_facing))});
  }
  return table;
}

Json json_of(const TriangleCounts& n) {
  Json json = {{"a", n.a}, {"b", n.b}, {"c", n.c}};
  constexpr const char* kNames[] = {"type_1", "type_2", "dual"};
  for (std::size_t t = 0; t < std::size(kTypes); ++t) {
    const Operations o = kTypes[t].of(n);
    json[kNames[t]] = {
        {"mul", o.multiplications}, {"add", o.additions}, {"rsq", o.reciprocal_roots}, {"instructions", o.cost()}};
  }
  return json;
}

Json json_of(const std::string& name, const model::LightingCost& cost) {
  return {{"scene", name},
          {"passed", json_of(cost.passed)},
          {"seen", json_of(cost.seen)},
          {"positions_ms", cost.positions_ms},
          {"light_facing_ms", cost.light_facing_ms},
          {"light_visible_ms", cost.light_visible_ms},
          {"corners_facing", cost.corners_facing},
          {"corners_visible", cost.corners_visible}};
}

void dual_pipeline(const ReproModelOptions& options) {
  const TriangleCounts dolphins{kDolphinsA, kDolphinsB, dolphins_visible().first};
  std::vector<Counted> models = {{"dolphins, printed", "seen: inferred", dolphins},
                                 {"castle, printed", "seen", kCastle}};
  Json json = {{"paper", "dual pipeline"},
               {"printed", {{"dolphins", json_of(dolphins)}, {"castle", json_of(kCastle)}}},
               {"inferred", {{"first", dolphins_visible().first}, {"last", dolphins_visible().second}}},
               {"measured", Json::array()}};
  std::vector<std::pair<std::string, model::LightingCost>> costs;
  for (const std::string& name : options.scenes) {
    const model::LightingCost cost = model::measure_lighting(ref::load_scene(name), "low", 320, 200);
    models.push_back({short_name(name), "seen", cost.seen});
    models.push_back({short_name(name), "passed", cost.passed});
    json["measured"].push_back(json_of(name, cost));
    costs.emplace_back(name, cost);
  }
  print_tables({table_of_counts(models), table_of_operations(models), table_of_time(costs)}, options.tables);
  write_json(options.json, json);
  if (options.out.empty()) return;
  for (const std::string& picture : plot_lighting_cost(json, options.out)) fmt::print("{}\n", picture);
}

}  // namespace

void add_repro_dual(CLI::App& repro) {
  auto options = std::make_shared<ReproModelOptions>();
  options->scenes = {"teapot", "castle"};
  CLI::App* paper = repro.add_subcommand("B", "dual pipeline");
  add_model_options(paper, *options, {"counts", "operations", "time"});
  paper->callback([options] {
    if (!options->out.empty()) model::make_folder(options->out);
    dual_pipeline(*options);
  });
}

}  // namespace halfspace::cli
