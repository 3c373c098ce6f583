// SPDX-License-Identifier: Apache-2.0
#include "cli/common/area.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "cli/common/files.hpp"
#include "cli/common/program.hpp"
#include "model/package/package.hpp"
#include "ref/error.hpp"
#include "vectors/staging.hpp"

namespace halfspace::cli {
namespace {

namespace fs = std::filesystem;

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ",") + word;
  return text;
}

}  // namespace

std::vector<std::string> area_targets(const std::string& text) {
  std::vector<std::string> known = {"xilinx", "ecp5", "ice40"};
  if (text == "none") return {};
  if (text == "all") return known;
  std::vector<std::string> targets;
  std::stringstream list(text);
  for (std::string word; std::getline(list, word, ',');) {
    if (std::find(known.begin(), known.end(), word) == known.end()) {
      throw ref::Error(
          fmt::format("--area {}: there is no target '{}': use {}, all or none", text, word, joined(known)));
    }
    if (std::find(targets.begin(), targets.end(), word) == targets.end()) targets.push_back(word);
  }
  if (targets.empty()) throw ref::Error(fmt::format("--area: no target is named: use {}, all or none", joined(known)));
  return targets;
}

std::string area_sources() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(data_file("rtl"))) {
    if (entry.path().extension() == ".sv" || entry.path().extension() == ".py") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::ostringstream all;
  for (const fs::path& file : files) all << file.filename().string() << '\n' << std::ifstream(file).rdbuf();
  return all.str();
}

Json measure_area(const model::Configuration& configuration, const std::vector<std::string>& targets,
                  const std::string& work) {
  const fs::path folder(work);
  fs::create_directories(folder);
  const std::string package = (folder / "hs_formats_pkg.sv").string(), json = (folder / "area.json").string();
  const std::string log = (folder / "area.log").string();
  model::write_file(package, model::formats_package(configuration));
  const ProgramEnd end =
      run_program({"python3", data_file("rtl/synth/area.py"), "--package", package, "--lanes",
                   std::to_string(configuration.config().lanes), "--targets", joined(targets), "--json", json});
  model::write_file(log, end.output + end.said);
  std::ifstream file(json);
  const Json result = Json::parse(file, nullptr, false);
  if (end.status != 0 || result.is_discarded() || !result.contains("rows")) {
    throw ref::Error(fmt::format("{}: the area tool ended with status {}: its words are in {}", configuration.name(),
                                 end.status, log));
  }
  Json rows = Json::array();
  for (Json row : result["rows"]) {
    for (const char* name : {"package", "config", "cells"}) row.erase(name);
    rows.push_back(row);
  }
  fs::remove_all(folder);
  return {{"rows", rows}, {"buffers", result["buffers"]}, {"yosys", result["yosys"]}};
}

}  // namespace halfspace::cli
