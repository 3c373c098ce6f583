// SPDX-License-Identifier: Apache-2.0
#include "study/papers/static_experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <optional>

#include "model/formats/configuration.hpp"
#include "model/pipeline/cycles.hpp"
#include "ref/error.hpp"

namespace halfspace::model {
namespace {

double processor_ms() { return 1e3 * double(std::clock()) / CLOCKS_PER_SEC; }

// Setup cycles of objects as they stand; those that stand still are asked once.
class ObjectCosts {
 public:
  ObjectCosts(const Config& config, int width, int height, std::size_t objects)
      : model_(config, width, height), costs_(objects) {}

  struct Cost {
    std::uint64_t triangle_setup = 0, shade_setup = 0;
  };
  const Cost& of(std::uint32_t instance, ref::ObjectRaster& raster) {
    std::optional<Cost>& cost = costs_[instance];
    if (!cost) {
      cost.emplace();
      raster.triangles(instance, [&](const ref::SnappedTriangle& t, std::uint32_t) {
        const SetupCycles cycles = model_.cycles(t);
        cost->triangle_setup += std::uint64_t(cycles.triangle_setup);
        cost->shade_setup += std::uint64_t(cycles.shade_setup);
      });
    }
    return *cost;
  }
  void moved(std::uint32_t instance) { costs_[instance].reset(); }

 private:
  SetupModel model_;
  std::vector<std::optional<Cost>> costs_;
};

// One of the methods with S-buffers.
struct Run {
  StaticMethod method;
  ref::StaticObjects objects;
  std::vector<std::uint32_t> drawn;  // in the frame at hand
};

class Experiment {
 public:
  Experiment(const StaticExperimentOptions& o, const ExperimentProgress& progress)
      : o_(o),
        progress_(progress),
        config_(find_configuration(o.config)),
        format_(raster_format(config_)),
        crowd_(with_aspect(o)),
        costs_(config_.config(), o.width, o.height, std::size_t(o.crowd.objects)),
        all_(crowd_.scene(), format_, o.width, o.height) {
    if (o.width > format_.width || o.height > format_.height) {
      throw ref::Error(fmt::format(
          "a frame of {}x{} does not fit configuration {}, which takes {}x{}: take a smaller one, or a larger "
          "configuration",
          o.width, o.height, format_.name, format_.width, format_.height));
    }
    runs_.reserve(kStaticMethods - 1);
    for (const StaticMethod method : {StaticMethod::kNoQuery, StaticMethod::kQuery, StaticMethod::kQueryMany}) {
      ref::StaticOptions options;
      if (method == StaticMethod::kQueryMany) options.buffers = o.buffers;
      if (method != StaticMethod::kNoQuery) {
        options.query = ref::visible_pixels;
      }
      runs_.push_back({method, {crowd_.scene(), format_, o.width, o.height, options}, {}});
    }
    for (const ref::Instance& instance : crowd_.scene().instances)
      result_.triangles += crowd_.scene().meshes[instance.mesh].triangles.size();
  }

  StaticExperiment run() {
    bool first = true;
    for (const int moving : o_.moving) {
      StaticStep& step = result_.steps.emplace_back();
      step.moving = moving;
      frame(moving, first ? nullptr : &unused_, first);
      for (int n = 0; n < o_.frames; ++n) {
        frame(moving, &step, false);
        if (n >= o_.frames - o_.full_frames) draw_all(step.methods[0]);
        tell("frames", result_.steps.size() * o_.frames - o_.frames + n + 1, o_.moving.size() * o_.frames);
      }
      first = false;
    }
    result_.picture = runs_.back().objects.picture();
    return std::move(result_);
  }

 private:
  static ref::CrowdOptions with_aspect(const StaticExperimentOptions& o) {
    ref::CrowdOptions crowd = o.crowd;
    crowd.aspect = double(o.width) / o.height;
    return crowd;
  }
  void tell(const char* phase, std::size_t done, std::size_t total) const {
    if (progress_) progress_(phase, done, total);
  }
  std::uint64_t stamps(std::uint64_t pixels) const {
    return (pixels + std::uint64_t(o_.lanes) - 1) / std::uint64_t(o_.lanes);
  }

  void frame(int moving, StaticStep* step, bool first) {
    crowd_.step(moving);
    for (Run& run : runs_) {
      run.drawn.clear();
      const double begin = processor_ms();
      const ref::FrameWork work = run.objects.draw([&](std::uint32_t n) {
        run.drawn.push_back(n);
        if (first)
          tell("first frame", run.drawn.size() + (std::size_t(run.method) - 1) * std::size_t(o_.crowd.objects),
               (kStaticMethods - 1) * std::size_t(o_.crowd.objects));
      });
      const double ms = processor_ms() - begin;
      if (first) {
        result_.first_seconds[std::size_t(run.method)] = ms / 1e3;
        result_.handed = work.triangles;
      }
      if (step == nullptr) continue;
      MethodFrames& frames = step->methods[std::size_t(run.method)];
      frames.drawn.add(double(work.drawn()));
      frames.redrawn.add(double(work.redrawn));
      frames.triangles.add(double(work.triangles));
      frames.milliseconds.add(ms);
      frames.starts += work.started;
      frames.updates += work.started - work.skipped;
      frames.cycles.add(double(cycles(run, work)));
    }
  }

  // Objects that have moved are asked anew, by whichever method draws them first in a frame.
  std::uint64_t cycles(Run& run, const ref::FrameWork& work) {
    if (&run == &runs_.front()) {
      for (std::uint32_t n = 0; n < std::uint32_t(o_.crowd.objects); ++n) {
        const ref::ObjectState state = run.objects.state(n);
        if (state == ref::ObjectState::kSD || state == ref::ObjectState::kDD) costs_.moved(n);
      }
    }
    ObjectCosts::Cost sum;
    for (const std::uint32_t n : run.drawn) {
      const ObjectCosts::Cost& cost = costs_.of(n, run.objects.raster());
      sum.triangle_setup += cost.triangle_setup, sum.shade_setup += cost.shade_setup;
    }
    const std::uint64_t frame = stamps(std::uint64_t(o_.width) * std::uint64_t(o_.height));
    const std::uint64_t merge = (1 + work.drawn_into) * frame +
                                std::uint64_t(run.objects.buffers()) * stamps(work.composed) + stamps(work.searched);
    return std::max({sum.triangle_setup, sum.shade_setup, merge});
  }

  void draw_all(MethodFrames& frames) {
    const double begin = processor_ms();
    const ref::FrameWork work =
        all_.draw([&](std::size_t done) { tell("everything drawn, to compare", done, std::size_t(o_.crowd.objects)); });
    frames.milliseconds.add(processor_ms() - begin);
    frames.drawn.add(double(work.drawn()));
    frames.redrawn.add(0);
    frames.triangles.add(double(work.triangles));
    ObjectCosts::Cost sum;
    for (std::uint32_t n = 0; n < std::uint32_t(o_.crowd.objects); ++n) {
      const ObjectCosts::Cost& cost = costs_.of(n, runs_.front().objects.raster());
      sum.triangle_setup += cost.triangle_setup, sum.shade_setup += cost.shade_setup;
    }
    frames.cycles.add(double(std::max(sum.triangle_setup, sum.shade_setup)));
    for (Run& run : runs_) compare(run.objects.picture());
  }

  void compare(const ref::ObjectBuffer& picture) {
    for (int y = 0; y < o_.height; ++y) {
      for (int x = 0; x < o_.width; ++x) {
        const ref::ObjectPixel &a = picture.at(x, y), &b = all_.picture().at(x, y);
        if (a.key != b.key || a.triangle != b.triangle || a.colour != b.colour) {
          throw ref::Error(fmt::format("pixel ({}, {}) shows object {}, and {} when everything is drawn: report this",
                                       x, y, a.object(), b.object()));
        }
        ++result_.compared;
      }
    }
  }

  const StaticExperimentOptions o_;
  const ExperimentProgress progress_;
  const Configuration config_;
  const ref::RasterFormat format_;
  ref::Crowd crowd_;
  ObjectCosts costs_;
  ref::AllObjects all_;
  std::vector<Run> runs_;
  StaticStep unused_;
  StaticExperiment result_;
};

}  // namespace

void Spread::add(double value) {
  ++count_;
  const double off = value - mean_;
  mean_ += off / double(count_);
  squares_ += off * (value - mean_);
  largest_ = std::max(largest_, value);
}

double Spread::deviation() const { return count_ == 0 ? 0 : std::sqrt(squares_ / double(count_)); }

StaticExperiment run_static_experiment(const StaticExperimentOptions& options, const ExperimentProgress& progress) {
  return Experiment(options, progress).run();
}

}  // namespace halfspace::model
