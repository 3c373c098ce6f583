// SPDX-License-Identifier: Apache-2.0
#include "model/formats/format_fields.hpp"

#include <fmt/format.h>

namespace halfspace::model {

namespace {
constexpr bool always(const Config&) { return true; }
}  // namespace

const std::vector<FormatField>& format_fields() {
  using T = FormatTable;
  static const std::vector<FormatField> fields = {
      {"x", &T::x, "frame widths and columns, 0 … width", always},
      {"y", &T::y, "frame heights and rows, 0 … height", always},
      {"index", &T::index, "0 is the background, 1 … triangles", always},
      {"coord", &T::coord, "c = range_bits + f", always},
      {"delta", &T::delta, "c + 1: a difference of positions", always},
      {"area", &T::area, "2c: twice the area of a triangle in a square is its area at most", always},
      {"signed_area", &T::signed_area, "2c + 1: before the winding is known", always},
      {"edge", &T::edge, "2c + 1: twice the area of (vertex, vertex, pixel centre), less one", always},
      {"edge_step", &T::edge_step, "2c + 1 − f: the low f bits never change", always},
      {"reciprocal", &T::reciprocal, "r + 1: 2^(r−1) <= R <= 2^r", has_planes},
      {"shift", &T::shift, "floor(log2 D), 0 … 2c − 1", has_planes},
      {"depth", &T::depth, "b of depth", has_depth},
      {"depth_plane", &T::depth_plane, "b + g: modulo 2^b, as the error is below ½", has_depth},
      {"depth_gradient", &T::depth_gradient, "b + g: steps of whole pixels, modulo 2^b", has_depth},
      {"depth_numerator", &T::depth_numerator, "b + c + 1: |dv1·dy2 − dv2·dy1| < 2^(b+c)", has_depth},
      {"depth_start", &T::depth_start, "b + g + f: products of g and f fraction bits, modulo 2^b", has_depth},
      {"depth_start_gradient", &T::depth_start_gradient, "b + f + g: times a multiple of 2^−f, modulo 2^b", has_depth},
      {"colour", &T::colour, "b of a channel", always},
      {"colour_plane", &T::colour_plane, "b + g", is_gouraud},
      {"colour_gradient", &T::colour_gradient, "b + g", is_gouraud},
      {"colour_numerator", &T::colour_numerator, "b + c + 1", is_gouraud},
      {"colour_start", &T::colour_start, "b + g + f", is_gouraud},
      {"colour_start_gradient", &T::colour_start_gradient, "b + f + g", is_gouraud}};
  return fields;
}

const std::vector<FormatField>& lighting_format_fields() {
  using T = FormatTable;
  static const std::vector<FormatField> fields = {
      {"material", &T::material, "0 … materials − 1", has_lighting},
      {"light", &T::light, "0 … lights − 1", has_lighting},
      {"gloss", &T::gloss, "k, squarings: 0 … log2(gloss)", has_gloss},
      {"normal", &T::normal, "p + 1: of any length, so that no component is 1", has_lighting},
      {"direction", &T::direction, "u + 2, u = b + 8: of a unit vector", has_lighting},
      {"squared_length", &T::squared_length, "2p + 2: at most 3·2^2p units", has_lighting},
      {"root", &T::root, "y of reciprocal_sqrt, ½ … 1", has_lighting},
      {"root_shift", &T::root_shift, "k of reciprocal_sqrt, 0 … p", has_lighting},
      {"dot", &T::dot, "p + u + 4: at most 3·2^(p+u+1) units", has_lighting},
      {"projection", &T::projection, "u + 1: n·L of 1 <= |n| < 2, above 0", has_lighting},
      {"cosine", &T::cosine, "u + 1: 0 … 1; an exponent of 16 leaves 2^−4 LSB of its last place", has_lighting},
      {"coefficient", &T::coefficient, "b + 2 + 6: four times full scale, 1/128 LSB of rounding", has_lighting},
      {"light_sum", &T::light_sum, "base, diffuse, specular of each light, times 1 at most", has_lighting},
      {"normal_offset", &T::normal_offset, "b = p + 1: a component plus 2^p units has no sign", is_phong},
      {"normal_plane", &T::normal_plane, "b + g: modulo 2^b, as the error is below ½", is_phong},
      {"normal_gradient", &T::normal_gradient, "b + g", is_phong},
      {"normal_numerator", &T::normal_numerator, "b + c + 1", is_phong},
      {"normal_start", &T::normal_start, "b + g + f", is_phong},
      {"normal_start_gradient", &T::normal_start_gradient, "b + f + g", is_phong}};
  return fields;
}

const std::vector<FormatField>& texture_format_fields() {
  using T = FormatTable;
  static const std::vector<FormatField> fields = {
      {"texture", &T::texture, "0: none, 1 … textures", has_texture},
      {"repeats", &T::repeats, "e: a triangle spans 2^15 repetitions at most", has_texture},
      {"side", &T::side, "log2 of a side, 0 … log2(texels), bilinear one less", has_texture},
      {"texel_address", &T::texel_address, "0 … texels − 1", has_texture},
      {"coordinate", &T::coordinate, "b of s, t, q", has_coordinates},
      {"coordinate_plane", &T::coordinate_plane, "b + g: modulo 2^b, as the error is below ½", has_coordinates},
      {"coordinate_gradient", &T::coordinate_gradient, "b + g", has_coordinates},
      {"coordinate_numerator", &T::coordinate_numerator, "b + c + 1", has_coordinates},
      {"coordinate_start", &T::coordinate_start, "b + g + f", has_coordinates},
      {"coordinate_start_gradient", &T::coordinate_start_gradient, "b + f + g", has_coordinates},
      {"inverse", &T::inverse, "y of reciprocal_lookup, ½ … 1", has_perspective},
      {"inverse_shift", &T::inverse_shift, "k of reciprocal_lookup, 0 … b − 1", has_perspective},
      {"texel_place", &T::texel_place, "of the longest side + 8: modulo a side, and the weights of a bilinear filter",
       has_texture},
      {"filtered", &T::filtered, "b of colour + 8: a texel, rounded once", has_texture}};
  return fields;
}

const std::vector<FormatField>& motion_format_fields() {
  using T = FormatTable;
  static const std::vector<FormatField> fields = {
      {"face", &T::face, "0: background, 1 … 2^face_bits − 1", has_motion},
      {"origin", &T::origin, "whole pixels of a position", has_motion},
      {"extent", &T::extent, "e: places of a triangle lie within 2^e pixels of its origin", has_motion},
      {"vector", &T::vector, "vector_range + 1 + vector_fraction", has_motion},
      {"key_weight", &T::key_weight, "0 … 1", has_motion},
      {"tile_x", &T::tile_x, "a column of tiles of a key frame", has_motion},
      {"tile_y", &T::tile_y, "a row of tiles of a key frame", has_motion},
      {"key_place", &T::key_place, "side + 2^vector_range, in pixels of a key frame", has_motion},
      {"tap_weight", &T::tap_weight, "−½ … 1: of a column or a row", has_motion},
      {"key_sum", &T::key_sum, "weights·colours of a key, and a difference: exact", has_motion},
      {"key_blend", &T::key_blend, "of both keys: exact", has_motion},
      {"difference", &T::difference, "b of colour + 1: a difference plus 2^b has no sign", relights},
      {"difference_plane", &T::difference_plane, "b + g: modulo 2^b, as the error is below ½", relights},
      {"difference_gradient", &T::difference_gradient, "b + g", relights},
      {"difference_numerator", &T::difference_numerator, "b + c + 1", relights},
      {"difference_start", &T::difference_start, "b + g + f", relights},
      {"difference_start_gradient", &T::difference_start_gradient, "b + f + g", relights}};
  return fields;
}

const std::vector<FormatField>& object_format_fields() {
  using T = FormatTable;
  static const std::vector<FormatField> fields = {
      {"object", &T::object, "0: background, 1 … 2^object_bits − 1", has_objects},
      {"object_count", &T::object_count, "pixels of a frame", has_objects}};
  return fields;
}

std::string format_name(const NumberFormat& format) {
  return fmt::format("{}{}.{}", format.is_signed ? 's' : 'u', format.integer, format.width - format.integer);
}

}  // namespace halfspace::model
