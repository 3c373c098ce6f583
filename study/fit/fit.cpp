// SPDX-License-Identifier: Apache-2.0
#include "study/fit/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "model/pipeline/engine.hpp"
#include "model/pipeline/memories.hpp"
#include "ref/error.hpp"
#include "study/fit/fit_search.hpp"

namespace halfspace::model {
namespace {

// A configuration that holds and is more than enough, or an error that says how near one comes.
Config generous_start(FitSearch& search, const FitScene& scene, const FitGoal& goal) {
  const FitNeeds needs = fit_needs(scene, goal.look);
  FitOutcome best;
  for (const int f : {8, 10, 12}) {
    const Config c = generous(scene, goal.look, needs, f);
    const FitOutcome& outcome = search.try_config(c);
    if (outcome.holds) return c;
    best = outcome;
  }
  std::string asked;
  const auto ask = [&](const std::string& what) { asked += (asked.empty() ? "" : " and ") + what; };
  if (goal.psnr > 0) ask(fmt::format("{:.1f} dB", goal.psnr));
  if (goal.max_lsb > 0) ask(fmt::format("{} LSB", goal.max_lsb));
  if (goal.wrong_pixels >= 0) ask(fmt::format("{} wrong pixels", goal.wrong_pixels));
  throw ref::Error(fmt::format(
      "{}: no configuration reaches {}: with 12 sub-pixel bits, 24 of depth and 8 of colour, {}: ask for less",
      scene.name, asked, best.why));
}

// What the trial of each unit came to.
using UnitResults = std::map<std::string, FitLess>;

std::string word(const Config& c, const char* choice) {
  const ConfigField* field = find_field(choice);
  return field ? field->text(c) : has_depth(c) ? "a Z-buffer or TdbV" : "none";
}

// Takes units away while the goal is kept.
Config without_units(FitSearch& search, Config c, UnitResults& results) {
  for (const FitUnit& unit : fit_units()) {
    for (auto less = unit.without(c); less; less = unit.without(c)) {
      const FitOutcome outcome = search.try_config(*less), now = search.try_config(c);
      const std::string change = fmt::format("{} {} -> {}", unit.name, word(c, unit.name), word(*less, unit.name));
      // A triangle that a nearer one hides is no matter of accuracy: the same faces, or the Z-buffer stays.
      const bool same_faces = has_depth(*less) || outcome.wrong_pixels <= now.wrong_pixels;
      results[unit.name] = {change, !outcome.holds ? outcome.why
                                    : same_faces   ? "holds"
                                                   : fmt::format("{} pixels show another face", outcome.wrong_pixels)};
      if (!outcome.holds || !same_faces) break;
      c = *less;
      results.erase(unit.name);
    }
  }
  return c;
}

// The end that a synthesis finds to be smallest, if there is one; of so many at most.
constexpr std::size_t kMeasured = 4;
Config best_end(const std::vector<Config>& ends, const FitGoal& goal, std::size_t triangles, FitCosts& costs,
                double& cost) {
  cost = costs.of(ends[0])[0];
  if (!goal.measured || (goal.cost != FitCost::kLut && goal.cost != FitCost::kDsp)) return ends[0];
  const Config* best = nullptr;
  for (std::size_t n = 0; n < std::min(ends.size(), kMeasured); ++n) {
    Config c = ends[n];
    c.triangles = int(triangles);
    const double measured = goal.measured(Configuration("fit", c));
    if (!best || measured < cost) best = &ends[n], cost = measured;
  }
  return *best;
}

// Makes `c` the one of the two.
FitArchitecture choose_architecture(Config& c, const FitGoal& goal,
                                    const std::function<std::uint64_t(const Config&)>& cycles_of) {
  Config gamma = c;
  gamma.architecture = Architecture::kGamma;
  FitArchitecture found{memory_bits(c).depth, memory_bits(gamma).visibility, cycles_of(c), 0, ""};
  if (goal.z_buffer) {
    found.why = "a Z-buffer is asked for";
    return found;
  }
  if (const Refusal reason = refusal(gamma); reason != Refusal::kNone) {
    found.why = "gamma is refused: " + refusal_text(reason);
    return found;
  }
  found.cycles_gamma = cycles_of(gamma);
  const double most = goal.cycles ? double(goal.cycles) : kGammaCycles * double(found.cycles_delta);
  if (found.tdbv_bits >= found.z_buffer_bits) {
    found.why = fmt::format("TdbV has {} bits, the Z-buffer {}", found.tdbv_bits, found.z_buffer_bits);
  } else if (double(found.cycles_gamma) > most) {
    found.why = fmt::format("a frame of gamma takes {} cycles, more than {:.0f}", found.cycles_gamma, most);
  } else {
    found.why = fmt::format("TdbV has {} bits instead of the Z-buffer's {}, and a frame takes {} cycles instead of {}",
                            found.tdbv_bits, found.z_buffer_bits, found.cycles_gamma, found.cycles_delta);
    c.architecture = Architecture::kGamma;
  }
  return found;
}

}  // namespace

Fit fit_configuration(const FitScene& scene, const std::string& name, const FitGoal& goal, int lanes,
                      const std::function<void(std::uint64_t)>& progress) {
  FitSearch search(scene, goal, progress);
  UnitResults units;
  Config c = without_units(search, generous_start(search, scene, goal), units);
  const std::size_t triangles = std::max<std::size_t>(search.try_config(c).triangles, 2);
  FitCosts costs(scene, goal.cost, int(triangles));
  const std::vector<Config> ends = fit_ends(
      {[&](const Config& tried) { return search.holds(tried); }, [&](const Config& of) { return costs.of(of); }}, c);
  Fit fit{named_configurations()[0], {}, {}, 0, 1, 0, {}, {}};
  c = best_end(ends, goal, triangles, costs, fit.cost);
  fit.outcome = search.try_config(c);
  fit.ends = ends.size();
  c.triangles = int(std::max<std::size_t>(fit.outcome.triangles, 2));

  for (const ConfigField* number : fit_numbers(c)) {
    const Config less = fit_less(c, *number);
    const FitOutcome& outcome = search.try_config(less);
    fit.less.push_back({fmt::format("{} {} -> {}", number->name, number->get(c), number->get(less)),
                        outcome.holds ? "holds" : outcome.why});
  }
  Config narrow = c;
  --narrow.range_bits;
  const FitOutcome& outcome = search.try_config(narrow);
  fit.less.push_back(
      {fmt::format("range_bits {} -> {}", c.range_bits, narrow.range_bits), outcome.holds ? "holds" : outcome.why});
  fit.less.push_back({fmt::format("triangles {} -> {}", c.triangles, c.triangles - 1),
                      fmt::format("a frame has {}", fit.outcome.triangles)});
  for (const FitUnit& unit : fit_units()) {
    if (const auto result = units.find(unit.name); result != units.end()) fit.less.push_back(result->second);
  }

  c.lanes = lanes ? lanes : 1;
  const auto cycles_of = [&](Config with) {
    with.name = name.c_str();
    return slowest_frame(scene, with).cycles;
  };
  if (goal.cycles) {
    std::uint64_t reached = cycles_of(c);
    while (!lanes && reached > goal.cycles && c.lanes < 16) {
      c.lanes *= 2;
      reached = cycles_of(c);
    }
    if (reached > goal.cycles) {
      throw ref::Error(fmt::format("{}: a frame takes {} cycles with {} lanes, more than {}: allow more cycles",
                                   scene.name, reached, c.lanes, goal.cycles));
    }
  }
  if (goal.static_objects) {
    fit.objects = choose_objects(c, scene, [&](const FitScene& of, Config with) {
      with.name = name.c_str();
      return slowest_frame(of, with).cycles;
    });
  }
  if (has_depth(c) && !has_objects(c) && goal.cost == FitCost::kMemory)
    fit.architecture = choose_architecture(c, goal, cycles_of);
  fit.configuration = Configuration(name, c);
  fit.tried = search.tried();
  return fit;
}

FitOutcome check_fit(const FitScene& scene, const Configuration& configuration, const FitGoal& goal, int lanes) {
  const FitSearch search(scene, goal, nullptr);
  return search.draw(configuration.config(), *make_engine(configuration, lanes));
}

}  // namespace halfspace::model
