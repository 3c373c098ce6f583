// SPDX-License-Identifier: Apache-2.0
// What is wrong with what motion_compensate and ztest_merge made: to the bit against their definitions, and
// compensation within the bound of its weights against the reference.
#ifndef HALFSPACE_TESTS_FORMATS_EXTREMES_UNIT_JUDGES_HPP_
#define HALFSPACE_TESTS_FORMATS_EXTREMES_UNIT_JUDGES_HPP_

#include <fmt/format.h>

#include <string>

#include "ref/motion/compensate.hpp"
#include "study/bounds/compensation_exact.hpp"
#include "tests/formats/extremes/exact_pixel.hpp"
#include "tests/objects/merge_model.hpp"
#include "vectors/frames/compensation_frames.hpp"
#include "vectors/frames/merge_frames.hpp"

namespace halfspace::tests {

// Empty if nothing is.
inline std::string compensation_fault(const Config& config, const model::Compensator& kernels,
                                      const model::NamedCompensation& frame) {
  const model::CompensationModel definition(config, false);
  const model::CompensationInput input = frame.input();
  const model::CompensatedFrame got = kernels.run(input);
  std::vector<model::RawMotion> order = frame.motion;
  model::order_by_tiles(order, config);
  if (got.pixels.size() != std::max<std::size_t>(order.size(), 1)) return "words";
  for (std::size_t n = 0; n < order.size(); ++n) {
    const model::CompensationModel::Pixel want = definition.pixel(input, order[n]);
    const auto here = [&](const char* what) { return fmt::format("{} at ({}, {})", what, order[n].x, order[n].y); };
    if (got.pixels[n].x != order[n].x || got.pixels[n].y != order[n].y) return here("order");
    if (got.pixels[n].keys != want.keys) return here("keys");
    for (std::size_t c = 0; c < 3; ++c) {
      if (got.pixels[n].rgb[c] != definition.displayed(want.value[c])) return here("colour");
    }
  }
  return "";
}

// Of the reference, with exact weights: a channel, clamped. Pixels of which the keys differ, as a weight too small for
// the table is none, are blind.
inline std::string compensation_reference_fault(const Config& config, const model::Compensator& kernels,
                                                const model::NamedCompensation& frame, Measured& measured) {
  const ref::CompensationMode mode{ref::Filter(int(config.filter) - int(KeyFilter::kNearest)), true, {true, true}, 0};
  const model::CompensationInput input = frame.input();
  ref::OfKeys<ref::KeyFrame> key;
  for (std::size_t k = 0; k < 2; ++k) {
    key[k].width = frame.key[k].width, key[k].height = frame.key[k].height;
    for (const auto& rgb : frame.key[k].rgb) key[k].colour.push_back({rgb[0], rgb[1], rgb[2], 255});
    key[k].identity = frame.key[k].face;
  }
  const double full = (1 << config.colour_bits) - 1, a = std::ldexp(frame.weight, -config.weight_bits);
  const double weights = config.filter == KeyFilter::kNearest ? 0 : config.filter == KeyFilter::kBicubic ? 4 : 1;
  const double bound = 0.5 + full * std::ldexp(weights, -config.weight_bits) + 1e-9;
  std::vector<model::RawMotion> order = frame.motion;
  model::order_by_tiles(order, config);
  const model::CompensatedFrame got = kernels.run(input);
  for (std::size_t n = 0; n < order.size(); ++n) {
    const model::RawMotion& m = order[n];
    std::array<std::optional<glm::dvec3>, 2> shown;
    for (std::size_t k = 0; k < 2; ++k) {
      const model::RawKeyVector& v = m.key[k];
      if (m.face == 0 || !v.there) continue;
      const glm::dvec2 way = glm::dvec2(v.x, v.y) * std::ldexp(1.0, -config.vector_fraction);
      shown[k] = ref::fetch(key[k], (glm::dvec2(m.x + 0.5, m.y + 0.5) + way) / double(config.samples), m.face, mode);
      if (shown[k])
        *shown[k] +=
            glm::dvec3(v.difference[0], v.difference[1], v.difference[2]) * std::ldexp(1.0, -kDifferenceFraction);
    }
    if (int(shown[0].has_value()) + 2 * int(shown[1].has_value()) != got.pixels[n].keys) {
      ++measured.blind;
      continue;
    }
    if (got.pixels[n].keys == 0) continue;
    const glm::dvec3 exact = shown[0] && shown[1] ? a * *shown[0] + (1 - a) * *shown[1]
                             : shown[0]           ? *shown[0]
                                                  : *shown[1];
    for (int c = 0; c < 3; ++c) {
      const double value = std::clamp(exact[c], 0.0, full), off = std::fabs(got.pixels[n].rgb[std::size_t(c)] - value);
      if (off > bound) return fmt::format("reference at ({}, {}): {:.3f} off, bound {:.3f}", m.x, m.y, off, bound);
      measured.see(off, off > 0.5);
    }
  }
  return "";
}

inline std::string merge_fault(const Config& config, const model::Merger& kernels, int lanes,
                               const model::NamedMerge& run) {
  const model::MergeInput input = run.input();
  const Expected want = expected(input, ref::full_depth(config.depth_bits), lanes);
  const model::MergeResult got = kernels.run(input);
  if (got.count != want.count) return fmt::format("count: {} for {}", got.count, want.count);
  if (got.box.x0 != want.box.x0 || got.box.y0 != want.box.y0 || got.box.x1 != want.box.x1 || got.box.y1 != want.box.y1)
    return "box";
  return run.sends && !(got.merged == want.merged) ? "merged" : "";
}

}  // namespace halfspace::tests

#endif  // HALFSPACE_TESTS_FORMATS_EXTREMES_UNIT_JUDGES_HPP_
