// SPDX-License-Identifier: Apache-2.0
// Vectors of the motion field, and the colours that are fetched along them.
#include <algorithm>
#include <cmath>
#include <random>

#include "model/motion/compensation.hpp"
#include "study/bounds/bounds_measure.hpp"
#include "study/bounds/compensation_exact.hpp"
#include "study/bounds/coordinate_words.hpp"
#include "study/proofs/motion_bounds.hpp"
#include "study/proofs/shown_bounds.hpp"
#include "study/proofs/texture_bounds.hpp"
#include "vectors/frames/awkward.hpp"

namespace halfspace::model {
namespace {

constexpr std::size_t kPixels = 100;        // of a triangle that are looked at
constexpr std::size_t kShownPixels = 8000;  // of all that are compensated

// Where a point is in a key frame, from the pixel, and the bound of it, in pixels of the frame in between.
struct ExactVector {
  std::array<double, 2> way, bound;
};

class MotionMeter : public FeatureMeter {
 public:
  MotionMeter(const Configuration& configuration, KernelProbe& probe, BoundsReport& report)
      : configuration_(configuration), config_(configuration.config()), probe_(probe), report_(report) {}

  void measure(const MeasuredTriangle& m) override {
    std::mt19937_64 random(seed_of(m.triangle));
    const bool premise = random() % 4 != 0;
    const RawMotionVectors words = premise ? near_words(m.triangle, random) : awkward_words(m.triangle, random);
    probe_.give(words);
    const std::size_t step = std::max<std::size_t>(1, m.pixels.size() / kPixels);
    for (std::size_t n = 0; n < m.pixels.size(); n += step) {
      const int x = m.pixels[n].x, y = m.pixels[n].y;
      const RawMotion motion = probe_.motion(x, y);
      for (int key = 0; key < kKeys; ++key) {
        const RawKeyPlaces& places = words.key[std::size_t(key)];
        const RawKeyVector& vector = motion.key[std::size_t(key)];
        BoundRow& fits = report_.rows[kVectorFits];
        if (!places.there) {
          if (fits.count(1, vector.there)) fits.where = m.at(x, y);
          continue;
        }
        const ExactVector exact = exact_vector(m.exact, places, x, y);
        if (fits.count(1, !may_be(vector.there, exact))) fits.where = m.at(x, y);
        if (!vector.there) continue;
        BoundRow& row = report_.rows[kVector];
        for (const bool along_x : {true, false}) {
          const double error =
              std::ldexp(along_x ? vector.x : vector.y, -config_.vector_fraction) - exact.way[!along_x];
          const double bound = exact.bound[!along_x];
          if (premise ? row.see(error, bound) : row.hold(error, bound)) row.where = m.at(x, y);
        }
        if (key == 0 && premise) keep(m, motion, exact, places);
      }
    }
  }

  void finish() override;

 private:
  void compensate(CompensationInput& input);

  // A pixel that is to be compensated along its vector to key 0.
  struct Kept {
    RawMotion motion;
    ExactVector exact;
    std::array<double, 3> difference;  // exact, in LSB
    double difference_bound;
    Witness where;
  };

  double full() const { return std::ldexp(1.0, config_.coordinate_bits) - 1; }

  ExactVector exact_vector(const ExactTriangle& exact, const RawKeyPlaces& key, int x, int y) const {
    const double q = has_perspective(config_) ? double(exact.quotient(exact.in_order(key.q), x, y)) : full() + 1;
    const double distance = exact.distance(x, y);
    ExactVector out{};
    for (const int axis : {0, 1}) {
      const double part = double(exact.quotient(exact.in_order(axis ? key.t : key.s), x, y)) / q;
      const double from = (axis ? key.origin_y - y : key.origin_x - x) - 0.5;
      out.way[std::size_t(axis)] = std::ldexp(part, key.extent) + from;
      out.bound[std::size_t(axis)] = motion_bound(config_, key.extent, part, q, distance);
    }
    return out;
  }

  // Whether a vector may be there, or missing: where both axes fit with all that they are off, or one does not.
  bool may_be(bool there, const ExactVector& exact) const {
    const double range = std::ldexp(1.0, config_.vector_range), unit = std::ldexp(1.0, -config_.vector_fraction);
    bool surely = true, surely_not = false;
    for (const std::size_t axis : {0, 1}) {
      const double low = exact.way[axis] - exact.bound[axis], high = exact.way[axis] + exact.bound[axis];
      surely = surely && low >= -range && high <= range - unit;
      surely_not = surely_not || high < -range || low > range - unit;
    }
    return there ? !surely_not : !surely;
  }

  RawMotionVectors awkward_words(const ref::SnappedTriangle& triangle, std::mt19937_64& random) const {
    ref::SnappedList list;
    list.triangles.assign(8, triangle);
    const MotionFrame frame = awkward_motion(list, config_, random());
    return frame.triangles[random() % 8];
  }

  // Of the premises of the proved number, near the triangle where it covers the frame.
  RawMotionVectors near_words(const ref::SnappedTriangle& triangle, std::mt19937_64& random) const {
    const std::int64_t most = std::int64_t(full()), least = std::int64_t(least_q(config_));
    const int range = 1 << (config_.range_bits - 1), differences = 1 << difference_bits(config_);
    RawMotionVectors out;
    out.face = 1;
    for (RawKeyPlaces& key : out.key) {
      const std::uint64_t kind = random() % 4;
      key.there = true;
      key.extent = vector_extent(config_);
      auto origin = [&](const std::array<std::int32_t, 3>& at, int size) {
        const int around = std::clamp(at[random() % 3] >> config_.subpixel_bits, 0, size);
        return std::clamp(around - int(random() % (std::uint64_t(1) << key.extent)), -range, range - 1);
      };
      key.origin_x = origin(triangle.x, config_.width);
      key.origin_y = origin(triangle.y, config_.height);
      for (int v = 0; v < 3; ++v) {
        draw_coordinates(key, std::size_t(v), kind, config_, least, most, random);
        if (!relights(config_)) continue;
        for (auto& channel : key.difference) {
          channel[v] = int(random() % 2 ? 1 + random() % 2 * std::uint64_t(differences - 2)
                                        : 1 + random() % std::uint64_t(differences - 1));
        }
      }
    }
    return out;
  }

  void keep(const MeasuredTriangle& m, const RawMotion& motion, const ExactVector& exact, const RawKeyPlaces& places) {
    const std::uint64_t at = seen_++;
    const Witness where = m.at(motion.x, motion.y);
    Kept kept = {motion, exact, {}, 0, where};
    kept.motion.face = 1;
    kept.motion.key[1] = {};
    for (std::size_t c = 0; c < 3 && relights(config_); ++c) {
      const double value = double(m.exact.quotient(m.exact.in_order(places.difference[c]), motion.x, motion.y));
      kept.difference[c] = std::ldexp(value - std::ldexp(1.0, difference_bits(config_) - 1), -kDifferenceFraction);
    }
    if (relights(config_)) {
      kept.difference_bound =
          std::ldexp(difference_bound(config_, m.exact.distance(motion.x, motion.y)), -kDifferenceFraction);
    }
    if (kept_.size() < kShownPixels) kept_.push_back(kept);
    else if (at % 7 == 0) kept_[at / 7 % kShownPixels] = kept;
  }

  const Configuration configuration_;
  const Config config_;
  KernelProbe& probe_;
  BoundsReport& report_;
  std::vector<Kept> kept_;
  std::uint64_t seen_ = 0;
};

// Of all pixels at once, from key frames of one face, of colours as different as can be; from one key, then from both.
void MotionMeter::finish() {
  const int s = config_.samples;
  std::mt19937_64 random(1);
  std::array<KeyFrame, 2> keys;
  for (KeyFrame& key : keys) {
    key.width = (config_.width + s - 1) / s, key.height = (config_.height + s - 1) / s;
    for (int n = 0; n < key.width * key.height; ++n) {
      key.face.push_back(1);
      for (auto& channel : key.rgb.emplace_back())
        channel = std::uint8_t(random() % 2 * ((1u << config_.colour_bits) - 1));
    }
  }
  CompensationInput input = {config_.width, config_.height, {&keys[0], &keys[1]}, {}, 1 << config_.weight_bits};
  compensate(input);
  input.weight = (1 << (config_.weight_bits - 1)) - 1;
  for (Kept& kept : kept_) kept.motion.key[1] = kept.motion.key[0];
  compensate(input);
  // Of a frame that is smaller than a filter, or of vectors that may be off by a pixel, no colour is told.
  if (report_.rows[kShown].compared == 0) report_.rows[kShown] = {};
}

void MotionMeter::compensate(CompensationInput& input) {
  // The order in which words are sent.
  std::vector<std::size_t> order;
  input.motion.clear();
  for (std::size_t n = 0; n < kept_.size(); ++n) {
    input.motion.push_back(kept_[n].motion);
    input.motion.back().face = std::uint32_t(n);
  }
  order_by_tiles(input.motion, config_);
  for (RawMotion& m : input.motion) order.push_back(m.face), m.face = 1;
  const CompensatedFrame got = Compensator(configuration_).run(input);
  const CompensationModel model(config_, true);
  const double full = (1 << config_.colour_bits) - 1, weight = std::ldexp(input.weight, -config_.weight_bits);
  BoundRow& row = report_.rows[kShown];
  for (std::size_t n = 0; n < order.size(); ++n) {
    const Kept& kept = kept_[order[n]];
    const auto first = model.around(input, kept.motion, 0, kept.exact.way, kept.exact.bound);
    const auto second = model.around(input, kept.motion, 1, kept.exact.way, kept.exact.bound);
    if (!first || !second) continue;  // at the border of the key, or of the pixels of a nearest
    const double bound = between_bound(config_, kept.exact.bound[0], kept.exact.bound[1], kept.difference_bound);
    for (std::size_t c = 0; c < 3; ++c) {
      const double value = weight * (*first)[c] + (1 - weight) * (*second)[c] + kept.difference[c];
      if (row.see(double(got.pixels[n].rgb[c]) - std::clamp(value, 0.0, full), bound)) row.where = kept.where;
    }
  }
}

}  // namespace

std::unique_ptr<FeatureMeter> make_motion_meter(const Configuration& configuration, KernelProbe& probe,
                                                BoundsReport& report) {
  return std::make_unique<MotionMeter>(configuration, probe, report);
}

}  // namespace halfspace::model
