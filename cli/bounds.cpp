// SPDX-License-Identifier: Apache-2.0
// halfspace bounds
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <sstream>

#include "cli/commands.hpp"
#include "cli/common/output.hpp"
#include "cli/common/progress.hpp"
#include "ref/geometry/triangle_list.hpp"
#include "study/bounds/bounds.hpp"
#include "study/proofs/gappa.hpp"
#include "vectors/staging.hpp"

namespace halfspace::cli {
namespace {

using model::BoundRow;
using model::BoundsReport;
using model::Configuration;

struct BoundsOptions {
  std::string config = "middle", gappa, json;
  model::MeasureOptions measure;
  bool markdown = false, verbose = false;
};

// The frame and the one triangle, as a *.tri file.
std::string tri_text(const Configuration& configuration, const ref::SnappedTriangle& triangle) {
  const ref::RasterFormat format = model::raster_format(configuration);
  std::ostringstream text;
  ref::write_tri(text, ref::unsnap({format, format.width, format.height, {}, {triangle}}));
  return text.str();
}

std::string place(const model::Witness& where) {
  if (where.number == 0) return "–";
  if (where.x < 0) return where.is_triangle ? fmt::format("{} {}", where.kind, where.number) : where.kind;
  return fmt::format("{} {}, pixel ({}, {})", where.kind, where.number, where.x, where.y);
}

// Of UTF-8 text: its bytes but those that continue a character.
std::size_t width(const std::string& text) {
  return std::size_t(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

// Padded columns, or Markdown. The first row is the heading.
void print_table(const std::vector<std::vector<std::string>>& rows, bool markdown) {
  std::vector<std::size_t> widths(rows[0].size(), 0);
  for (const auto& row : rows) {
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], width(row[c]));
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line = markdown ? "|" : "";
    for (std::size_t c = 0; c < row.size(); ++c) {
      line += markdown ? " " + row[c] + " |" : row[c] + std::string(widths[c] - width(row[c]) + 2, ' ');
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    if (markdown && &row == &rows[0]) {
      for (std::size_t c = 0; c < row.size(); ++c) text += "|---";
      text += "|\n";
    }
  }
  std::fputs(text.c_str(), stdout);
}

// What the configuration has planes of.
std::vector<model::PlaneKind> planes_of(const BoundsReport& report) {
  std::vector<model::PlaneKind> kinds;
  for (int n = 0; n < model::kPlaneKinds; ++n) {
    const auto kind = model::PlaneKind(n);
    if (report.rows[model::plane_row(kind)].present()) kinds.push_back(kind);
  }
  return kinds;
}

std::string seen_text(const BoundRow& row) {
  if (row.compared == 0) return "–";
  return row.exact() ? fmt::format("{} of {}", row.exceeded, row.compared) : fmt::format("{:.4g}", row.seen);
}

std::vector<std::string> cells(const BoundRow& row) {
  const bool share = !row.exact() && row.compared != 0;
  return {row.kernel,
          row.quantity,
          row.unit.empty() ? "–" : row.unit,
          row.exact() ? "exact" : fmt::format("{:.4g}", row.proved),
          seen_text(row),
          share ? fmt::format("{:.1f} %", 100 * row.seen / row.proved) : "–",
          row.exact() ? "–" : row.proof,
          place(row.where)};
}

void print_report(const Configuration& configuration, const BoundsReport& report, const BoundsOptions& options) {
  std::vector<std::vector<std::string>> rows = {
      {"kernel", "quantity", "unit", "proved", "seen", "share", "proof", "where"}};
  for (const BoundRow& row : report.rows) {
    if (row.present()) rows.push_back(cells(row));
  }
  print_table(rows, options.markdown);
  if (!report.classes.empty()) {
    fmt::print(
        "\nplanes at covered centres, before rounding: largest error in LSB, and its share of the bound there\n\n");
    rows = {{"class", "triangles", "pixels"}};
    for (const model::PlaneKind kind : planes_of(report)) {
      rows[0].push_back(model::plane_name(kind));
      rows[0].push_back("share");
    }
    for (const auto& c : report.classes) {
      rows.push_back({c.name, std::to_string(c.triangles), std::to_string(c.pixels)});
      for (const model::PlaneKind kind : planes_of(report)) {
        rows.back().push_back(fmt::format("{:.3g}", c.planes[kind].error));
        rows.back().push_back(fmt::format("{:.1f} %", 100 * c.planes[kind].share));
      }
    }
    print_table(rows, options.markdown);
  }
  if (!options.verbose) return;
  for (const BoundRow& row : report.rows) {
    if (!row.where.is_triangle) continue;
    fmt::print("\n# {}, {}: {}\n{}", row.kernel, row.quantity, place(row.where),
               tri_text(configuration, row.where.triangle));
  }
}

Json row_json(const Configuration& configuration, const BoundRow& row) {
  Json json = {{"kernel", row.kernel}, {"quantity", row.quantity}, {"unit", row.unit},        {"exact", row.exact()},
               {"proved", row.proved}, {"proof", row.proof},       {"compared", row.compared}};
  if (row.compared == 0) return json;
  json["seen"] = row.seen;
  json["exceeded"] = row.exceeded;
  if (!row.exact()) json["share"] = row.seen / row.proved;
  if (row.where.number == 0) return json;
  json["where"] = {{"class", row.where.kind}, {"number", row.where.number}};
  if (row.where.x >= 0) json["where"]["pixel"] = {row.where.x, row.where.y};
  if (row.where.is_triangle) json["where"]["tri"] = tri_text(configuration, row.where.triangle);
  return json;
}

int bounds(const BoundsOptions& options) {
  const Configuration configuration = model::find_configuration(options.config);
  if (!options.gappa.empty()) {
    model::StagedFolder folder(options.gappa);
    for (const auto& script : model::gappa_scripts(configuration.config()))
      folder.write(script.name + ".g", script.text);
    folder.commit();
  }
  Progress progress("bounds " + configuration.name());
  model::MeasureOptions measure = options.measure;
  measure.progress = [&](std::size_t done, std::size_t total) { progress.tell(done, total); };
  const bool measured = measure.triangles > 0;
  const BoundsReport report =
      measured ? model::measured_bounds(configuration, measure) : model::proved_bounds(configuration.config());

  print_report(configuration, report, options);
  Json json = {{"config", configuration.name()}, {"seed", measure.seed}, {"triangles", measure.triangles}};
  for (const BoundRow& row : report.rows) {
    if (row.present()) json["rows"].push_back(row_json(configuration, row));
  }
  for (const auto& c : report.classes) {
    Json row = {{"class", c.name}, {"triangles", c.triangles}, {"pixels", c.pixels}};
    for (const model::PlaneKind kind : planes_of(report)) {
      row[model::plane_name(kind)] = c.planes[kind].error;
      row[model::plane_name(kind) + std::string("_share")] = c.planes[kind].share;
    }
    json["classes"].push_back(row);
  }
  write_json(options.json, json);
  if (!measured || report.holds()) return 0;
  fmt::print(stderr, "halfspace: a bound of configuration {} does not hold: see the rows where seen is above proved\n",
             configuration.name());
  return 1;
}

}  // namespace

void add_bounds(CLI::App& app, int& status) {
  auto options = std::make_shared<BoundsOptions>();
  CLI::App* command = app.add_subcommand("bounds", "proved and seen errors of every kernel of a configuration");
  command->footer(
      "  halfspace bounds --config high                            proved and seen errors of each kernel\n"
      "  halfspace bounds --config low --triangles 0 --gappa proofs  the proofs alone, as scripts\n"
      "Errors are against exact arithmetic on the snapped triangle. `proof` names the script that proves the bound; "
      "write them\n"
      "with --gappa and run each with `gappa DIR/NAME.g`: it says nothing when it has proved it. `share` is "
      "seen/proved on\n"
      "the worst triangle of all; `where` is the class and number of that triangle, the same again for the same "
      "--seed.\n"
      "docs/bounds.md has the derivations.\n");
  command->add_option("--config", options->config, "low, middle, high or a .toml file")->capture_default_str();
  command
      ->add_option("--triangles", options->measure.triangles,
                   "triangles measured of each class; 0: print what is proved")
      ->capture_default_str()
      ->check(CLI::Range(0, 10000000));
  command->add_option("--seed", options->measure.seed, "of the triangles")->capture_default_str();
  add_output_folder(command, "--gappa", options->gappa, "folder for the proofs as Gappa scripts");
  command->add_flag("--markdown", options->markdown, "the tables in Markdown");
  command->add_flag("--verbose", options->verbose, "the worst triangles as .tri files as well");
  add_json(command, options->json);
  command->callback([options, &status] { status = bounds(*options); });
}

}  // namespace halfspace::cli
