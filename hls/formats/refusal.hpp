// SPDX-License-Identifier: Apache-2.0
// Whether a configuration can be built, and why not.
#ifndef HALFSPACE_HLS_FORMATS_REFUSAL_HPP_
#define HALFSPACE_HLS_FORMATS_REFUSAL_HPP_

#include <cstdint>

#include "hls/formats/config.hpp"

namespace halfspace {

// Why a configuration is refused; the first reason that holds. refusal_text() of the model has them as sentences.
enum class Refusal {
  kNone,
#define HS_LIMIT(name, more) name,
#define HS_REFUSAL(name, sentence) name,
#include "hls/formats/lists/refusal_list.hpp"
};

// What a number may be.
struct Limits {
  int low, high;
  bool is_power, is_optional;  // a power of two; or 0
};
namespace limits {
constexpr Limits range(int low, int high) { return {low, high, false, false}; }
constexpr Limits power(int low, int high) { return {low, high, true, false}; }
constexpr Limits or_none(const Limits& l) { return {l.low, l.high, l.is_power, true}; }
}  // namespace limits
constexpr bool allows(const Limits& allowed, int value) {
  return (allowed.is_optional && value == 0) ||
         (value >= allowed.low && value <= allowed.high && (!allowed.is_power || value == 1 << exact_log2(value)));
}

// Choices that contradict one another.
constexpr Refusal choice_refusal(const Config& c) {
  if (is_phong(c) && !has_lighting(c)) return Refusal::kUnlitPhong;
  if (tests_planes(c) && !has_depth(c)) return Refusal::kIdleArchitecture;
  if (!shades(c) && (has_lighting(c) || has_texture(c))) return Refusal::kMotionShading;
  if (!shades(c) && up_converts(c)) return Refusal::kFilmShading;
  if (up_converts(c) && c.samples > 1) return Refusal::kFilmSamples;
  if (up_converts(c) && gives_indices(c)) return Refusal::kFilmIndices;
  if (has_motion(c) && c.filter == KeyFilter::kNone) return Refusal::kFilter;
  if (has_objects(c) && (!stores_depth(c) || has_motion(c))) return Refusal::kObjectsNeedDepth;
  return Refusal::kNone;
}

// Of a field of what is not there.
constexpr Refusal idle_refusal(Part part) {
  return part == Part::kLighting                                ? Refusal::kIdleLighting
         : part == Part::kTexture || part == Part::kCoordinates ? Refusal::kIdleTexture
         : part == Part::kMotion                                ? Refusal::kIdleMotion
                                                                : Refusal::kIdleBits;
}

// Each field by itself.
constexpr Refusal field_refusal(const Config& c) {
  using limits::or_none;
  using limits::power;
  using limits::range;
#define HS_NUMBER(part, field, is_there, allowed, refused, what)     \
  if (!is_there(c) && c.field != 0) return idle_refusal(Part::part); \
  if (is_there(c) && !allows(allowed, c.field)) return Refusal::refused;
#define HS_CHOICE(part, field, Type, what, ...) \
  if (!has_part(Part::part, c) && c.field != Type(0)) return idle_refusal(Part::part);
#include "hls/formats/lists/config_list.hpp"
  return Refusal::kNone;
}

// Whether the centres of all stamps, and of the stamps around the frame, are positions.
constexpr Refusal range_refusal(const Config& c) {
  const int margin = 3 * 4;  // pixels of the stamps around the frame, 4 at most each way
  return max_of(c.width, c.height) + margin > 1 << (c.range_bits - 1) ? Refusal::kFrameOutsideRange : Refusal::kNone;
}

// |error| <= 2^(b−r) + (|dx| + |dy|)·2^−(g+1) < ½ LSB, for the farthest vertex that a pixel of the frame can be
// measured from; both sides times 2^(g+1).
constexpr bool plane_error_ok(const Config& c, int b, int g) {
  const std::int64_t reach = (std::int64_t(1) << c.range_bits) + c.width + c.height;
  const int n = b + g + 1 - c.reciprocal_bits;
  return b < c.reciprocal_bits && reach < (std::int64_t(1) << g) - (n < 0 ? 0 : std::int64_t(1) << n);
}

// Whether every rounded value of a plane is one of its values.
constexpr Refusal error_refusal(const Config& c) {
  if (has_depth(c) && !plane_error_ok(c, c.depth_bits, c.depth_fraction)) return Refusal::kDepthError;
  const int colour = colour_plane_bits(c);
  if (has_colour_planes(c) && !plane_error_ok(c, colour, c.colour_fraction)) return Refusal::kColourError;
  const int normal = normal_plane_bits(c);
  if (is_phong(c) && !plane_error_ok(c, normal, c.normal_fraction)) return Refusal::kNormalError;
  const int coordinate = c.coordinate_bits;
  if (has_coordinates(c) && !plane_error_ok(c, coordinate, c.coordinate_fraction)) return Refusal::kCoordinateError;
  return Refusal::kNone;
}

// Whether every number, and what is computed on its way, is one machine word.
constexpr Refusal word_refusal(const Config& c) {
  const int colour = colour_plane_bits(c), normal = normal_plane_bits(c), coordinate = c.coordinate_bits;
  const int longer_side = max_of(c.width, c.height);
  const int fraction =
      max_of(max_of(c.depth_fraction, c.colour_fraction), max_of(c.normal_fraction, c.coordinate_fraction));
  if (has_planes(c) && c.reciprocal_bits < c.subpixel_bits + fraction) return Refusal::kReciprocalShort;
  const int position = c.range_bits + c.subpixel_bits;
  const int value = max_of(max_of(c.depth_bits, colour), max_of(normal, coordinate));
  const int numerator = value + position + 1;
  if (2 * position + 3 > 64) return Refusal::kEdgeWord;
  if (numerator + 2 > 64) return Refusal::kNumeratorWord;  // the sum of its two products, as types grow
  if (numerator - 24 + c.reciprocal_bits + 1 > 63 || 24 + c.reciprocal_bits + 1 > 63) return Refusal::kGradientWord;
  // n of rounded_product, where D is largest.
  const int n = 2 * position - 1 + c.reciprocal_bits - c.subpixel_bits;
  if ((has_depth(c) && n - c.depth_fraction > 63) || (has_colour_planes(c) && n - c.colour_fraction > 63) ||
      (is_phong(c) && n - c.normal_fraction > 63) || (has_coordinates(c) && n - c.coordinate_fraction > 63)) {
    return Refusal::kGradientWord;
  }
  if (c.depth_bits + c.depth_fraction + c.subpixel_bits > 63 || colour + c.colour_fraction + c.subpixel_bits > 63 ||
      normal + c.normal_fraction + c.subpixel_bits > 63 || coordinate + c.coordinate_fraction + c.subpixel_bits > 63) {
    return Refusal::kStartWord;
  }
  const int plane =
      max_of(max_of(colour + c.colour_fraction, normal + c.normal_fraction), coordinate + c.coordinate_fraction);
  if (plane + bits_for(longer_side) > 64) return Refusal::kShadeWord;
  if (tests_planes(c) && c.depth_bits + c.depth_fraction + bits_for(longer_side) > 64) return Refusal::kTestWord;
  return Refusal::kNone;
}

constexpr Refusal refusal(const Config& c) {
  if (choice_refusal(c) != Refusal::kNone) return choice_refusal(c);
  if (field_refusal(c) != Refusal::kNone) return field_refusal(c);
  if (range_refusal(c) != Refusal::kNone) return range_refusal(c);
  if (error_refusal(c) != Refusal::kNone) return error_refusal(c);
  return word_refusal(c);
}

// Compiles for an accepted configuration alone: a compiler that refuses prints the reason as the argument.
template <Refusal R>
struct AcceptedConfig {
  static_assert(R == Refusal::kNone, "this configuration is refused: the argument R of AcceptedConfig says why");
};

}  // namespace halfspace

#endif  // HALFSPACE_HLS_FORMATS_REFUSAL_HPP_
