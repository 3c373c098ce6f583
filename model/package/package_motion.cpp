// SPDX-License-Identifier: Apache-2.0
#include "hls/motion/key_weights.hpp"
#include "model/package/package_writer.hpp"

namespace halfspace::model {
namespace {

int fraction_of(const Config& c) { return c.vector_fraction + log2_samples(c); }

void add_table(PackageWriter& out, const char* name, const std::vector<std::uint64_t>& entries, int bits) {
  out.entries(name, entries, bits, int(entries.size() - 1) % 6 + 1);
}

// The weights of an axis (hls/motion/key_weights.hpp): of the pixel behind a place; bicubic, of those one further,
// behind and before it.
void add_key_tables(PackageWriter& out) {
  const Config& c = out.config();
  const bool is_bicubic = has_motion(c) && c.filter == KeyFilter::kBicubic,
             has_inner = has_motion(c) && c.filter != KeyFilter::kNearest;
  std::vector<std::uint64_t> inner, outer;
  const int g = fraction_of(c), w = c.weight_bits, bits = out.table().tap_weight.width;
  for (int n = 0; n < 1 << g; ++n) {
    inner.push_back(std::uint64_t(axis_weights(inner_filter(c.filter), n, g, w).tap[2]));
    const AxisWeights weights = axis_weights(c.filter, n, g, w);
    std::uint64_t entry = 0;
    for (const int tap : {3, 2, 0})
      entry = entry << bits | (std::uint64_t(weights.tap[tap]) & ((std::uint64_t(1) << bits) - 1));
    outer.push_back(entry);
  }
  if (has_inner) add_table(out, "KeyInnerTable", inner, w + 1);
  else out.no_table("KeyInnerTable");
  if (is_bicubic) add_table(out, "KeyOuterTable", outer, 3 * bits);
  else out.no_table("KeyOuterTable");
}

// The fraction, counted from an end of the table, where tap 1 (before a place) or 2 (behind it) first has a weight.
int weighted(const Config& c, int tap, int step) {
  const int g = fraction_of(c);
  int n = 1;
  while (n < 1 << g &&
         axis_weights(inner_filter(c.filter), step > 0 ? n : (1 << g) - n, g, c.weight_bits).tap[tap] == 0)
    ++n;
  return n;
}

}  // namespace

void add_motion(PackageWriter& out) {
  using T = FormatTable;
  const Config& c = out.config();
  const auto number = [&](const char* name, int value) { out.number(name, has_motion(c) ? value : 0); };
  out.constants({"HasMotion"});
  out.number("Relight", relights(c));
  out.bits({&T::face, &T::origin, &T::extent, &T::vector});
  out.constants({"VectorFraction"});
  out.bits({&T::key_weight, &T::difference});
  number("KeyTaps", c.filter == KeyFilter::kNearest ? 1 : c.filter == KeyFilter::kBicubic ? 4 : 2);
  number("KeySide", key_side(c.filter));
  number("KeyFractionBits", fraction_of(c));
  number("KeyFirstBehind", weighted(c, 2, 1));
  number("KeyLastBefore", (1 << fraction_of(c)) - weighted(c, 1, -1));
  out.bits({&T::key_place, &T::tap_weight, &T::key_sum, &T::tile_x, &T::tile_y});
  out.words({"KeyRequest", "KeyBlock", "Compensated"});
  out.bits({&T::difference_plane});
  out.words({"MotionVectors", "MotionPlanes", "Motion"});
  add_key_tables(out);
  out.constants({"UpConverts", "FramesBetween"});
  out.words({"ShownPixel", "Asked", "FilmPixel"});
}

}  // namespace halfspace::model
