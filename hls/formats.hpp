// SPDX-License-Identifier: Apache-2.0
// The format table: every width of every number is derived here, once, from the few numbers of a Config.
// The SystemVerilog package, the manifests of the vectors and the documentation are printed from it.
#ifndef HALFSPACE_HLS_FORMATS_HPP_
#define HALFSPACE_HLS_FORMATS_HPP_

#include <cstdint>

#include "fixed.hpp"

namespace halfspace {

// What a configuration chooses. Nothing here can be derived from the rest.
struct Config {
  const char* name;
  int width, height;      // largest frame, pixels
  int triangles;          // triangles a frame; indices 1 … triangles, 0 is the background
  int range_bits;         // vertices lie in [−2^(range_bits−1), 2^(range_bits−1)) pixels: the guard band
  int subpixel_bits;      // f: fraction bits of a vertex position
  int depth_bits;         // bits of a stored depth
  int reciprocal_bits;    // r: the reciprocal of the area has r fraction bits after its leading one
  int depth_fraction;     // g of the depth plane: fraction bits of its gradients
  int colour_fraction;    // g of the colour planes
};

// The hardware levels of index rendering: low-end, middle, high.
struct Low {
  static constexpr Config config() { return {"low", 320, 200, 4096, 10, 4, 16, 18, 13, 14}; }
};
struct Middle {
  static constexpr Config config() { return {"middle", 640, 480, 16384, 11, 8, 24, 26, 14, 15}; }
};
struct High {
  static constexpr Config config() { return {"high", 1920, 1080, 262144, 14, 8, 24, 28, 15, 18}; }
};

// A stamp is the X × Y block of pixels that the units handle in one cycle, one lane a pixel. Lane l is the pixel
// (l mod X, l div X) of its stamp.
template <int X, int Y>
struct StampShape {
  static constexpr int kX = X, kY = Y;
};
using Stamp1 = StampShape<1, 1>;
using Stamp2 = StampShape<2, 1>;
using Stamp4 = StampShape<2, 2>;
using Stamp8 = StampShape<4, 2>;
using Stamp16 = StampShape<4, 4>;

// Bits that hold 0 … n.
constexpr int bits_for(std::int64_t n) { return n < 2 ? 1 : 1 + bits_for(n / 2); }
// log2 of a power of two.
constexpr int exact_log2(int n) { return n < 2 ? 0 : 1 + exact_log2(n / 2); }

template <class C, class S>
struct Formats {
  static constexpr Config config() { return C::config(); }

  // --- the stamp and the frame ---
  static constexpr int kLanesX = S::kX, kLanesY = S::kY, kLanes = S::kX * S::kY;
  static constexpr int kLog2LanesX = exact_log2(kLanesX), kLog2LanesY = exact_log2(kLanesY);
  static_assert(kLanesX == 1 << kLog2LanesX && kLanesY == 1 << kLog2LanesY && kLanes <= 16,
                "a stamp is a power of two of pixels each way, and 16 at most");
  static constexpr int kWidth = config().width, kHeight = config().height;
  static constexpr int kStampsX = (kWidth + kLanesX - 1) / kLanesX;  // also the pitch of the buffers
  static constexpr int kStampsY = (kHeight + kLanesY - 1) / kLanesY;
  static constexpr int kStamps = kStampsX * kStampsY;
  static constexpr int kTriangles = config().triangles;

  static constexpr int kColourBits = 8;
  static constexpr int kDepthBits = config().depth_bits;
  static constexpr int kSubpixelBits = config().subpixel_bits;
  static constexpr int kReciprocalFraction = config().reciprocal_bits;
  static constexpr int kDepthFraction = config().depth_fraction;
  static constexpr int kColourFraction = config().colour_fraction;

  // --- widths, each with its reason ---
  // Frame sizes 1 … width; pixel coordinates fit as well. The same width whatever the stamp.
  static constexpr int kXBits = bits_for(kWidth), kYBits = bits_for(kHeight);
  // 0 is the background, so N triangles need N + 1 values.
  static constexpr int kIndexBits = bits_for(kTriangles);
  // Signed position, range_bits before the point (the sign among them).
  static constexpr int kCoordBits = config().range_bits + kSubpixelBits;
  // |x1 − x0| < 2^c: one bit more than a position.
  static constexpr int kDeltaBits = kCoordBits + 1;
  // Twice the area of a triangle within a square of side s is at most s²: |D| < 2^(2c).
  static constexpr int kAreaBits = 2 * kCoordBits;
  // An edge function is twice the area of (vertex, vertex, pixel centre), less the tie bias of one: [−2^(2c), 2^(2c)).
  static constexpr int kEdgeBits = 2 * kCoordBits + 1;
  // Steps are multiples of 2^f in the unit of the last place, so the low f bits never change, and the sign of a
  // number is the sign of its floor: they are dropped once the bias is folded in.
  static constexpr int kEdgeStepBits = kEdgeBits - kSubpixelBits;
  // N = dv1·dy2 − dv2·dy1, |dv| < 2^b, |dy| < 2^c: |N| < 2^(b+c+1).
  static constexpr int numerator_bits(int value_bits) { return value_bits + kCoordBits + 2; }
  // R = round(2^(r+s) / D) with 2^s <= D < 2^(s+1): 2^(r−1) < R <= 2^r.
  static constexpr int kReciprocalBits = kReciprocalFraction + 1;
  // s = floor(log2 D), 0 … 2c − 1.
  static constexpr int kShiftBits = bits_for(kAreaBits - 1);
  // Cycles a triangle of the RTL's triangle setup: the quotient bits of the divider and one to load it.
  static constexpr int kSetupInterval = kReciprocalFraction + 3;
  // A plane is kept modulo 2^b: at a covered pixel centre its value, less the error, lies between values of the
  // vertices, and the error is below ½ (see plane_error_ok), so the rounded value is one of 0 … 2^b − 1.
  static constexpr int kDepthPlaneBits = kDepthBits + kDepthFraction;
  static constexpr int kColourPlaneBits = kColourBits + kColourFraction;

  // --- what the widths have to satisfy ---
  // |error| <= 2^(b−r) + (|dx| + |dy|)·2^−(g+1) < ½ LSB, for the farthest vertex that a pixel of the frame can be
  // measured from; both sides times 2^(g+1+r).
  static constexpr std::int64_t kReach = (std::int64_t(1) << config().range_bits) + kWidth + kHeight;
  static constexpr bool plane_error_ok(int b, int r, int g) {
    return (std::int64_t(1) << (b + g + 1)) + (kReach << r) < std::int64_t(1) << (g + r);
  }
  static_assert(plane_error_ok(kDepthBits, kReciprocalFraction, kDepthFraction),
                "the depth planes are off by half an LSB or more: raise reciprocal_bits or depth_fraction");
  static_assert(plane_error_ok(kColourBits, kReciprocalFraction, kColourFraction),
                "the colour planes are off by half an LSB or more: raise reciprocal_bits or colour_fraction");
  static_assert(kWidth + 3 * kLanesX <= 1 << (config().range_bits - 1) &&
                    kHeight + 3 * kLanesY <= 1 << (config().range_bits - 1),
                "the pixel centres of every stamp, and of the stamps around the frame, are positions: raise range_bits");
  static_assert(kReciprocalFraction >= kSubpixelBits + kDepthFraction &&
                    kReciprocalFraction >= kSubpixelBits + kColourFraction,
                "a gradient keeps no more fraction bits than its reciprocal has: raise reciprocal_bits");
  static_assert(kEdgeBits <= 64, "an edge function is one machine word: lower range_bits or subpixel_bits");
  static_assert(kDepthPlaneBits + kSubpixelBits < 64 && kColourPlaneBits + kSubpixelBits < 64,
                "the start of a plane is one machine word: lower the fraction bits");
  static_assert(kColourPlaneBits + kXBits <= 64 && kColourPlaneBits + kYBits <= 64,
                "a colour gradient times a pixel coordinate is one machine word: lower colour_fraction");
  static_assert(numerator_bits(kDepthBits) - 24 + kReciprocalBits < 64 && 24 + kReciprocalBits < 64,
                "the halves of a gradient product are machine words: lower reciprocal_bits");

  // --- the types ---
  static constexpr int kCoordInteger = config().range_bits;
  using X = ufix<kXBits, kXBits>;  // pixels or stamps to the right, and frame widths
  using Y = ufix<kYBits, kYBits>;  // pixels or stamps downward, and frame heights
  using Index = ufix<kIndexBits, kIndexBits>;
  using Coord = fix<kCoordBits, kCoordInteger>;
  using Delta = fix<kDeltaBits, kCoordInteger + 1>;
  using Area = ufix<kAreaBits, 2 * kCoordInteger>;
  using SignedArea = fix<kAreaBits + 1, 2 * kCoordInteger + 1>;
  using Edge = fix<kEdgeBits, 2 * kCoordInteger + 1>;
  using EdgeStep = fix<kEdgeStepBits, 2 * kCoordInteger + 1>;
  using Reciprocal = ufix<kReciprocalBits, 1>;
  using Shift = ufix<kShiftBits, kShiftBits>;
  using Depth = ufix<kDepthBits, kDepthBits>;
  using Colour = ufix<kColourBits, kColourBits>;
  using DepthPlane = ufix<kDepthPlaneBits, kDepthBits>;
  using DepthGradient = fix<kDepthPlaneBits, kDepthBits>;
  using ColourPlane = ufix<kColourPlaneBits, kColourBits>;
  using ColourGradient = fix<kColourPlaneBits, kColourBits>;
};

}  // namespace halfspace

#endif  // HALFSPACE_HLS_FORMATS_HPP_
