// SPDX-License-Identifier: Apache-2.0
// The rows of a configuration, with what is proved.
#include <fmt/format.h>

#include <cmath>

#include "study/bounds/bounds.hpp"
#include "study/bounds/bounds_measure.hpp"
#include "study/proofs/bounds_proved.hpp"
#include "study/proofs/lighting_bounds.hpp"
#include "study/proofs/motion_bounds.hpp"
#include "study/proofs/phong_bounds.hpp"
#include "study/proofs/shown_bounds.hpp"
#include "study/proofs/texture_bounds.hpp"

namespace halfspace::model {
namespace {

std::string place(int fraction) { return fmt::format("2^-{}", fraction); }

class Rows {
 public:
  explicit Rows(const Config& config) : c_(config) { report_.rows.resize(kQuantities); }

  BoundsReport report() {
    setup();
    shading();
    if (has_lighting(c_)) lighting();
    if (has_texture(c_)) texture();
    if (has_motion(c_)) motion();
    if (has_objects(c_)) {
      exact(kEntry, "scan_object", "depth and object");
      exact(kMerge, "ztest_merge", "nearer entry");
      exact(kMergeFound, "ztest_merge", "pixels of an object");
    }
    const char* const from = has_motion(c_) ? "colour, from vertices and keys" : "colour, from vertices";
    bound(kShown, "picture", from, "LSB", "shown", value(shown_bound(c_)));
    return report_;
  }

 private:
  // A bound of 0 is none: what is rounded nowhere is exact.
  void bound(Quantity q, const char* kernel, const std::string& quantity, const std::string& unit,
             const std::string& proof, double proved) {
    report_.rows[q] =
        proved == 0 ? BoundRow{kernel, quantity, "", "", 0} : BoundRow{kernel, quantity, unit, proof, proved};
  }
  void exact(Quantity q, const char* kernel, const std::string& quantity) {
    report_.rows[q] = {kernel, quantity, "", "", 0};
  }

  // The five rows of a channel with planes; a value is of 2^−`fraction` LSB, or units.
  struct Names {
    const char *setup, *shader, *kind, *unit;
    int fraction;  // of the unit
  };
  void planes(const PlaneChannel& channel, const Names& n) {
    const PlaneBound far = plane_bound(channel.numbers, largest_reach(c_, Vertices::kGuardBand));
    const PlaneBound near = plane_bound(channel.numbers, largest_reach(c_, Vertices::kFrame));
    const std::string kind = n.kind, shader = n.shader, name = plane_name(channel.kind);
    const bool is_long = channel.kind == kNormals || channel.kind == kCoordinates || channel.kind == kDifferences;
    const std::string setup = n.setup + std::string(channel.kind == kDifferences ? "_difference" : "");
    const std::string script = channel.kind == kDifferences ? shader + "_difference" : shader;
    bound(channel.gradient, n.setup, (is_long ? "gradient of a " : "gradient of ") + kind,
          place(n.fraction + channel.numbers.fraction), setup + "_product", 0.5);
    bound(channel.plane, n.setup, is_long ? "plane of a " + kind : kind + " plane", n.unit, shader + "_" + name,
          value(far.in_register));
    bound(channel.plane_in_frame, n.setup, "… in the frame", n.unit, shader + "_" + name + "_frame",
          value(near.in_register));
    exact(channel.steps, n.shader, kind + ", from its plane");
    bound(channel.rounded, n.shader, kind + ", rounded", n.unit, script + "_rounded", value(far.rounded));
  }

  void setup() {
    bound(kSnap, "snap", "position", place(c_.subpixel_bits) + " px", "snap", 0.5);
    exact(kEdges, "triangle_setup", "edge functions");
    if (has_planes(c_)) {
      bound(kReciprocal, "triangle_setup", "reciprocal, relative", place(c_.reciprocal_bits),
            "triangle_setup_reciprocal", 1);
    }
    exact(kCoverage, "raster_pineda", "coverage");
    exact(kZtest, tests_planes(c_) ? "ztest_plane" : "ztest_index",
          stores_depth(c_) ? "index and depth kept" : "index kept");
    exact(kScan, "scan_index", "index");
  }

  void shading() {
    const std::string normal = place(c_.normal_bits), difference = place(kDifferenceFraction) + " LSB";
    const bool motion = has_motion(c_);
    const Names names[kPlaneKinds] = {
        {"triangle_setup", "raster_pineda", "depth", "LSB", 0},
        {"shade_setup", "shade_gouraud", "colour", "LSB", 0},
        {"phong_setup", "shade_phong", "normal", normal.c_str(), c_.normal_bits},
        {motion ? "motion_setup" : "texture_setup", motion ? "motion_field" : "shade_texture",
         motion ? "place" : "coordinate", "LSB", 0},
        {"motion_setup", "motion_field", "difference", difference.c_str(), kDifferenceFraction}};
    for (const PlaneChannel& channel : plane_channels(c_)) planes(channel, names[channel.kind]);
    if (c_.shading == Shading::kFlat) exact(kColourSteps, "shade_gouraud", "colour, from the triangle");
  }

  void lighting() {
    const char* const unit = is_phong(c_) ? "shade_phong" : "light_vertex";
    const int u = cosine_fraction(c_), squarings = exact_log2(c_.gloss);
    bound(kLightCosine, unit, "cosine", place(u), "light_cosine", std::ldexp(value(cosine_bound(c_)), u));
    if (squarings > 0) {
      bound(kLightPower, unit, "largest power of a cosine", place(u), "light_power",
            std::ldexp(value(power_bound(c_, squarings)), u));
    }
    bound(kLightSum, unit, "colour of a white light", "LSB", "light_sum", value(light_bound(c_)));
    bound(kLightColour, unit, "… rounded", "LSB", "light_rounded", 0.5 + value(light_bound(c_)));
    if (is_phong(c_))
      bound(kPhongColour, unit, "colour, from the normals", "LSB", "shade_phong_colour",
            value(white_phong(c_).rounded));
  }

  void inverse(const char* unit) {
    if (has_perspective(c_)) bound(kInverse, unit, "reciprocal of q, relative", "2^-18", kEveryField, 1);
  }

  void texture() {
    inverse("shade_texture");
    const int texels = exact_log2(c_.texels), longer = square_side(c_);
    bound(kTexelPlace, "shade_texture", fmt::format("place, {}x{} texels", 1 << longer, 1 << (texels - longer)),
          "texels", "shade_texture_place", square_place_bound(c_));
    if (is_bilinear(c_)) {
      bound(kTexelFiltered, "shade_texture", "filtered texel", "LSB", "shade_texture_filter", filtered_bound(c_));
    }
    bound(kTexelColour, "shade_texture", "colour, from its texels", "LSB",
          is_bilinear(c_) ? "shade_texture_product" : kEveryField, textured_bound(c_, 0, filtered_bound(c_)));
  }

  void motion() {
    inverse("motion_field");
    bound(kVector, "motion_field", fmt::format("vector, within {} px", 1 << vector_extent(c_)), "px",
          "motion_field_vector", vector_bound(c_));
    exact(kVectorFits, "motion_field", "vectors that fit");
    const char* const unit = "motion_compensate";
    exact(kKeysShown, unit, "keys that show the point");
    if (c_.filter != KeyFilter::kNearest) {
      bound(kKeyWeight, unit, "weight of a pixel", place(c_.weight_bits), "motion_compensate_weight", tap_bound(c_));
      bound(kKeyColour, unit, "colour of a key", "LSB", "motion_compensate_key", key_colour_bound(c_));
    }
    bound(kCompensated, unit, "colour, rounded", "LSB", "motion_compensate_colour", 0.5 + key_colour_bound(c_));
  }

  const Config c_;
  BoundsReport report_;
};

}  // namespace

BoundsReport proved_bounds(const Config& config) { return Rows(config).report(); }

}  // namespace halfspace::model
