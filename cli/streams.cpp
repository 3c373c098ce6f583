// SPDX-License-Identifier: Apache-2.0
// halfspace streams
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "cli/commands.hpp"
#include "cli/common/output.hpp"
#include "model/formats/stream_list.hpp"
#include "model/motion/compensation.hpp"
#include "model/objects/merge.hpp"
#include "model/pipeline/engine.hpp"

namespace halfspace::cli {
namespace {

using model::Layout;
using model::ListedStream;

struct Options {
  std::string config, json;
  int lanes = 0;
  bool markdown = false;
};

// Of the pipeline, and of the units beside it.
std::vector<Layout> layouts_of(const model::Configuration& configuration, int lanes) {
  std::vector<Layout> all = model::make_engine(configuration, lanes)->layouts();
  const auto add = [&](const std::vector<Layout>& more) {
    for (const Layout& layout : more) {
      const auto is_it = [&](const Layout& other) { return other.stream == layout.stream; };
      if (std::none_of(all.begin(), all.end(), is_it)) all.push_back(layout);
    }
  };
  if (up_converts(configuration.config())) add(model::Compensator(configuration).film_layouts());
  else if (has_motion(configuration.config())) add(model::Compensator(configuration).layouts());
  if (has_objects(configuration.config())) add(model::Merger(configuration, lanes).layouts());
  return all;
}

std::string joined(const std::vector<std::string>& units) {
  std::string text;
  for (const std::string& unit : units) text += (text.empty() ? "" : ", ") + unit;
  return text;
}

void print_row(bool markdown, const std::vector<std::string>& cells) {
  static const int kWidths[] = {20, 34, 34, 19, 8, 27, 0};
  std::string line = markdown ? "|" : "";
  for (std::size_t n = 0; n < cells.size(); ++n)
    line += markdown ? fmt::format(" {} |", cells[n]) : fmt::format("{:<{}} ", cells[n], kWidths[n]);
  fmt::print("{}\n", line.substr(0, line.find_last_not_of(' ') + 1));
}

void print_heading(bool markdown, const std::vector<std::string>& cells) {
  print_row(markdown, cells);
  if (markdown) print_row(true, std::vector<std::string>(cells.size(), "---"));
}

Json row_json(const StreamRow& row, const Json& from, const Json& to) {
  return {{"name", row.name},
          {"from", from},
          {"to", to},
          {"record", model::record_name(row)},
          {"kind", model::kind_name(row.kind)},
          {"when", row.when},
          {"what", row.what}};
}

// All that any configuration has, with the units that may stand at each end.
Json print_all(bool markdown) {
  const auto code = [&](const std::string& text) { return markdown ? "`" + text + "`" : text; };
  Json json = Json::array();
  print_heading(markdown, {"stream", "from", "to", "record", "kind", "when", "a word is"});
  for (const ListedStream& s : model::all_streams()) {
    print_row(markdown, {code(s.row.name), joined(s.from), joined(s.to), code(model::record_name(s.row)),
                         model::kind_name(s.row.kind), s.row.when, s.row.what});
    json.push_back(row_json(s.row, s.from, s.to));
  }
  return json;
}

// Those of a configuration, with the bits of a word.
Json print_configuration(const Options& options) {
  const model::Configuration configuration = model::find_configuration(options.config);
  const int lanes = options.lanes == 0 ? configuration.config().lanes : options.lanes;
  Json json = Json::array();
  print_heading(options.markdown, {"stream", "from", "to", "record", "bits", "when", "a word is"});
  for (const Layout& layout : layouts_of(configuration, lanes)) {
    const StreamRow& row = layout.row;
    print_row(options.markdown,
              {row.name, row.from, row.to, model::record_name(row), std::to_string(layout.bits), row.when, row.what});
    json.push_back(row_json(row, row.from, row.to));
    json.back()["bits"] = layout.bits;
  }
  return json;
}

}  // namespace

void add_streams(CLI::App& app, int&) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("streams", "the streams between the units: who sends what to whom, and when");
  command->footer(
      "  halfspace streams                  all that there are\n"
      "  halfspace streams low --lanes 4    those of a configuration\n"
      "Without CONFIG all streams that there are. kind: `stored` goes into a memory that always takes, `loaded` is "
      "there\nbefore the frame, `fetch` goes to or from a memory outside, `probe` is watched and no queue.\n");
  command->add_option("CONFIG", options->config, "those of this configuration alone, with the bits of their words");
  command->add_option("--lanes", options->lanes, "pixels of a stamp (default: those of the configuration)");
  command->add_flag("--markdown", options->markdown, "the table in Markdown");
  add_json(command, options->json, "the table");
  command->callback([options] {
    write_json(options->json, options->config.empty() ? print_all(options->markdown) : print_configuration(*options));
  });
}

}  // namespace halfspace::cli
