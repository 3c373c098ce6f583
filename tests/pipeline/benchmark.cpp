// SPDX-License-Identifier: Apache-2.0
// Native speed of the kernels beside Mesa's llvmpipe: the same snapped triangles, one thread, one run. Both clear, draw
// and leave a finished picture.
#include <benchmark/benchmark.h>

#include "model/pipeline/engine.hpp"
#include "ref/geometry/geometry.hpp"
#include "ref/scene/scene.hpp"
#include "tests/raster/mesa.hpp"

namespace {

using namespace halfspace;

const ref::SnappedList& scene_of(const std::string& name) {
  static std::map<std::string, ref::SnappedList> scenes;
  auto found = scenes.find(name);
  if (found == scenes.end()) {
    const ref::RasterFormat format = model::raster_format("middle");
    found =
        scenes
            .emplace(name,
                     ref::snap(ref::project(ref::load_scene(name), {640, 480, format.range_bits, format.subpixel_bits}),
                               format))
            .first;
  }
  return found->second;
}

void count(benchmark::State& state, const ref::SnappedList& scene) {
  state.counters["triangles"] = double(scene.triangles.size());
  state.counters["frames/s"] = benchmark::Counter(1, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["pixels/s"] =
      benchmark::Counter(double(scene.width) * scene.height, benchmark::Counter::kIsIterationInvariantRate);
}

void kernels(benchmark::State& state, const char* name, int lanes) {
  const ref::SnappedList& scene = scene_of(name);
  const auto engine = model::make_engine("middle", lanes);
  std::vector<std::array<std::uint8_t, 4>> colour;
  for (auto _ : state) {
    engine->render_colour(scene, colour);
    benchmark::DoNotOptimize(colour.data());
  }
  count(state, scene);
}

void mesa(benchmark::State& state, const char* name) {
  const ref::SnappedList& scene = scene_of(name);
  tests::Mesa mesa(scene.width, scene.height);
  const tests::Mesa::Arrays arrays = tests::Mesa::arrays(scene);
  for (auto _ : state) {
    mesa.clear(0, 0, 0);
    benchmark::DoNotOptimize(mesa.draw(arrays).data());
  }
  count(state, scene);
}

void reference(benchmark::State& state, const char* name) {
  const ref::SnappedList& scene = scene_of(name);
  for (auto _ : state) benchmark::DoNotOptimize(ref::render(scene).colour.data());
  count(state, scene);
}

BENCHMARK_CAPTURE(kernels, teapot_16_lanes, "teapot", 16)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(mesa, teapot, "teapot")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(kernels, teapot_4_lanes, "teapot", 4)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(reference, teapot, "teapot")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(kernels, castle_16_lanes, "castle", 16)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(mesa, castle, "castle")->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
