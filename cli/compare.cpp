// SPDX-License-Identifier: Apache-2.0
// halfspace compare
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "cli/commands.hpp"
#include "cli/common/output.hpp"
#include "ref/error.hpp"
#include "vectors/dump.hpp"
#include "vectors/staging.hpp"

namespace halfspace::cli {
namespace {

int compare(const std::string& a, const std::string& b, const std::string& json_path) {
  std::uint64_t values = 0, different = 0;
  Json parts = Json::array();
  for (const model::Difference& d : model::compare_folders(a, b)) {
    if (d.different == 0) {
      fmt::print("{}: {} values, equal\n", d.part, d.values);
    } else {
      fmt::print("{}: {} values, {} different{}; first {}\n", d.part, d.values, d.different,
                 d.largest ? fmt::format(", by {} at most", d.largest) : "", d.first);
    }
    values += d.values;
    different += d.different;
    parts.push_back({{"part", d.part},
                     {"values", d.values},
                     {"different", d.different},
                     {"largest", d.largest},
                     {"first", d.first}});
  }
  if (values == 0) throw ref::Error(fmt::format("{} and {}: there is nothing in them to compare", a, b));
  fmt::print("compare: {} values, {} different\n", values, different);
  write_json(json_path, {{"a", a}, {"b", b}, {"values", values}, {"different", different}, {"parts", parts}});
  return different == 0 ? 0 : 1;
}

}  // namespace

void add_compare(CLI::App& app, int& status) {
  struct Options {
    std::string a, b, json;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("compare", "hold two dumps or two vector sets against each other");
  command->footer(
      "What `halfspace render --dump A` wrote, or `halfspace vectors --out A`. Exit status 0: equal; 1: they differ, "
      "or "
      "cannot be read.\n");
  command->add_option("A", options->a, "folder of a dump or a vector set")->required();
  command->add_option("B", options->b, "another of the same kind")->required();
  add_json(command, options->json);
  command->callback([options, &status] { status = compare(options->a, options->b, options->json); });
}

}  // namespace halfspace::cli
