// SPDX-License-Identifier: Apache-2.0
#include "cli/common/cosim.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/common/files.hpp"
#include "cli/common/progress.hpp"
#include "cli/common/shell.hpp"
#include "model/package/package.hpp"
#include "ref/error.hpp"
#include "vectors/staging.hpp"

namespace halfspace::cli {
namespace {

void run(const std::string& command, const std::string& log, const std::string& what) {
  if (std::system((command + " > " + shell_quoted(log) + " 2>&1").c_str()) != 0) {
    throw ref::Error(fmt::format("{} failed: read {}", what, log));
  }
}

}  // namespace

Cosimulation cosimulate(const std::string& folder, const std::string& scene, const model::Configuration& configuration,
                        int lanes, const std::vector<model::NamedFrame>& frames) {
  const std::filesystem::path work(folder);
  model::make_folder(folder);
  const std::string package = (work / "hs_formats_pkg.sv").string(), report = (work / "cosim.json").string();
  model::write_file(package, model::formats_package(configuration));
  {
    const Waiting waiting(scene + ": building the bench");
    run(fmt::format("python3 {} --package {} --lanes {} --out {} --library {} --library {}",
                    shell_quoted(data_file("tb/model.py")), shell_quoted(package), lanes,
                    shell_quoted((work / "model").string()), shell_quoted(bench_library("halfspace_tb")),
                    shell_quoted(bench_library("halfspace_verilated"))),
        (work / "model.log").string(), "building the bench");
  }
  model::write_vector_set((work / "vectors").string(), {scene, configuration, lanes, 0}, frames, nullptr);
  std::filesystem::remove(report);
  const Waiting waiting(scene + ": co-simulating");
  // Its status tells of mismatches as well: the report decides.
  const int status =
      std::system(fmt::format("{} {} --json {} > {} 2>&1", shell_quoted((work / "model" / "bench").string()),
                              shell_quoted((work / "vectors").string()), shell_quoted(report),
                              shell_quoted((work / "cosim.log").string()))
                      .c_str());
  std::ifstream file(report);
  const nlohmann::json json = nlohmann::json::parse(file, nullptr, false);
  if (!file || json.is_discarded()) {
    throw ref::Error(
        fmt::format("the co-simulation ended with status {}: read {}", status, (work / "cosim.log").string()));
  }
  Cosimulation result;
  for (const auto& one : json.at("runs")) {
    result.words += one.at("words").get<std::uint64_t>();
    result.mismatches += one.at("mismatches").get<std::uint64_t>() + one.at("failures").size();
    result.cycles = one.at("cycles").get<std::uint64_t>();
  }
  if (result.words == 0)
    throw ref::Error(fmt::format("the co-simulation compared nothing: read {}", (work / "cosim.log").string()));
  return result;
}

}  // namespace halfspace::cli
