// SPDX-License-Identifier: Apache-2.0
// halfspace config and halfspace package
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>

#include "cli/commands.hpp"
#include "cli/common/area.hpp"
#include "cli/common/output.hpp"
#include "cli/common/progress.hpp"
#include "cli/parts/parts.hpp"
#include "model/formats/configuration.hpp"
#include "model/formats/format_fields.hpp"
#include "model/formats/random_configuration.hpp"
#include "model/package/package.hpp"
#include "vectors/staging.hpp"

namespace halfspace::cli {
namespace {

using model::Configuration;

Json config_json(const Configuration& configuration) {
  const Config c = configuration.config();
  Json json = {{"name", configuration.name()}};
  json.update(to_json(c));
  const FormatTable table = format_table(c);
  for (const model::FormatField& field : model::format_fields()) {
    if (!field.is_used(c)) continue;
    const NumberFormat format = table.*field.format;
    json["formats"][field.name] = {{"width", format.width}, {"integer", format.integer}, {"signed", format.is_signed}};
  }
  return json;
}

// Columns of the configurations beside each other; in Markdown for the documentation.
void print_table(const std::vector<Configuration>& configurations, bool markdown) {
  auto row = [&](const std::string& first, const std::vector<std::string>& cells, const std::string& why) {
    std::string line = markdown ? "| " + first : fmt::format("{:<22}", first);
    for (const std::string& cell : cells) line += markdown ? " | " + cell : fmt::format(" {:>12}", cell);
    std::string reason = why;
    for (std::size_t at = 0; markdown && (at = reason.find('|', at)) != std::string::npos; at += 2)
      reason.insert(at, "\\");
    line += markdown ? " | " + reason + " |" : "  " + reason;
    fmt::print("{}\n", line.substr(0, line.find_last_not_of(' ') + 1));
  };
  std::vector<std::string> names, rule;
  for (const Configuration& c : configurations) names.push_back(c.name()), rule.push_back("---");
  row("", names, "");
  if (markdown) row("---", rule, "---");
  // What some of them have.
  auto rows = [&](auto is_there, auto cell_of, const char* name, const char* what) {
    std::vector<std::string> cells;
    bool any = false;
    for (const Configuration& configuration : configurations) {
      const Config c = configuration.config();
      any = any || is_there(c);
      cells.push_back(cell_of(c));
    }
    if (any) row(name, cells, what);
  };
  for (const model::ConfigField& field : model::config_fields()) {
    rows([&](const Config& c) { return has_part(field.part, c); }, [&](const Config& c) { return field.text(c); },
         field.name, field.what);
  }
  for (const model::FormatField& field : model::format_fields()) {
    const auto cell = [&](const Config& c) {
      return field.is_used(c) ? model::format_name(format_table(c).*field.format) : "–";
    };
    rows(field.is_used, cell, field.name, field.why);
  }
}

struct ConfigOptions {
  std::vector<std::string> configurations = {"low", "middle", "high"};
  std::string header, toml, json, area = "none", work = "area_of_parts";
  bool markdown = false, parts = false, is_small = false;
  std::optional<std::uint64_t> random;
};

// What the pipeline takes with one lane, for each family that is asked for.
struct Needs {
  std::string name;
  std::vector<std::optional<Circuit>> circuits;
  std::vector<std::uint64_t> blocks;
};

std::string cell(const std::optional<Circuit>& circuit) {
  return circuit ? fmt::format("{} / {} / {}", circuit->luts, circuit->multipliers, circuit->blocks) : "–";
}

Json print_parts(const ConfigOptions& options, const std::vector<Configuration>& configurations) {
  const std::vector<std::string> targets = area_targets(options.area);
  std::vector<const Family*> families;
  for (const Fpga& part : parts()) {
    if (families.empty() || families.back() != part.family) families.push_back(part.family);
  }
  std::vector<Needs> needs;
  for (const Configuration& configuration : configurations) {
    Config alone = configuration.config();
    alone.lanes = 1;
    const Configuration one(configuration.name(), alone);
    Json area;
    if (!targets.empty()) {
      const Waiting waiting(fmt::format("area of {} by Yosys, some minutes", one.name()));
      area = measure_area(one, targets, options.work);
    }
    Needs& mine = needs.emplace_back(Needs{one.name(), {}, {}});
    for (const Family* family : families) {
      const bool measured = std::find(targets.begin(), targets.end(), family->target) != targets.end();
      mine.circuits.push_back(measured ? measured_circuit(area, *family) : known_circuit(one.name(), *family));
      mine.blocks.push_back(frame_blocks(one, *family));
    }
  }
  const auto row = [&](const std::string& first, const auto& cell_of, const std::string& last) {
    std::string line = options.markdown ? "| " + first : fmt::format("{:<46}", first);
    for (const Needs& one : needs)
      line += options.markdown ? " | " + cell_of(one) : fmt::format(" {:>19}", cell_of(one));
    line += options.markdown ? " | " + last + " |" : "  " + last;
    fmt::print("{}\n", line.substr(0, line.find_last_not_of(' ') + 1));
  };
  row(
      "one lane", [](const Needs& one) { return one.name; }, "");
  if (options.markdown)
    row(
        "---", [](const Needs&) { return std::string("---"); }, "---");
  Json json = Json::object();
  for (std::size_t f = 0; f < families.size(); ++f) {
    row(
        fmt::format("{}: blocks of {} kbit for a frame", families[f]->title, families[f]->block_kbit),
        [&](const Needs& one) { return fmt::format("{}", one.blocks[f]); }, "");
    row(
        fmt::format("{}: LUTs / multipliers / blocks besides", families[f]->title),
        [&](const Needs& one) { return cell(one.circuits[f]); }, "");
  }
  for (const Fpga& part : parts()) {
    const auto f = std::size_t(std::find(families.begin(), families.end(), part.family) - families.begin());
    const std::string has = options.markdown
                                ? fmt::format("`{}`: {} LUTs, {} multipliers, {} × {} kbit", part.name, part.luts,
                                              part.multipliers, part.blocks, part.family->block_kbit)
                                : fmt::format("{:<10} {:>7} LUTs {:>4} mult. {:>4} x {:>2} kbit", part.name, part.luts,
                                              part.multipliers, part.blocks, part.family->block_kbit);
    row(
        has, [&](const Needs& one) { return holds(part, one.circuits[f], one.blocks[f]); },
        std::string(part.source) + (*part.besides ? ", and " + std::string(part.besides) : ""));
    for (const Needs& one : needs) json[one.name][part.name] = holds(part, one.circuits[f], one.blocks[f]);
  }
  if (options.markdown) return json;
  fmt::print(
      "inside: the part holds pipeline and memories of the frame; outside: the pipeline alone, if they lie elsewhere; "
      "no:\nwhat it has too little of; ?: by memory alone, as the circuit was not measured: --area does.\n");
  return json;
}

void config(const ConfigOptions& options) {
  std::vector<Configuration> configurations;
  if (options.random) {
    configurations.push_back(model::random_configuration(*options.random, options.is_small));
  } else {
    for (const std::string& name : options.configurations) configurations.push_back(model::find_configuration(name));
  }
  if ((!options.header.empty() || !options.toml.empty()) && configurations.size() != 1) {
    throw CLI::ValidationError("--header and --toml", "are of one configuration: name it");
  }
  if (!options.header.empty()) model::write_file(options.header, model::configuration_header(configurations[0]));
  if (!options.toml.empty()) model::write_file(options.toml, model::configuration_toml(configurations[0]));
  if (options.parts) return write_json(options.json, print_parts(options, configurations));
  Json json = Json::array();
  for (const Configuration& c : configurations) json.push_back(config_json(c));
  write_json(options.json, json);
  if (options.header.empty() && options.toml.empty()) print_table(configurations, options.markdown);
}

}  // namespace

void add_config(CLI::App& app, int&) {
  auto options = std::make_shared<ConfigOptions>();
  CLI::App* command = app.add_subcommand("config", "show configurations and the widths that follow from them");
  command->footer(
      "  halfspace config middle                      the numbers, and every width that follows\n"
      "  halfspace config middle --toml mine.toml     a configuration to begin with\n"
      "  halfspace config low middle --parts          which FPGAs hold them\n"
      "  halfspace config --random 7                  one that nobody named, accepted\n"
      "A configuration is a .toml file: every command takes its path in the place of a name. A combination that cannot "
      "be\nbuilt is refused with its reason.\n");
  command->add_option("CONFIG", options->configurations, "low, middle, high or .toml files")->capture_default_str();
  add_output_file(command, "--header", options->header, "C++ header to write, for hls/formats/configs/");
  add_output_file(command, "--toml", options->toml, "TOML file to write");
  CLI::Option* random = command->add_option("--random", options->random, "the accepted one that this seed draws")
                            ->excludes(command->get_option("CONFIG"));
  command->add_flag("--small", options->is_small, "of --random: a frame and tables that seconds of simulation fill")
      ->needs(random);
  command->add_flag("--markdown", options->markdown, "the table in Markdown");
  command->add_flag("--parts", options->parts,
                    "block RAMs, LUTs and multipliers of the pipeline, and which of ten FPGAs hold it, the memories of "
                    "the frame inside or outside");
  command
      ->add_option("--area", options->area,
                   "with --parts: targets for Yosys, which takes minutes: xilinx,ecp5,ice40, all, or none")
      ->capture_default_str();
  add_output_folder(command, "--work", options->work, "with --parts --area: folder while Yosys runs");
  add_json(command, options->json);
  command->callback([options] { config(*options); });
}

void add_package(CLI::App& app, int&) {
  auto config = std::make_shared<std::string>("middle");
  auto output = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("package", "print the SystemVerilog package of a configuration");
  command->footer("  halfspace package --config low -o hs_formats_pkg.sv\n");
  command->add_option("--config", *config, "low, middle, high or a .toml file")->capture_default_str();
  add_output_file(command, "-o,--output", *output, "file to write; default: standard output");
  command->callback([config, output] {
    const std::string text = model::formats_package(model::find_configuration(*config));
    if (output->empty()) std::fputs(text.c_str(), stdout);
    else model::write_file(*output, text);
  });
}

}  // namespace halfspace::cli
