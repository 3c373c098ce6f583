// SPDX-License-Identifier: Apache-2.0
#include "study/trade/trade.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>

#include "model/pipeline/engine.hpp"

namespace halfspace::model {

PictureError picture_error(const ref::IdealFrame& ideal, const ref::TriangleList& list, const ref::Frame& frame,
                           int depth_bits) {
  PictureError result;
  result.pixels = ideal.face.size();
  const double full = depth_bits ? ref::full_depth(depth_bits) : 0;
  double squares = 0, colour_squares = 0, depth_squares = 0;
  for (std::size_t n = 0; n < ideal.face.size(); ++n) {
    const std::uint32_t face = ref::face_of(list, frame.index[n]);
    double largest = 0, sum = 0;
    for (int c = 0; c < 3; ++c) {
      const double error = std::abs(frame.colour[n][c] - ideal.colour[n][c]);
      largest = std::max(largest, error);
      sum += error * error;
    }
    squares += sum;
    if (face != ideal.face[n]) {
      ++result.index_differ;
      result.covered_differ += (face == 0) != (ideal.face[n] == 0);
    } else if (face != 0) {
      ++result.compared;
      result.colour_largest = std::max(result.colour_largest, largest);
      colour_squares += sum;
      const double error = depth_bits ? std::abs(frame.depth[n] - ideal.depth[n] * full) : 0;
      result.depth_largest = std::max(result.depth_largest, error);
      depth_squares += error * error;
    }
  }
  if (result.compared != 0) {
    result.colour_rms = std::sqrt(colour_squares / (3 * double(result.compared)));
    result.depth_rms = std::sqrt(depth_squares / double(result.compared));
  }
  result.psnr = squares == 0 ? std::numeric_limits<double>::infinity()
                             : 10 * std::log10(255.0 * 255 * 3 * double(result.pixels) / squares);
  return result;
}

StoredError stored_error(const ref::Frame& reference, const ref::Frame& kernels, int depth_bits) {
  StoredError result;
  if (reference.exact_colour.empty()) result.colour_largest.reset();
  for (std::size_t n = 0; n < reference.index.size(); ++n) {
    if (reference.index[n] == 0 || reference.index[n] != kernels.index[n]) continue;
    if (depth_bits) {
      result.depth_largest = std::max(result.depth_largest, std::abs(kernels.depth[n] - reference.exact_depth[n]));
    }
    for (int c = 0; c < 3 && result.colour_largest; ++c) {
      result.colour_largest =
          std::max(*result.colour_largest, std::abs(kernels.colour[n][c] - reference.exact_colour[n][c]));
    }
  }
  return result;
}

void ShimmerMeter::add(const ref::IdealFrame& ideal, const ref::TriangleList& list, const ref::Frame& frame) {
  const std::size_t pixels = ideal.face.size();
  const bool first = frames_++ == 0;
  if (first) error_.resize(pixels), wrong_.resize(pixels);
  for (std::size_t n = 0; n < pixels; ++n) {
    for (int c = 0; c < 3; ++c) {
      const auto error = float(frame.colour[n][c] - ideal.colour[n][c]);
      const double change = double(error) - error_[n][c];
      if (!first) squares_ += change * change;
      error_[n][c] = error;
    }
    const bool wrong = ref::face_of(list, frame.index[n]) != ideal.face[n];
    changes_ += !first && wrong != wrong_[n];
    wrong_[n] = wrong;
  }
}

Shimmer ShimmerMeter::result() const {
  const double steps = double(frames_ - 1);
  return {std::sqrt(squares_ / (3 * steps * double(error_.size()))), double(changes_) / steps};
}

namespace {

double median_ms(Engine& engine, const ref::SnappedList& scene) {
  std::array<double, 5> times;
  std::vector<std::array<std::uint8_t, 4>> colour;
  for (double& time : times) {
    const auto start = std::chrono::steady_clock::now();
    engine.render_colour(scene, colour);
    time = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  }
  std::nth_element(times.begin(), times.begin() + 2, times.end());
  return times[2];
}

}  // namespace

// Of a finished frame: each of its visible triangles is stored, each pixel reads the planes of its triangle, and texels
// if that has a texture.
std::uint64_t texture_bytes(const Config& c, const TextureFrame& textures, const ref::Frame& frame) {
  if (!has_texture(c)) return 0;
  std::vector<bool> seen(textures.triangles.size());
  std::uint64_t stored = 0, read = 0, texels = 0;
  for (const std::uint32_t index : frame.index) {
    if (index == 0) continue;
    stored += !seen[index - 1], seen[index - 1] = true;
    ++read;
    if (textures.triangles[index - 1].texture != 0) texels += is_bilinear(c) ? 4 : 1;
  }
  const int planes = coordinate_planes_bits(c);
  return bytes_of(stored, planes) + bytes_of(read, planes) + bytes_of(texels, texel_bits(c));
}

Trade measure_trade(const Subject& subject, int width, int height, const Configuration& configuration, int lanes,
                    const ref::IdealLook& look) {
  const Config config = configuration.config();
  const auto engine = make_engine(configuration, lanes);
  Trade trade;
  ShimmerMeter meter;
  for (int k = 0; k < kPanFrames; ++k) {
    const double x = k * kPanX, y = k * kPanY;
    const Subject::Drawn drawn = subject.drawn(config, width, height, x, y);
    const ref::SnappedList& scene = drawn.frame.scene;
    load_frame(*engine, config, drawn.frame);
    const ref::Frame frame = engine->render(scene);
    const ref::IdealFrame ideal = subject.ideal(look, width, height, x, y);
    meter.add(ideal, drawn.list, frame);
    if (k != 0) continue;
    trade.triangles = scene.triangles.size();
    trade.ideal = picture_error(ideal, drawn.list, frame, config.depth_bits);
    const ref::Frame reference = subject.reference(config, drawn);
    trade.reference = accuracy(reference, frame, config.depth_bits);
    trade.stored = stored_error(reference, frame, config.depth_bits);
    trade.intervals = unit_intervals(config);
    trade.cycles = model_cycles(config, *engine, scene, frame);
    trade.accesses = count_accesses(config, *engine, scene);
    trade.texture_bytes = texture_bytes(config, drawn.frame.texture, frame);
    trade.native_ms = median_ms(*engine, scene);
  }
  trade.shimmer = meter.result();
  trade.compiled = is_compiled(configuration);
  return trade;
}

}  // namespace halfspace::model
