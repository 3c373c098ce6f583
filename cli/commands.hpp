// SPDX-License-Identifier: Apache-2.0
// The subcommands of halfspace. Each adds itself to the application and leaves its exit status in `status`.
#ifndef HALFSPACE_CLI_COMMANDS_HPP_
#define HALFSPACE_CLI_COMMANDS_HPP_

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "model/formats/configuration.hpp"
#include "model/pipeline/memories.hpp"
#include "ref/raster/architecture.hpp"
#include "study/trade/accuracy.hpp"

namespace halfspace::cli {

void add_render(CLI::App& app, int& status);
void add_vectors(CLI::App& app, int& status);
void add_compare(CLI::App& app, int& status);
void add_config(CLI::App& app, int& status);
void add_fit(CLI::App& app, int& status);
void add_package(CLI::App& app, int& status);
void add_inspect(CLI::App& app, int& status);
void add_streams(CLI::App& app, int& status);
void add_bounds(CLI::App& app, int& status);
void add_report(CLI::App& app, int& status);
void add_repro(CLI::App& app, int& status);
void add_stability(CLI::App& app, int& status);
void add_shrink(CLI::App& app, int& status);
void add_sweep(CLI::App& app, int& status);
void add_frames(CLI::App& app, int& status);
void add_static(CLI::App& app, int& status);
void add_foresee(CLI::App& app, int& status);
void add_holes(CLI::App& app, int& status);
void add_quality(CLI::App& app, int& status);
void add_cost(CLI::App& app, int& status);

using Json = nlohmann::ordered_json;

// To the file, or nowhere when `path` is empty.
void write_json(const std::string& path, const Json& json);
Json to_json(const model::Accuracy& accuracy);
// All numbers; those of what is not there are 0.
Json to_json(const Config& config);
// Those that are counted at streams; all of them, which the reference knows.
Json to_json(const ref::Rates& rates);
Json all_rates(const ref::Rates& rates);
// Accesses and bytes of the buffers that there are; with those of whole words, if they are given.
Json to_json(const ref::BufferUses& needed, const model::BufferBits& bits, const ref::BufferUses* words = nullptr);
Json to_json(const model::MemoryBits& bits);
// A scene in a title: no folder, no ending.
std::string short_name(const std::string& scene);
// "∞" for an infinite ratio.
std::string decibels(double psnr);

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_COMMANDS_HPP_
