// SPDX-License-Identifier: Apache-2.0
#include "study/fit/fit_search.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "ref/error.hpp"

namespace halfspace::model {
namespace {

constexpr int kMostTriangles = 1 << 22;  // what refusal() allows

}  // namespace

FitSearch::FitSearch(const FitScene& scene, const FitGoal& goal, const std::function<void(std::uint64_t)>& progress)
    : scene_(scene), goal_(goal), progress_(progress) {
  for (const Subject& subject : scene.frames) ideals_.push_back(subject.ideal(goal.look, scene.width, scene.height));
}

const FitOutcome& FitSearch::try_config(Config c) {
  c.name = "fit";
  c.triangles = kMostTriangles;
  const auto [at, is_new] = outcomes_.try_emplace(fit_key(c));
  if (!is_new) return at->second;
  if (progress_) progress_(outcomes_.size());
  FitOutcome& outcome = at->second;
  if (const Refusal reason = refusal(c); reason != Refusal::kNone) {
    outcome.why = "refused: " + refusal_text(reason);
    return outcome;
  }
  const Config drawn = small(c);
  try {
    outcome = draw(drawn, *make_runtime_engine(drawn, format_table(drawn), 1));
  } catch (const ref::Error& error) {  // as textures that have no room
    outcome = {};
    outcome.why = std::string("refused: ") + error.what();
  }
  return outcome;
}

FitOutcome FitSearch::draw(const Config& c, Engine& engine) const {
  FitOutcome outcome;
  outcome.psnr = 1e9;
  outcome.holds = true;
  for (std::size_t n = 0; n < scene_.frames.size() && outcome.holds; ++n) {
    const std::size_t k = n == 0 ? failed_ : n <= failed_ ? n - 1 : n;
    const Subject::Drawn drawn = scene_.frames[k].drawn(c, scene_.width, scene_.height);
    outcome.triangles = std::max(outcome.triangles, drawn.list.triangles.size());
    load_frame(engine, c, drawn.frame);
    judge(engine.render(drawn.frame.scene), drawn.list, k, c.depth_bits, outcome);
    if (!outcome.holds) failed_ = k;
  }
  return outcome;
}

Config FitSearch::small(Config c) {
  if (most_triangles_ == 0) {
    for (const Subject& subject : scene_.frames) {
      // Clipping to the smallest range cuts the most.
      const auto list = subject.triangles({scene_.width, scene_.height, c.range_bits, c.subpixel_bits});
      most_triangles_ = std::max(most_triangles_, list.triangles.size());
    }
    most_triangles_ = std::min<std::size_t>(2 * most_triangles_ + 64, kMostTriangles);
  }
  c.triangles = int(most_triangles_);
  return c;
}

void FitSearch::judge(const ref::Frame& frame, const ref::TriangleList& list, std::size_t k, int depth_bits,
                      FitOutcome& outcome) const {
  const PictureError error = picture_error(ideals_[k], list, frame, std::max(depth_bits, 1));
  outcome.psnr = std::min(outcome.psnr, error.psnr);
  outcome.largest_lsb = std::max(outcome.largest_lsb, error.colour_largest);
  outcome.wrong_pixels = std::max(outcome.wrong_pixels, error.index_differ);
  const auto misses = [&](std::string why) {
    outcome.holds = false;
    outcome.why = fmt::format("frame {}: {}", k, why);
  };
  if (goal_.psnr > 0 && error.psnr < goal_.psnr) misses(fmt::format("{:.2f} dB", error.psnr));
  else if (goal_.max_lsb > 0 && error.colour_largest > goal_.max_lsb)
    misses(fmt::format("a colour is off by {:.2f} LSB", error.colour_largest));
  else if (goal_.wrong_pixels >= 0 && error.index_differ > std::uint64_t(goal_.wrong_pixels))
    misses(fmt::format("{} pixels show another face", error.index_differ));
}

namespace {

using Numbers = std::vector<const ConfigField*>;

// Steps of each number, in this order, until nothing more can go. `held` is not lowered.
Config descend(const FitTrials& trials, Config c, const Numbers& numbers, const ConfigField* held = nullptr) {
  for (bool lowered = true; lowered;) {
    lowered = false;
    for (const ConfigField* number : numbers) {
      if (number == held) continue;
      for (auto less = stepped(c, *number, -1); less && trials.holds(*less); less = stepped(c, *number, -1))
        c = *less, lowered = true;
    }
  }
  return c;
}

}  // namespace

Config fit_less(const Config& c, const ConfigField& number) {
  Config less = stepped(c, number, -1).value_or(c);
  if (number.get(less) == number.get(c)) number.set(less, number.get(c) - 1);
  return less;
}

std::vector<Config> fit_ends(const FitTrials& trials, const Config& start) {
  const Numbers numbers = fit_numbers(start);
  // What a step of each saves where it begins, most first; what saves nothing keeps its place.
  Numbers by_saving = numbers;
  std::vector<std::pair<std::array<double, 3>, const ConfigField*>> of_step;
  for (const ConfigField* number : numbers) {
    const auto less = stepped(start, *number, -1);
    Config larger = start;
    if (less && refusal(*less) == Refusal::kNone) larger = *less;
    of_step.push_back({trials.cost(larger), number});
  }
  std::stable_sort(of_step.begin(), of_step.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t n = 0; n < numbers.size(); ++n) by_saving[n] = of_step[n].second;
  std::vector<Config> ends;
  const auto add = [&](const Config& end) {
    for (const Config& other : ends) {
      if (fit_key(other) == fit_key(end)) return;
    }
    ends.push_back(end);
  };
  const auto cheaper = [&](const Config& a, const Config& b) { return trials.cost(a) < trials.cost(b); };
  add(descend(trials, start, numbers));
  add(descend(trials, start, by_saving));
  Numbers reversed(by_saving.rbegin(), by_saving.rend());
  add(descend(trials, start, reversed));
  // A step more of one number, for more of the others.
  Config best = *std::min_element(ends.begin(), ends.end(), cheaper);
  for (bool found = true; found;) {
    found = false;
    for (const ConfigField* number : fit_numbers(best)) {
      const auto more = stepped(best, *number, 1);
      if (!more || !trials.holds(*more)) continue;
      // Without the hold at the end: the number that was raised may be more than enough now.
      const Config end = descend(trials, descend(trials, *more, by_saving, number), by_saving);
      add(end);
      if (!cheaper(end, best)) continue;
      best = end, found = true;
      break;
    }
  }
  std::stable_sort(ends.begin(), ends.end(), cheaper);
  return ends;
}

}  // namespace halfspace::model
