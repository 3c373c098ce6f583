// SPDX-License-Identifier: Apache-2.0
// What is wrong with a frame that the kernels made, against the reference and the derived bounds.
#ifndef HALFSPACE_TESTS_FORMATS_EXTREMES_FRAME_JUDGE_HPP_
#define HALFSPACE_TESTS_FORMATS_EXTREMES_FRAME_JUDGE_HPP_

#include <fmt/format.h>

#include <memory>
#include <optional>

#include "model/pipeline/engine.hpp"
#include "study/proofs/motion_bounds.hpp"
#include "tests/formats/extremes/texture_bound.hpp"

namespace halfspace::tests {

// One frame of one configuration. What is exact is computed once; fault() may be asked for many engines.
class FrameJudge {
 public:
  FrameJudge(const Config& config, const model::NamedFrame& frame)
      : c_(config), frame_(frame), reference_(ref::render(frame.scene)) {
    if (has_motion(c_)) return;
    const ShadeBound shade(c_, frame_);
    std::optional<TextureBound> texture;
    if (has_texture(c_)) texture.emplace(c_, frame_);
    for_shown([&](std::size_t, std::uint32_t k, const ExactPixel& pixel) {
      const ColourBound lit = shade.at(k, pixel);
      bound_.push_back(texture ? texture->at(k, pixel, lit) : lit);
    });
  }

  // Empty if nothing is.
  std::string fault(model::Engine& engine, Measured* measured = nullptr) const {
    model::load_frame(engine, c_, frame_);
    if (has_motion(c_)) return motion_fault(engine, measured);
    const ref::Frame kernels = engine.render(frame_.scene);
    std::string what = visibility_fault(kernels);
    if (what.empty()) what = colour_fault(kernels, measured);
    if (what.empty() && has_objects(c_)) what = object_fault(engine, kernels);
    return what;
  }

 private:
  template <class Visit>
  void for_shown(Visit visit) const {
    for (std::size_t at = 0; at < reference_.index.size(); ++at) {
      const std::uint32_t k = reference_.index[at];
      if (k == 0) continue;
      const int x = int(at) % reference_.width, y = int(at) / reference_.width;
      visit(at, k, ExactPixel(frame_.scene.triangles[k - 1], x, y, c_.subpixel_bits));
    }
  }
  std::string where(const char* what, std::size_t at) const {
    return fmt::format("{} at ({}, {})", what, int(at) % reference_.width, int(at) / reference_.width);
  }

  std::string visibility_fault(const ref::Frame& kernels) const {
    for (std::size_t at = 0; at < reference_.index.size(); ++at) {
      if (kernels.index[at] != reference_.index[at]) return where("index", at);
      // Type γ stores no depth.
      if (stores_depth(c_) && std::abs(std::int64_t(kernels.depth[at]) - std::int64_t(reference_.depth[at])) > 1)
        return where("depth", at);
    }
    return kernels.visible == reference_.visible ? "" : "visible";
  }

  std::string colour_fault(const ref::Frame& kernels, Measured* measured) const {
    std::string what;
    std::size_t n = 0;
    for_shown([&](std::size_t at, std::uint32_t, const ExactPixel&) {
      const ColourBound& bound = bound_[n++];
      if (!what.empty()) return;
      std::array<int, 3> rgb;
      for (std::size_t c = 0; c < 3; ++c) rgb[c] = ref::snapped_colour(kernels.colour[at][c], c_.colour_bits);
      for (std::size_t c = 0; measured && c < 3; ++c) {
        if (bound.boxes.empty()) ++measured->blind;
        else
          measured->see(std::fabs(rgb[c] - bound.exact[c]), rgb[c] != int(std::floor(bound.exact[c] + 0.5)),
                        bound.is_sharp(c));
      }
      for (const ColourBox& box : bound.boxes) {
        if (box.holds(rgb)) return;
      }
      if (bound.boxes.empty()) return;
      what = where("colour", at) + fmt::format(": {}, {}, {} for {:.3f}, {:.3f}, {:.3f}", rgb[0], rgb[1], rgb[2],
                                               bound.exact[0], bound.exact[1], bound.exact[2]);
    });
    return what;
  }

  std::string object_fault(model::Engine& engine, const ref::Frame& kernels) const {
    const std::vector<model::RawEntry> entries = engine.entries(frame_.scene);
    for (std::size_t at = 0; at < entries.size(); ++at) {
      const std::uint32_t k = reference_.index[at];
      // Without numbers of its own a frame has four triangles an object.
      const std::uint32_t most = (1u << c_.object_bits) - 1;
      const std::uint32_t object = k == 0 ? 0 : frame_.objects.empty() ? 1 + (k - 1) / 4 % most : frame_.objects[k - 1];
      if (entries[at].object != object) return where("object", at);
      if (entries[at].depth != kernels.depth[at]) return where("depth of an entry", at);
    }
    return "";
  }

  std::string motion_fault(model::Engine& engine, Measured* measured) const {
    ref::Frame kernels;
    const std::vector<model::RawMotion> words = engine.motion(frame_.scene, &kernels);
    for (std::size_t at = 0; at < reference_.index.size(); ++at) {
      if (kernels.index[at] != reference_.index[at]) return where("index", at);
    }
    std::vector<const model::RawMotion*> word_at(reference_.index.size());
    for (const model::RawMotion& word : words) {
      const std::size_t at = std::size_t(word.y) * std::size_t(reference_.width) + std::size_t(word.x);
      if (word.x >= reference_.width || at >= word_at.size() || word_at[at]) return "a word of no pixel";
      word_at[at] = &word;
    }
    std::string what;
    for_shown([&](std::size_t at, std::uint32_t k, const ExactPixel& pixel) {
      if (!what.empty()) return;
      const model::RawMotionVectors& given = frame_.motion.triangles[k - 1];
      if (!word_at[at]) return void(what = where("no word", at));
      if (word_at[at]->face != std::uint32_t(given.face)) return void(what = where("face", at));
      for (std::size_t key = 0; key < 2 && what.empty(); ++key)
        what = key_fault(given.key[key], word_at[at]->key[key], pixel, at, measured);
    });
    return what;
  }

  std::string key_fault(const model::RawKeyPlaces& given, const model::RawKeyVector& got, const ExactPixel& pixel,
                        std::size_t at, Measured* measured) const {
    if (!given.there) return got.there ? where("a key that is not there", at) : "";
    const double unit = std::ldexp(1.0, -c_.vector_fraction), end = std::ldexp(1.0, c_.vector_range);
    const int place[2] = {int(at) % reference_.width, int(at) / reference_.width};
    bool may = true, must = true;
    double vector[2], error[2];
    for (int axis = 0; axis < 2; ++axis) {
      const Place part = exact_part(c_, axis ? given.t : given.s, given.q, pixel);
      vector[axis] = (axis ? given.origin_y : given.origin_x) + std::ldexp(part.at, given.extent) - place[axis] - 0.5;
      error[axis] = std::ldexp(part.error, given.extent) + kTinyShare * (1 + std::fabs(vector[axis]));
      const double low = -end - unit / 2, high = end - unit / 2;  // of what rounds to a vector
      may = may && vector[axis] >= low - error[axis] && vector[axis] < high + error[axis];
      must = must && vector[axis] >= low + error[axis] && vector[axis] < high - error[axis];
    }
    if (got.there && !may) return where("a vector out of range", at);
    if (!got.there && must) return where("no vector", at);
    for (int axis = 0; axis < 2 && got.there; ++axis) {
      const double off = std::fabs((axis ? got.y : got.x) * unit - vector[axis]);
      if (off > error[axis] + unit / 2)
        return where("vector", at) + fmt::format(": {:.4f} pixels off, bound {:.4f}", off, error[axis] + unit / 2);
      if (measured) measured->see(off, off > unit / 2, error[axis] <= unit);
    }
    return got.there && relights(c_) ? difference_fault(given, got, pixel, at) : "";
  }

  std::string difference_fault(const model::RawKeyPlaces& given, const model::RawKeyVector& got,
                               const ExactPixel& pixel, std::size_t at) const {
    for (std::size_t c = 0; c < 3; ++c) {
      const double exact = pixel.plane(given.difference[c]) - std::ldexp(1.0, difference_bits(c_) - 1);
      if (std::fabs(got.difference[c] - exact) > model::difference_bound(c_, pixel.distance()) + kTinyShare)
        return where("difference", at);
    }
    return "";
  }

  const Config c_;
  const model::NamedFrame& frame_;
  const ref::Frame reference_;
  std::vector<ColourBound> bound_;  // of the pixels that show a triangle, in order
};

}  // namespace halfspace::tests

#endif  // HALFSPACE_TESTS_FORMATS_EXTREMES_FRAME_JUDGE_HPP_
