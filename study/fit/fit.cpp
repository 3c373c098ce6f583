// SPDX-License-Identifier: Apache-2.0
#include "study/fit/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "model/pipeline/engine.hpp"
#include "model/pipeline/memories.hpp"
#include "ref/error.hpp"

namespace halfspace::model {
namespace {

constexpr int kMostTriangles = 1 << 22;  // what refusal() allows

// The least number of bits that a frame of this size lies in, with the stamps around it.
int range_bits_for(int width, int height) {
  int bits = 1;
  while (1 << (bits - 1) < std::max(width, height) + 12) ++bits;
  return bits;
}

// r and g that make the rounding of planes small beside the rest: an error of 1/32 LSB before rounding at most.
void give_generous_planes(Config& c) {
  const std::int64_t reach = (std::int64_t(1) << c.range_bits) + c.width + c.height;
  const int g = bits_for(reach) + 5;
  c.depth_fraction = has_depth(c) ? g : 0;
  c.colour_fraction = is_gouraud(c) ? g : 0;
  c.reciprocal_bits = has_planes(c) ? std::max(c.subpixel_bits + g, std::max(c.depth_bits, c.colour_bits) + 6) : 0;
}

using Key = std::tuple<int, int, int, int, int, int, int, int, int>;
Key key_of(const Config& c) {
  return {c.range_bits,     c.subpixel_bits,   c.depth_bits, c.colour_bits, c.reciprocal_bits,
          c.depth_fraction, c.colour_fraction, c.lanes,      int(c.shading)};
}

class Search {
 public:
  Search(const FitScene& scene, const FitGoal& goal, const std::function<void(std::uint64_t)>& progress)
      : scene_(scene), goal_(goal), progress_(progress) {
    for (const Projection& project : scene.frames) {
      ideals_.push_back(ref::ideal(project(ref::ideal_view(scene.width, scene.height))));
    }
  }

  // Every frame with these numbers, up to the first that misses the goal.
  const FitOutcome& try_config(Config c) {
    c.name = "fit";
    c.triangles = kMostTriangles;
    const auto [at, is_new] = outcomes_.try_emplace(key_of(c));
    if (!is_new) return at->second;
    if (progress_) progress_(outcomes_.size());
    FitOutcome& outcome = at->second;
    if (const Refusal reason = refusal(c); reason != Refusal::kNone) {
      outcome.why = "refused: " + refusal_text(reason);
      return outcome;
    }
    outcome = draw(c, make_runtime_engine(small(c), format_table(small(c)), 1));
    return outcome;
  }

  FitOutcome draw(const Config& c, std::unique_ptr<Engine> engine) const {
    FitOutcome outcome;
    outcome.psnr = 1e9;
    outcome.holds = true;
    const ref::RasterFormat format = raster_format(Configuration(c.name, c));
    for (std::size_t k = 0; k < scene_.frames.size() && outcome.holds; ++k) {
      const ref::TriangleList list = scene_.frames[k]({scene_.width, scene_.height, c.range_bits, c.subpixel_bits});
      const ref::SnappedList snapped = ref::snap(list, format);
      outcome.triangles = std::max(outcome.triangles, list.triangles.size());
      if (is_too_many(list)) {
        outcome.holds = false;
        outcome.why = fmt::format("frame {}: {} triangles after clipping", k, list.triangles.size());
        break;
      }
      judge(engine->render(snapped), list, k, c.depth_bits, outcome);
    }
    return outcome;
  }

  std::uint64_t tried() const { return outcomes_.size(); }

 private:
  // The runtime engine holds a TdbS of all triangles that a configuration allows: no more than the scene can have.
  Config small(Config c) {
    if (most_triangles_ == 0) {
      for (const Projection& project : scene_.frames) {
        // Clipping to the smallest range cuts the most.
        const auto list = project({scene_.width, scene_.height, c.range_bits, c.subpixel_bits});
        most_triangles_ = std::max(most_triangles_, list.triangles.size());
      }
      most_triangles_ = std::min<std::size_t>(2 * most_triangles_ + 64, kMostTriangles);
    }
    c.triangles = int(most_triangles_);
    return c;
  }
  bool is_too_many(const ref::TriangleList& list) const {
    return most_triangles_ && list.triangles.size() > most_triangles_;
  }

  void judge(const ref::Frame& frame, const ref::TriangleList& list, std::size_t k, int depth_bits,
             FitOutcome& outcome) const {
    const PictureError error = picture_error(ideals_[k], list, frame, std::max(depth_bits, 1));
    outcome.psnr = std::min(outcome.psnr, error.psnr);
    outcome.largest_lsb = std::max(outcome.largest_lsb, error.colour_largest);
    outcome.wrong_pixels = std::max(outcome.wrong_pixels, error.index_differ);
    if (goal_.psnr > 0 && error.psnr < goal_.psnr) {
      outcome.holds = false;
      outcome.why = fmt::format("frame {}: {:.2f} dB", k, error.psnr);
    } else if (goal_.max_lsb > 0 && error.colour_largest > goal_.max_lsb) {
      outcome.holds = false;
      outcome.why = fmt::format("frame {}: a colour is off by {:.2f} LSB", k, error.colour_largest);
    }
  }

  const FitScene& scene_;
  const FitGoal& goal_;
  const std::function<void(std::uint64_t)>& progress_;
  std::vector<ref::IdealFrame> ideals_;
  std::map<Key, FitOutcome> outcomes_;
  std::size_t most_triangles_ = 0;
};

// Numbers that the search lowers, those first that save most: memory before logic.
const std::pair<const char*, int Config::*> kLowered[] = {
    {"depth_bits", &Config::depth_bits},         {"colour_bits", &Config::colour_bits},
    {"subpixel_bits", &Config::subpixel_bits},   {"colour_fraction", &Config::colour_fraction},
    {"depth_fraction", &Config::depth_fraction}, {"reciprocal_bits", &Config::reciprocal_bits}};

Config lowered(Config c, int Config::*number) {
  --(c.*number);
  return c;
}

// A configuration that holds and is more than enough, or an error that says how near one comes.
Config generous_start(Search& search, const FitScene& scene, const FitGoal& goal) {
  FitOutcome best;
  for (const int f : {8, 10, 12}) {
    Config c{"fit", scene.width, scene.height, 1, range_bits_for(scene.width, scene.height), f, 24, 8, 0, 0, 0, 1};
    give_generous_planes(c);
    const FitOutcome& outcome = search.try_config(c);
    if (outcome.holds) return c;
    best = outcome;
  }
  throw ref::Error(fmt::format(
      "{}: no configuration reaches {}: with 12 sub-pixel bits, 24 of depth and 8 of colour, {}: ask for less",
      scene.name,
      goal.max_lsb > 0 ? fmt::format("{:.1f} dB and {} LSB", goal.psnr, goal.max_lsb)
                       : fmt::format("{:.1f} dB", goal.psnr),
      best.why));
}

// Cycles by the model.
std::uint64_t slowest_frame(const FitScene& scene, const Configuration& configuration) {
  const Config c = configuration.config();
  std::uint64_t most = 0;
  for (const Projection& project : scene.frames) {
    const auto list =
        ref::snap(project({scene.width, scene.height, c.range_bits, c.subpixel_bits}), raster_format(configuration));
    const auto engine = make_engine(configuration, c.lanes);
    most = std::max(most, model_cycles(c, *engine, list, engine->render(list)).frame);
  }
  return most;
}

// Makes `c` the one of the two.
FitArchitecture choose_architecture(Config& c, const FitGoal& goal,
                                    const std::function<std::uint64_t(const Config&)>& cycles_of) {
  Config gamma = c;
  gamma.architecture = Architecture::kGamma;
  FitArchitecture found{memory_bits(c).depth, memory_bits(gamma).visibility, cycles_of(c), 0, ""};
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
  Search search(scene, goal, progress);
  Config c = generous_start(search, scene, goal);
  auto keep = [&](const Config& candidate) {
    if (!search.try_config(candidate).holds) return false;
    c = candidate;
    return true;
  };

  // Units that may not be there at all.
  Config without = c;
  without.depth_bits = 0;
  give_generous_planes(without);
  // A triangle that a nearer one hides is no matter of accuracy: the same faces, or the Z-buffer stays.
  if (search.try_config(without).wrong_pixels <= search.try_config(c).wrong_pixels) keep(without);
  without = c;
  without.shading = Shading::kFlat;
  give_generous_planes(without);
  keep(without);

  for (bool lowered_one = true; lowered_one;) {
    lowered_one = false;
    for (const auto& [field, number] : kLowered) {
      const int floor = number == &Config::depth_bits ? 2 : 1;
      while (c.*number > floor && keep(lowered(c, number))) lowered_one = true;
    }
  }

  Fit fit{named_configurations()[0], search.try_config(c), {}, 0, {}, {}};
  c.triangles = int(fit.outcome.triangles);
  auto tell_less = [&](const std::string& field, int value, const FitOutcome& outcome) {
    fit.less.push_back({fmt::format("{} {} -> {}", field, value, value - 1), outcome.holds ? "holds" : outcome.why});
  };
  for (const auto& [field, number] : kLowered) {
    if (c.*number > 0) tell_less(field, c.*number, search.try_config(lowered(c, number)));
  }
  tell_less("range_bits", c.range_bits, search.try_config(lowered(c, &Config::range_bits)));
  fit.less.push_back({fmt::format("triangles {} -> {}", c.triangles, c.triangles - 1),
                      fmt::format("a frame has {}", fit.outcome.triangles)});

  c.lanes = lanes ? lanes : 1;
  const auto cycles_of = [&](const Config& with) { return slowest_frame(scene, Configuration(name, with)); };
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
    fit.objects = choose_objects(
        c, scene, [&](const FitScene& of, const Config& with) { return slowest_frame(of, Configuration(name, with)); });
  }
  if (has_depth(c) && !has_objects(c)) fit.architecture = choose_architecture(c, goal, cycles_of);
  fit.configuration = Configuration(name, c);
  fit.tried = search.tried();
  return fit;
}

FitOutcome check_fit(const FitScene& scene, const Configuration& configuration, const FitGoal& goal, int lanes) {
  const Search search(scene, goal, nullptr);
  return search.draw(configuration.config(), make_engine(configuration, lanes));
}

}  // namespace halfspace::model
