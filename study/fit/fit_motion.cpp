// SPDX-License-Identifier: Apache-2.0
#include "study/fit/fit_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "model/drivers/up_convert.hpp"
#include "ref/error.hpp"
#include "ref/geometry/geometry.hpp"
#include "ref/motion/motion.hpp"
#include "study/fit/fit_search.hpp"

namespace halfspace::model {
namespace {

struct Trial {
  bool holds = false;
  std::string why;
  MotionTrade trade;
};

// Of all frames: of the keys, and in between.
std::size_t most_triangles(const MotionInput& input, const Config& c) {
  std::size_t most = 2;
  for (int frame = input.first; frame <= input.last; ++frame) {
    const ref::Scene scene = input.at(frame / input.rate);
    const ref::Geometry geometry(scene, {input.width, input.height, c.range_bits, c.subpixel_bits});
    most = std::max(most, geometry.positions().triangles.size());
  }
  return most;
}

class MotionSearch {
 public:
  MotionSearch(const MotionInput& input, const FitGoal& goal, Config finest,
               const std::function<void(std::uint64_t)>& progress)
      : input_(input), goal_(goal), progress_(progress) {
    counted_ = int(most_triangles(input, finest));
    triangles_ = 2 * counted_ + 64;  // other positions may have others
    finest.triangles = triangles_;
    reference_ = motion_reference(input, Configuration("fit", finest));
  }

  const Trial& trial(Config c) {
    c.name = "fit", c.triangles = triangles_;
    const auto [at, is_new] = trials_.try_emplace(fit_key(c));
    if (!is_new) return at->second;
    if (progress_) progress_(trials_.size());
    Trial& trial = at->second;
    try {
      trial.trade = measure_motion(input_, Configuration("fit", c), 1, &reference_);
    } catch (const ref::Error& error) {
      const Refusal reason = refusal(c);
      trial.why = "refused: " + (reason == Refusal::kNone ? error.what() : refusal_text(reason));
      return trial;
    }
    const MotionTrade& t = trial.trade;
    if (goal_.psnr > 0 && t.worst_reference_psnr < goal_.psnr)
      trial.why = fmt::format("{:.2f} dB", t.worst_reference_psnr);
    else if (goal_.max_lsb > 0 && t.colour_largest > goal_.max_lsb)
      trial.why = fmt::format("a colour is off by {} LSB", t.colour_largest);
    else if (goal_.wrong_pixels >= 0 && t.wrong_pixels > std::uint64_t(goal_.wrong_pixels))
      trial.why = fmt::format("{} pixels are off by more than {} LSB", t.wrong_pixels, kWrongLsb);
    trial.holds = trial.why.empty();
    return trial;
  }

  std::array<double, 3> cost(Config c) {
    const double logic = double(logic_bits(c));
    const bool is_traffic = goal_.cost == FitCost::kCycles || goal_.cost == FitCost::kBytes;
    const MotionTrade trade = is_traffic ? trial(c).trade : MotionTrade{};
    c.triangles = counted_;
    const double memory = double(all_memory_bits(c) + key_frame_bits(c));
    if (goal_.cost == FitCost::kCycles) return {double(trade.cycles), memory, logic};
    if (goal_.cost == FitCost::kBytes) return {double(trade.key_bytes + trade.word_bytes), memory, logic};
    if (goal_.cost == FitCost::kMemory) return {memory, logic, 0};
    return {logic, memory, 0};
  }

  std::uint64_t tried() const { return trials_.size(); }

 private:
  const MotionInput& input_;
  const FitGoal& goal_;
  const std::function<void(std::uint64_t)>& progress_;
  std::vector<ref::FrameBetween> reference_;
  std::map<std::vector<int>, Trial> trials_;
  int counted_ = 0, triangles_ = 0;
};

std::string word(const Config& c, const char* unit) {
  const ConfigField* field = find_field(unit);
  return field ? field->text(c) : has_depth(c) ? "a Z-buffer" : "none";
}

}  // namespace

MotionFit fit_motion(const MotionInput& input, const std::string& name, const FitGoal& goal, KeyFilter filter,
                     const std::function<void(std::uint64_t)>& progress) {
  Config c = generous_motion(input.width, input.height, face_bits_of(input.at(input.first / input.rate)), filter);
  MotionSearch search(input, goal, c, progress);
  if (const Trial& trial = search.trial(c); !trial.holds)
    throw ref::Error(
        fmt::format("no configuration comes as near to the reference: with the finest numbers, {}: ask for "
                    "less",
                    trial.why));
  std::map<std::string, FitLess> units;
  for (const FitUnit& unit : fit_units()) {
    for (auto less = unit.without(c); less; less = unit.without(c)) {
      const Trial& trial = search.trial(*less);
      units[unit.name] = {fmt::format("{} {} -> {}", unit.name, word(c, unit.name), word(*less, unit.name)), trial.why};
      if (!trial.holds) break;
      c = *less;
      units.erase(unit.name);
    }
  }
  const std::vector<Config> ends = fit_ends({[&](const Config& tried) { return search.trial(tried).holds; },
                                             [&](const Config& of) { return search.cost(of); }},
                                            c);
  c = ends[0];
  MotionFit fit{named_configurations()[0], search.trial(c).trade, {}, 0, ends.size(), search.cost(c)[0]};
  for (const ConfigField* number : fit_numbers(c)) {
    const Config less = fit_less(c, *number);
    const Trial& trial = search.trial(less);
    fit.less.push_back({fmt::format("{} {} -> {}", number->name, number->get(c), number->get(less)),
                        trial.holds ? "holds" : trial.why});
  }
  for (const FitUnit& unit : fit_units()) {
    if (const auto result = units.find(unit.name); result != units.end()) fit.less.push_back(result->second);
  }
  fit.tried = search.tried();
  c.triangles = int(most_triangles(input, c));
  fit.configuration = Configuration(name, c);
  return fit;
}

std::vector<NamedFrame> motion_frames(const MotionInput& input, const Configuration& configuration) {
  const Config c = configuration.config();
  const ref::View view{input.width, input.height, c.range_bits, c.subpixel_bits};
  std::vector<NamedFrame> frames;
  for (int key = input.first; key + input.between + 1 <= input.last; key += input.between + 1) {
    const ref::OfKeys<ref::Scene> keys{input.at(key / input.rate), input.at((key + input.between + 1) / input.rate)};
    for (int n = 1; n <= input.between; ++n) {
      const ref::Scene scene = input.at((key + n) / input.rate);
      const ref::Between between =
          ref::follow(ref::MotionMethod::kExact, keys[0], keys[1], scene, double(n) / (input.between + 1), view);
      ref::OfKeys<ref::LightChange> change{};
      if (relights(c))
        change = light_changes(scene, {&keys[0], &keys[1]}, view, colour_configuration(configuration).config());
      frames.push_back({fmt::format("frame {}", key + n), ref::snap(between.list, raster_format(configuration))});
      frames.back().motion = motion_frame(between, c, change);
    }
  }
  return frames;
}

}  // namespace halfspace::model
