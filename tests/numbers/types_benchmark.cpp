// SPDX-License-Identifier: Apache-2.0
// One frame of the teapot through the kernels, from snapped triangles to the picture, on each kind of numbers. Prints
// how many times as long as natively each takes, and fails when a picture differs.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <functional>
#include <map>

#include "ref/geometry/geometry.hpp"
#include "ref/scene/scene.hpp"
#include "tests/numbers/types_engine.hpp"

namespace {

using namespace halfspace;
using Picture = std::vector<std::array<std::uint8_t, 4>>;

const ref::SnappedList& scene() {
  static const ref::RasterFormat format = model::raster_format("middle");
  static const ref::SnappedList list =
      ref::snap(ref::project(ref::load_scene("teapot"), {160, 120, format.range_bits, format.subpixel_bits}), format);
  return list;
}

void frame(benchmark::State& state, const std::function<std::unique_ptr<model::Engine>()>& make) {
  const auto engine = make();
  Picture colour, native;
  model::make_engine("middle", tests::kTypesLanes)->render_colour(scene(), native);
  for (auto _ : state) {
    engine->render_colour(scene(), colour);
    benchmark::DoNotOptimize(colour.data());
  }
  if (colour != native) state.SkipWithError("the picture differs from the native one");
  state.counters["triangles"] = double(scene().triangles.size());
}

// Also prints the ratios: of the medians, where there are repetitions.
class Reporter : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      failed_ = failed_ || run.error_occurred;
      if (run.run_type == Run::RT_Aggregate && run.aggregate_name != "median") continue;
      times_[run.run_name.function_name] = run.GetAdjustedCPUTime();
    }
  }
  // Whether all went well.
  bool print_ratios() const {
    const auto native = times_.find("native");
    for (const auto& [name, time] : times_) {
      if (native == times_.end()) break;
      fmt::print("{:10} {:10.3f} ms {:8.2f} times native\n", name, time, time / native->second);
    }
    return !failed_ && !times_.empty();
  }

 private:
  std::map<std::string, double> times_;
  bool failed_ = false;
};

}  // namespace

int main(int argc, char** argv) {
  const auto add = [](const char* name, const std::function<std::unique_ptr<model::Engine>()>& make) {
    benchmark::RegisterBenchmark(name, frame, make)->Unit(benchmark::kMillisecond);
  };
  add("native", [] { return model::make_engine("middle", tests::kTypesLanes); });
  add("systemc", [] { return tests::make_systemc_engine("middle"); });
#ifdef HALFSPACE_BENCHMARK_AP
  add("ap", [] { return tests::make_ap_engine("middle"); });
#endif
#ifdef HALFSPACE_BENCHMARK_AC
  add("ac", [] { return tests::make_ac_engine("middle"); });
#endif
  benchmark::Initialize(&argc, argv);
  Reporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  return reporter.print_ratios() ? 0 : 1;
}
