// SPDX-License-Identifier: Apache-2.0
#include "cli/sweep/sweep_table.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <map>

#include "model/formats/stamps.hpp"
#include "model/pipeline/memories.hpp"
#include "model/pipeline/multipliers.hpp"
#include "ref/error.hpp"
#include "study/trade/motion_trade.hpp"
#include "vectors/staging.hpp"

namespace halfspace::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kAreaColumns[] = {"lut", "ff", "dsp", "bram", "carry", "depth"};

// The whole pipeline's row of each target; the bits of the memories of the frame.
void add_area(const Sweep& sweep, const Json& area, Json& row) {
  for (const std::string& target : sweep.targets) {
    for (const char* column : kAreaColumns) row[fmt::format("{}_{}", column, target)] = nullptr;
    for (const Json& measured : area.value("rows", Json::array())) {
      if (measured["unit"] != "pipeline" || measured["target"] != target) continue;
      for (const char* column : kAreaColumns)
        row[fmt::format("{}_{}", column, target)] = measured.value(column, Json());
    }
  }
  if (sweep.targets.empty()) return;
  std::uint64_t bits = 0;
  for (const Json& buffer : area.value("buffers", Json::array())) bits += buffer.value("bits", std::uint64_t(0));
  row["buffer_bits"] = bits ? Json(bits) : Json(nullptr);
}

// What needs no synthesis: the memories of a frame, and the multipliers.
void add_costs(const SweepConfig& config, Json& row) {
  row["memory_bits"] = row["multiplier_bits"] = nullptr;
  if (!config.refused.empty()) return;
  const model::StampSize stamp = model::stamp_size(config.numbers.lanes);
  row["memory_bits"] = model::memory_bits(config.numbers, stamp.x, stamp.y).total() +
                       model::texture_bits(config.numbers).total() +
                       (has_motion(config.numbers) ? model::key_frame_bits(config.numbers) : 0);
  if (const auto bits = model::multiplier_bits(config.numbers)) row["multiplier_bits"] = *bits;
}

// Is `a` as good as `b` in PSNR and in every cost, and better in one?
bool dominates(const Json& a, const Json& b, const std::vector<std::string>& costs) {
  bool better = a["psnr_db"].get<double>() > b["psnr_db"].get<double>();
  if (a["psnr_db"].get<double>() < b["psnr_db"].get<double>()) return false;
  for (const std::string& cost : costs) {
    if (a[cost].get<double>() > b[cost].get<double>()) return false;
    better = better || a[cost].get<double>() < b[cost].get<double>();
  }
  return better;
}

// pareto_cycles, pareto_lut, pareto_memory, pareto_multiplier, pareto_bytes, pareto: no other configuration on the same
// scene has a PSNR as high for as little, and less in one; the last is of cycles and LUTs together.
void mark_fronts(const Sweep& sweep, std::vector<Json>& rows) {
  const std::string lut = lut_column(sweep);
  std::vector<std::pair<std::string, std::vector<std::string>>> fronts = {{"pareto_cycles", {"cycles"}},
                                                                          {"pareto_bytes", {"bytes"}}};
  if (!lut.empty()) fronts.insert(fronts.end(), {{"pareto_lut", {lut}}, {"pareto", {"cycles", lut}}});
  for (const std::string cost : {"memory", "multiplier"}) fronts.push_back({"pareto_" + cost, {cost + "_bits"}});
  for (const auto& [name, costs] : fronts) {
    const auto counts = [&, &costs = costs](const Json& row) {
      bool all = row["refused"].is_null() && !row["psnr_db"].is_null();
      for (const std::string& cost : costs) all = all && !row[cost].is_null();
      return all;
    };
    for (Json& row : rows) {
      bool on_front = counts(row);
      for (const Json& other : rows) {
        if (!on_front) break;
        on_front = other["scene"] != row["scene"] || !counts(other) || !dominates(other, row, costs);
      }
      row[name] = row["refused"].is_null() ? Json(on_front) : Json(nullptr);
    }
  }
}

std::string csv_cell(const Json& value) {
  if (value.is_null()) return "";
  if (!value.is_string()) return value.dump();
  std::string text = "\"";
  for (const char c : value.get<std::string>()) text += c == '"' ? "\"\"" : std::string(1, c);
  return text + "\"";
}

}  // namespace

std::string lut_column(const Sweep& sweep) { return sweep.targets.empty() ? "" : "lut_" + sweep.targets.front(); }

std::vector<Json> sweep_rows(const Sweep& sweep) {
  std::map<std::pair<std::size_t, std::size_t>, Json> pictures;
  std::map<std::size_t, Json> areas;
  std::size_t missing = 0;
  Json columns = Json::object();  // of every measure
  for (const SweepPoint& point : sweep.points) {
    const Json result = stored_result(sweep, point);
    missing += result.is_null();
    if (point.is_area) areas[point.config] = result;
    else pictures[{point.scene, point.config}] = result;
    if (point.is_area || result.is_null() || result.contains("refused")) continue;
    for (const auto& item : result.items()) columns[item.key()] = nullptr;
  }
  if (missing) {
    throw ref::Error(
        fmt::format("{}: {} of {} points are not there: compute them with the same options, without --merge",
                    sweep.input.out, missing, sweep.points.size()));
  }
  std::vector<Json> rows;
  for (std::size_t s = 0; s < sweep.scenes.size(); ++s) {
    for (std::size_t c = 0; c < sweep.configs.size(); ++c) {
      const SweepConfig& config = sweep.configs[c];
      Json row = {{"scene", sweep.scenes[s].name},
                  {"width", sweep.scenes[s].width},
                  {"height", sweep.scenes[s].height},
                  {"config", config.name},
                  {"named", config.named.empty() ? Json(nullptr) : Json(config.named)},
                  {"base", config.base},
                  {"refused", config.refused.empty() ? Json(nullptr) : Json(config.refused)}};
      // The largest frame, apart from the frame that was drawn.
      const Json numbers = to_json(config.numbers);
      for (const auto& item : numbers.items()) {
        row[item.key() == "width" || item.key() == "height" ? "largest_" + item.key() : item.key()] = item.value();
      }
      if (sweep.motion) row[kKeys] = config.between;
      row.update(columns);
      add_costs(config, row);
      if (config.refused.empty()) row.update(pictures[{s, c}]);
      add_area(sweep, config.refused.empty() && !sweep.targets.empty() ? areas[c] : Json::object(), row);
      rows.push_back(std::move(row));
    }
  }
  mark_fronts(sweep, rows);
  return rows;
}

void write_table(const Sweep& sweep, const std::vector<Json>& rows) {
  std::string csv;
  if (!rows.empty()) {
    for (const auto& item : rows[0].items()) csv += (csv.empty() ? "" : ",") + item.key();
    csv += '\n';
  }
  for (const Json& row : rows) {
    std::string line;
    for (const auto& item : rows[0].items())
      line += (line.empty() ? "" : ",") + csv_cell(row.value(item.key(), Json()));
    csv += line + '\n';
  }
  Json vary = Json::object();
  for (const Variation& variation : sweep.variations) vary[variation.key] = variation.values;
  const Json json = {{"format", "halfspace-sweep 1"},   {"base", sweep.input.choice.config},
                     {"star", sweep.input.choice.star}, {"vary", vary},
                     {"area", sweep.targets},           {"rows", rows}};
  const fs::path out(sweep.input.out);
  model::write_file((out / "sweep.csv").string(), csv);
  model::write_file((out / "sweep.json").string(), json.dump(1) + "\n");
}

}  // namespace halfspace::cli
