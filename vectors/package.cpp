// SPDX-License-Identifier: Apache-2.0
#include "vectors/package.hpp"

#include <fmt/format.h>

#include "hls/reciprocal_lookup.hpp"
#include "hls/reciprocal_sqrt.hpp"
#include "vectors/engine.hpp"
#include "vectors/lighting.hpp"
#include "vectors/texture.hpp"

namespace halfspace::vectors {
namespace {

std::string range(int width, bool is_signed) {
  const std::string sign = is_signed ? "signed " : "";
  return width == 1 ? "logic " + sign : fmt::format("logic {}[{}:0] ", sign, width - 1);
}

// The fields of a record that come once: the whole of it, or the head of a record with lanes.
std::string record(const Layout& layout) {
  const bool has_lanes = layout.head_bits != layout.bits;
  std::string text = has_lanes ? fmt::format("  // {0}: {{{0}_head_t", layout.stream) : "";
  if (has_lanes) {
    for (const Field& field : layout.fields) {
      if (field.lsb + field.width * field.count <= layout.bits - layout.head_bits) {
        text += field.width == 1 ? fmt::format(", {}[Lanes]", field.name)
                                 : fmt::format(", {}[Lanes][{}:0]", field.name, field.width - 1);
      }
    }
    text += "}\n";
  }
  text += "  typedef struct packed {\n";
  for (const Field& field : layout.fields) {
    if (field.lsb < layout.bits - layout.head_bits) continue;
    text += fmt::format("    {}{};\n", range(field.width, field.is_signed), field.name);
  }
  return text + fmt::format("  }} {}{}_t;\n\n", layout.stream, has_lanes ? "_head" : "");
}

std::string constants_text(const std::vector<std::pair<const char*, int>>& constants) {
  std::string text;
  for (const auto& [name, value] : constants) text += fmt::format("  localparam int unsigned {} = {};\n", name, value);
  return text;
}

// Entry 0 last: a table is {v, s} a segment, segment 0 in the least significant place.
template <class Table>
std::string table_text(const char* name, const Table& table, int segments, int value_bits, int slope_bits) {
  const int bits = value_bits + slope_bits, digits = (bits + 3) / 4;
  std::string text = fmt::format("  localparam logic [{}:0] {} = {{\n", segments * bits - 1, name);
  for (int i = segments - 1; i >= 0; --i) {
    text += fmt::format("{}{}'h{:0{}x}{}", (segments - 1 - i) % 6 == 0 ? "    " : " ", bits,
                        std::uint64_t(table.value[i]) << slope_bits | table.slope[i], digits, i == 0 ? "\n  };\n" : ",");
    if ((segments - i) % 6 == 0 && i != 0) text += "\n";
  }
  return text;
}

// What lighting adds: numbers, the table of the reciprocal root, types and records. Nothing without it.
std::string lighting_text(const Config& c) {
  if (!has_lighting(c)) return "";
  const FormatTable t = format_table(c);
  const std::vector<Layout> layouts = make_lighting_engine(c)->layouts();
  std::string text = constants_text({{"NormalBits", t.normal.width},
                                     {"Lights", c.lights},
                                     {"LightBits", t.light.width},
                                     {"Materials", c.materials},
                                     {"MaterialBits", t.material.width},
                                     {"HasGloss", has_gloss(c)},
                                     {"Squarings", exact_log2(c.gloss)},
                                     {"GlossBits", has_gloss(c) ? t.gloss.width : 0},
                                     {"DirectionBits", t.direction.width},
                                     {"SquaredLengthBits", t.squared_length.width},
                                     {"RootIndexBits", kRootIndexBits},
                                     {"RootOffsetBits", kRootOffsetBits},
                                     {"RootValueFraction", kRootValueFraction},
                                     {"RootSlopeBits", kRootSlopeBits},
                                     {"RootBits", t.root.width},
                                     {"RootShiftBits", t.root_shift.width},
                                     {"DotBits", t.dot.width},
                                     {"CosineBits", t.cosine.width},
                                     {"CoefficientBits", t.coefficient.width},
                                     {"LightWordBits", layouts[0].bits},
                                     {"MaterialWordBits", layouts[1].bits},
                                     {"LightSumBits", t.light_sum.width},
                                     {"LightSumFraction", t.light_sum.width - t.light_sum.integer}});
  if (is_phong(c)) text += constants_text({{"NormalFraction", c.normal_fraction}, {"NormalPlaneBits", t.normal_plane.width}});
  text += "\n" + table_text("RootTable", root_table(), kRootSegments, kRootValueFraction, kRootSlopeBits) + "\n";
  for (const Layout& layout : layouts) text += record(layout);
  return text;
}

// What texture adds: numbers, the table of the reciprocal of a pixel, records. Nothing without it.
std::string texture_text(const Config& c) {
  if (!has_texture(c)) return "";
  const FormatTable t = format_table(c);
  const std::vector<Layout> layouts = texture_layouts(c);
  std::string text = constants_text({{"Bilinear", is_bilinear(c)},
                                     {"Perspective", has_perspective(c)},
                                     {"Texels", c.texels},
                                     {"Textures", c.textures},
                                     {"TextureBits", t.texture.width},
                                     {"RepeatBits", t.repeats.width},
                                     {"SideBits", t.side.width},
                                     {"TexelAddressBits", t.texel_address.width},
                                     {"CoordinateBits", t.coordinate.width},
                                     {"CoordinateFraction", c.coordinate_fraction},
                                     {"CoordinatePlaneBits", t.coordinate_plane.width},
                                     {"WeightBits", kWeightBits},
                                     {"TexelPlaceBits", t.texel_place.width},
                                     {"FilteredFraction", kFilteredFraction},
                                     {"FilteredBits", t.filtered.width},
                                     {"TextureWordBits", layouts[0].bits},
                                     {"TexelWordBits", layouts[1].bits},
                                     {"InverseBits", has_perspective(c) ? t.inverse.width : 0},
                                     {"InverseShiftBits", has_perspective(c) ? t.inverse_shift.width : 0},
                                     {"InverseIndexBits", kInverseIndexBits},
                                     {"InverseOffsetBits", kInverseOffsetBits},
                                     {"InverseValueFraction", kInverseValueFraction},
                                     {"InverseSlopeBits", kInverseSlopeBits}});
  if (has_perspective(c)) {
    text += "\n" + table_text("InverseTable", inverse_table(), kInverseSegments, kInverseValueFraction, kInverseSlopeBits);
  }
  text += "\n";
  for (const Layout& layout : layouts) text += record(layout);
  return text;
}

}  // namespace

std::string formats_package(const Configuration& configuration) {
  const Config c = configuration.config();
  const FormatTable t = format_table(c);
  // What is not there has no bits and no type.
  const bool depth = has_depth(c), gouraud = is_gouraud(c), planes = has_planes(c);
  const auto bits = [](bool there, const NumberFormat& format) { return there ? format.width : 0; };
  // Colours of a triangle, and before them, or with Phong shading in their place, {which vertex is first: 2 bits, turned}.
  const int vertex_order = orders_vertices(c) ? 3 : 0, colours = is_phong(c) ? 0 : (gouraud ? 9 : 3) * t.colour.width;
  const std::vector<std::pair<const char*, int>> constants = {
      {"HasDepth", depth},
      {"StoresDepth", stores_depth(c)},
      {"Gouraud", gouraud},
      {"Phong", is_phong(c)},
      {"HasTexture", has_texture(c)},
      {"MaxWidth", c.width},
      {"MaxHeight", c.height},
      {"Triangles", c.triangles},
      {"XBits", t.x.width},
      {"YBits", t.y.width},
      {"IndexBits", t.index.width},
      {"SubpixelBits", c.subpixel_bits},
      {"CoordBits", t.coord.width},
      {"DeltaBits", t.delta.width},
      {"AreaBits", t.area.width},
      {"EdgeBits", t.edge.width},
      {"EdgeStepBits", t.edge_step.width},
      {"ReciprocalFraction", c.reciprocal_bits},
      {"ReciprocalBits", bits(planes, t.reciprocal)},
      {"ShiftBits", bits(planes, t.shift)},
      {"SetupInterval", setup_interval(c)},
      {"DepthBits", c.depth_bits},
      {"DepthFraction", c.depth_fraction},
      {"DepthPlaneBits", bits(depth, t.depth_plane)},
      {"ColourBits", t.colour.width},
      {"TriangleColourBits", vertex_order + colours},
      {"ColourFraction", c.colour_fraction},
      {"ColourPlaneBits", t.colour_plane.width}};  // flat: the colour's
  struct Type {
    const char* name;
    NumberFormat format;
    bool is_there;
  };
  const Type types[] = {{"x", t.x, true},
                        {"y", t.y, true},
                        {"index", t.index, true},
                        {"coord", t.coord, true},
                        {"delta", t.delta, true},
                        {"area", t.area, true},
                        {"edge_step", t.edge_step, true},
                        {"reciprocal", t.reciprocal, planes},
                        {"shift", t.shift, planes},
                        {"depth", t.depth, depth},
                        {"depth_plane", t.depth_plane, depth},
                        {"depth_gradient", t.depth_gradient, depth},
                        {"colour", t.colour, true},
                        {"colour_plane", t.colour_plane, gouraud},
                        {"colour_gradient", t.colour_gradient, gouraud}};

  std::string text = fmt::format(
      "// SPDX-License-Identifier: Apache-2.0\n"
      "// Number formats of configuration `{0}`. Printed by `halfspace package --config {0}` from hls/formats.hpp\n"
      "// and hls/records.hpp: change those, not this file.\n"
      "package hs_formats_pkg;\n\n",
      configuration.name());
  text += constants_text(constants) + "\n";
  for (const Type& type : types) {
    if (type.is_there) text += fmt::format("  typedef {}{}_t;\n", range(type.format.width, type.format.is_signed), type.name);
  }
  text += "\n";
  // Any number of lanes would do: nothing printed depends on it.
  for (const Layout& layout : make_engine(configuration, 2)->layouts()) text += record(layout);
  return text + lighting_text(c) + texture_text(c) + "endpackage\n";
}

}  // namespace halfspace::vectors
