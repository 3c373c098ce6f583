// SPDX-License-Identifier: Apache-2.0
#include "cli/sweep/sweep_measure.hpp"

#include <fmt/format.h>

#include <atomic>
#include <cmath>
#include <filesystem>
#include <mutex>
#include <thread>

#include "cli/common/area.hpp"
#include "cli/common/progress.hpp"
#include "cli/common/sequence.hpp"
#include "ref/error.hpp"
#include "study/trade/motion_trade.hpp"
#include "vectors/staging.hpp"

namespace halfspace::cli {
namespace {

namespace fs = std::filesystem;

double share(std::uint64_t part, std::uint64_t whole) { return whole ? double(part) / double(whole) : 0; }

Json picture_result(const model::Trade& t, const Config& config, const ref::IdealLook& look) {
  using model::bytes_of;
  const ref::BufferUses& moved = t.accesses.words;
  const model::BufferBits bits = model::entry_bits(config);
  const double full = has_depth(config) ? std::ldexp(1, config.depth_bits) - 1 : 1;
  const auto finite = [](double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); };
  return {{"triangles_drawn", t.triangles},
          {"psnr_db", finite(t.ideal.psnr)},
          {"wrong_coverage_pixels", t.ideal.covered_differ},
          {"wrong_index_pixels", t.ideal.index_differ},
          {"colour_largest_lsb", t.ideal.colour_largest},
          {"colour_rms_lsb", t.ideal.colour_rms},
          {"depth_largest_lsb", t.ideal.depth_largest},
          {"depth_rms_lsb", t.ideal.depth_rms},
          {"depth_rms_ppm", 1e6 * t.ideal.depth_rms / full},
          {"shimmer_rms_lsb", t.shimmer.rms},
          {"shimmer_pixels", t.shimmer.pixels},
          {"reference_psnr_db", finite(t.reference.psnr)},
          {"reference_wrong_index_pixels", t.reference.index_differ},
          {"stored_depth_largest_lsb", t.stored.depth_largest},
          {"stored_colour_largest_lsb", t.stored.colour_largest ? Json(*t.stored.colour_largest) : Json(nullptr)},
          {"depth_misrounded_share", share(t.reference.depth_differ, t.reference.compared)},
          {"colour_misrounded_share", share(t.reference.colour_differ, 3 * t.reference.compared)},
          {"cycles", t.cycles.frame},
          {"cycles_triangle_setup", t.cycles.triangle_setup},
          {"cycles_shade_setup", t.cycles.shade_setup},
          {"cycles_raster", t.cycles.raster},
          {"cycles_scan_out", t.cycles.scan_out},
          {"bytes_index_read", bytes_of(moved.index.read, bits.index)},
          {"bytes_index_written", bytes_of(moved.index.written, bits.index)},
          {"bytes_depth_read", bytes_of(moved.depth.read, bits.depth)},
          {"bytes_depth_written", bytes_of(moved.depth.written, bits.depth)},
          {"bytes_planes_read", bytes_of(moved.shading.read, bits.shading)},
          {"bytes_planes_written", bytes_of(moved.shading.written, bits.shading)},
          {"bytes_objects_read", bytes_of(moved.object.read, bits.object)},
          {"bytes_objects_written", bytes_of(moved.object.written, bits.object)},
          {"bytes", model::total_bytes(moved, bits) + t.texture_bytes},
          {"kernels_compiled", t.compiled},
          {"native_ms", t.native_ms},
          {"bytes_texture", t.texture_bytes},
          {"ideal", ref::name_of(look)}};
}

Json motion_result(const model::MotionTrade& t) {
  const auto finite = [](double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); };
  const std::uint64_t shown = t.shares.blended + t.shares.copied + t.shares.filled;
  return {{"frames_between", t.frames},
          {"psnr_db", finite(t.psnr)},
          {"worst_psnr_db", finite(t.worst_psnr)},
          {"reference_psnr_db", finite(t.reference_psnr)},
          {"wrong_pixels", t.wrong_pixels},
          {"colour_largest_lsb", t.colour_largest},
          {"blended_share", share(t.shares.blended, shown)},
          {"copied_share", share(t.shares.copied, shown)},
          {"rendered_share", share(t.shares.filled, shown)},
          {"cycles", t.cycles},
          {"bytes_keys", t.key_bytes},
          {"bytes_words", t.word_bytes},
          {"bytes", t.key_bytes + t.word_bytes}};
}

Json compute_picture(const Sweep& sweep, const SweepScene& scene, const SweepConfig& config) {
  const model::Configuration configuration = config.configuration();
  try {
    if (sweep.motion) {
      return motion_result(model::measure_motion({scene.at, kFramesASecond, sweep.frames.first, sweep.frames.second,
                                                  config.between, scene.width, scene.height},
                                                 configuration, config.numbers.lanes));
    }
    const ref::IdealLook look = model::look_of(config.numbers, sweep.finest);
    return picture_result(
        model::measure_trade(scene.subject, scene.width, scene.height, configuration, config.numbers.lanes, look),
        config.numbers, look);
  } catch (const ref::Error& error) {
    return {{"refused", fmt::format("{} with {}: {}", scene.name, config.name, error.what())}};
  }
}

}  // namespace

void compute_point(const Sweep& sweep, const SweepPoint& point) {
  const fs::path out(sweep.input.out);
  fs::create_directories((out / point.file).parent_path());
  const SweepConfig& config = sweep.configs[point.config];
  // An area works under the point's name, so that points at the same time do not meet.
  const Json result = point.is_area ? measure_area(config.configuration(), sweep.targets,
                                                   (out / "area" / fs::path(point.file).stem()).string())
                                    : compute_picture(sweep, sweep.scenes[point.scene], config);
  const Json json = {{"format", "halfspace-point 1"}, {"point", point.what}, {"result", result}};
  model::write_file((out / point.file).string(), json.dump(1) + "\n");
}

std::vector<std::string> compute_points(const Sweep& sweep, int jobs) {
  std::vector<const SweepPoint*> todo;
  for (const SweepPoint& point : sweep.points) {
    if (stored_result(sweep, point).is_null()) todo.push_back(&point);
  }
  std::vector<std::string> failures;
  const std::size_t total = sweep.points.size();
  std::size_t done = total - todo.size();
  Progress progress("sweep");
  std::mutex mutex;
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t n = next++; n < todo.size(); n = next++) {
      std::string failure;
      try {
        compute_point(sweep, *todo[n]);
      } catch (const std::exception& error) {
        failure = error.what();
      }
      const std::lock_guard<std::mutex> lock(mutex);
      if (!failure.empty()) failures.push_back(failure);
      progress.tell(++done, total);
    }
  };
  std::vector<std::thread> threads;
  for (int n = 1; n < jobs; ++n) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  std::error_code not_empty;
  fs::remove(fs::path(sweep.input.out) / "area", not_empty);
  return failures;
}

}  // namespace halfspace::cli
