// SPDX-License-Identifier: Apache-2.0
#include "model/pipeline/package.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hls/formats/records.hpp"
#include "hls/formats/setup_interval.hpp"
#include "hls/motion/key_filter.hpp"
#include "hls/shade/reciprocal_sqrt.hpp"
#include "hls/texture/reciprocal_lookup.hpp"
#include "model/motion/compensation.hpp"
#include "model/objects/merge.hpp"
#include "model/pipeline/engine.hpp"

namespace halfspace::model {
namespace {

std::string range(int width, bool is_signed) {
  const std::string sign = is_signed ? "signed " : "";
  return width == 1 ? "logic " + sign : fmt::format("logic {}[{}:0] ", sign, width - 1);
}

// Nothing printed depends on it.
constexpr int kAnyLanes = 2;

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
    text +=
        fmt::format("{}{}'h{:0{}x}{}", (segments - 1 - i) % 6 == 0 ? "    " : " ", bits,
                    std::uint64_t(table.value[i]) << slope_bits | table.slope[i], digits, i == 0 ? "\n  };\n" : ",");
    if ((segments - i) % 6 == 0 && i != 0) text += "\n";
  }
  return text;
}

// The bits of a stream; 1 of one that there is not, as a port has that many at least.
int word_bits(const std::vector<Layout>& layouts, const char* stream) {
  const auto found = std::find_if(layouts.begin(), layouts.end(), [&](const Layout& l) { return l.stream == stream; });
  return found == layouts.end() ? 1 : found->bits;
}

// The numbers of lighting; without it 0, but for ports.
std::string lighting_text(const Config& c, const std::vector<Layout>& layouts) {
  const FormatTable t = format_table(c);
  const bool there = has_lighting(c);
  const auto number = [&](int value) { return there ? value : 0; };
  return constants_text({{"Deferred", is_deferred(c)},
                         {"Lights", c.lights},
                         {"LightWordBits", word_bits(layouts, "light")},
                         {"MaterialWordBits", word_bits(layouts, "material")},
                         {"NormalsWordBits", word_bits(layouts, "normals")},
                         {"ColoursWordBits", word_bits(layouts, "colours")},
                         {"NormalBits", number(t.normal.width)},
                         {"LightBits", number(t.light.width)},
                         {"Materials", c.materials},
                         {"MaterialBits", number(t.material.width)},
                         {"HasGloss", has_gloss(c)},
                         {"Squarings", exact_log2(c.gloss)},
                         {"GlossBits", has_gloss(c) ? t.gloss.width : 0},
                         {"DirectionBits", number(t.direction.width)},
                         {"SquaredLengthBits", number(t.squared_length.width)},
                         {"RootIndexBits", number(kRootIndexBits)},
                         {"RootOffsetBits", number(kRootOffsetBits)},
                         {"RootValueFraction", number(kRootValueFraction)},
                         {"RootSlopeBits", number(kRootSlopeBits)},
                         {"RootBits", number(t.root.width)},
                         {"RootShiftBits", number(t.root_shift.width)},
                         {"DotBits", number(t.dot.width)},
                         {"CosineBits", number(t.cosine.width)},
                         {"CoefficientBits", number(t.coefficient.width)},
                         {"LightSumBits", number(t.light_sum.width)},
                         {"LightSumFraction", number(t.light_sum.width - t.light_sum.integer)},
                         {"NormalFraction", c.normal_fraction},
                         {"NormalPlaneBits", is_phong(c) ? t.normal_plane.width : 0}}) +
         (there ? "\n" + table_text("RootTable", root_table(), kRootSegments, kRootValueFraction, kRootSlopeBits)
                : "  localparam logic [0:0] RootTable = '0;\n");
}

// Those of texture.
std::string texture_text(const Config& c, const std::vector<Layout>& layouts) {
  const FormatTable t = format_table(c);
  const auto number = [&](int value) { return has_texture(c) ? value : 0; };
  const auto coordinate = [&](int value) { return has_coordinates(c) ? value : 0; };
  const auto inverse = [&](int value) { return has_perspective(c) ? value : 0; };
  return constants_text({{"Bilinear", is_bilinear(c)},
                         {"Perspective", has_perspective(c)},
                         {"Texels", c.texels},
                         {"Textures", c.textures},
                         {"TextureBits", number(t.texture.width)},
                         {"RepeatBits", number(t.repeats.width)},
                         {"SideBits", number(t.side.width)},
                         {"TexelAddressBits", number(t.texel_address.width)},
                         {"CoordinateBits", coordinate(t.coordinate.width)},
                         {"CoordinateFraction", c.coordinate_fraction},
                         {"CoordinatePlaneBits", coordinate(t.coordinate_plane.width)},
                         {"WeightBits", number(kWeightBits)},
                         {"TexelPlaceBits", number(t.texel_place.width)},
                         {"FilteredFraction", is_bilinear(c) ? kFilteredFraction : 0},
                         {"FilteredBits", number(t.filtered.width)},
                         {"TextureWordBits", word_bits(layouts, "texture")},
                         {"TexelWordBits", word_bits(layouts, "texel")},
                         {"TextureCoordinatesWordBits", word_bits(layouts, "texture_coordinates")},
                         {"TexturePlanesWordBits", word_bits(layouts, "texture_planes")},
                         {"InverseBits", inverse(t.inverse.width)},
                         {"InverseShiftBits", inverse(t.inverse_shift.width)},
                         {"InverseIndexBits", inverse(kInverseIndexBits)},
                         {"InverseOffsetBits", inverse(kInverseOffsetBits)},
                         {"InverseValueFraction", inverse(kInverseValueFraction)},
                         {"InverseSlopeBits", inverse(kInverseSlopeBits)}}) +
         (has_perspective(c) ? "\n" + table_text("InverseTable", inverse_table(), kInverseSegments,
                                                 kInverseValueFraction, kInverseSlopeBits)
                             : "  localparam logic [0:0] InverseTable = '0;\n");
}

// Entry 0 in the least significant place.
std::string entries_text(const char* name, const std::vector<std::uint64_t>& entries, int bits) {
  const int digits = (bits + 3) / 4;
  std::string text = fmt::format("  localparam logic [{}:0] {} = {{\n   ", int(entries.size()) * bits - 1, name);
  for (std::size_t i = entries.size(); i-- > 0;) {
    text += fmt::format(" {}'h{:0{}x}{}", bits, entries[i], digits, i == 0 ? "\n  };\n" : i % 6 == 0 ? ",\n   " : ",");
  }
  return text;
}

// The weights of an axis (hls/motion/key_filter.hpp): of the pixel behind a place; bicubic, of those one further,
// behind and before it.
std::string key_tables_text(const Config& c) {
  const bool is_bicubic = has_motion(c) && c.filter == KeyFilter::kBicubic,
             has_inner = has_motion(c) && c.filter != KeyFilter::kNearest;
  std::vector<std::uint64_t> inner, outer;
  const int g = c.vector_fraction + exact_log2(c.samples), w = c.weight_bits, bits = format_table(c).tap_weight.width;
  for (int n = 0; n < 1 << g; ++n) {
    inner.push_back(std::uint64_t(axis_weights(inner_filter(c.filter), n, g, w).tap[2]));
    const AxisWeights weights = axis_weights(c.filter, n, g, w);
    std::uint64_t entry = 0;
    for (const int tap : {3, 2, 0})
      entry = entry << bits | (std::uint64_t(weights.tap[tap]) & ((std::uint64_t(1) << bits) - 1));
    outer.push_back(entry);
  }
  const auto none = [](const char* name) { return fmt::format("  localparam logic [0:0] {} = '0;\n", name); };
  return (has_inner ? entries_text("KeyInnerTable", inner, w + 1) : none("KeyInnerTable")) +
         (is_bicubic ? entries_text("KeyOuterTable", outer, 3 * bits) : none("KeyOuterTable"));
}

// The fraction, counted from an end of the table, where tap 1 (before a place) or 2 (behind it) first has a weight.
int weighted(const Config& c, int tap, int step) {
  const int g = c.vector_fraction + exact_log2(c.samples);
  int n = 1;
  while (n < 1 << g &&
         axis_weights(inner_filter(c.filter), step > 0 ? n : (1 << g) - n, g, c.weight_bits).tap[tap] == 0)
    ++n;
  return n;
}

// Those of frames in between.
std::string motion_text(const Config& c, const std::vector<Layout>& layouts) {
  const FormatTable t = format_table(c);
  const auto number = [&](int value) { return has_motion(c) ? value : 0; };
  const int taps = c.filter == KeyFilter::kNearest ? 1 : c.filter == KeyFilter::kBicubic ? 4 : 2;
  return constants_text(
             {{"HasMotion", has_motion(c)},
              {"Relight", relights(c)},
              {"FaceBits", number(t.face.width)},
              {"OriginBits", number(t.origin.width)},
              {"ExtentBits", number(t.extent.width)},
              {"VectorBits", number(t.vector.width)},
              {"VectorFraction", c.vector_fraction},
              {"KeyWeightBits", number(t.key_weight.width)},
              {"DifferenceBits", relights(c) ? t.difference.width : 0},
              {"KeyTaps", number(taps)},
              {"KeySide", number(key_side(c.filter))},
              {"KeyFractionBits", number(c.vector_fraction + exact_log2(c.samples))},
              {"KeyFirstBehind", number(weighted(c, 2, 1))},
              {"KeyLastBefore", number((1 << (c.vector_fraction + exact_log2(c.samples))) - weighted(c, 1, -1))},
              {"KeyPlaceBits", number(t.key_place.width)},
              {"TapWeightBits", number(t.tap_weight.width)},
              {"KeySumBits", number(t.key_sum.width)},
              {"TileXBits", number(t.tile_x.width)},
              {"TileYBits", number(t.tile_y.width)},
              {"KeyRequestWordBits", word_bits(layouts, "key_request_0")},
              {"KeyBlockWordBits", word_bits(layouts, "key_block_0")},
              {"CompensatedWordBits", word_bits(layouts, "compensated")},
              {"DifferencePlaneBits", relights(c) ? t.difference_plane.width : 0},
              {"MotionVectorsWordBits", word_bits(layouts, "motion_vectors")},
              {"MotionPlanesWordBits", word_bits(layouts, "motion_planes")},
              {"MotionWordBits", word_bits(layouts, "motion")}}) +
         key_tables_text(c);
}

// Those of static objects buffers.
std::string object_text(const Config& c, const std::vector<Layout>& layouts) {
  const FormatTable t = format_table(c);
  const auto number = [&](int value) { return has_objects(c) ? value : 0; };
  return constants_text({{"HasObjects", has_objects(c)},
                         {"ObjectBits", number(t.object.width)},
                         {"ObjectCountBits", number(t.object_count.width)},
                         {"MergeWordBits", word_bits(layouts, "merge")},
                         {"FoundWordBits", word_bits(layouts, "found")}});
}

// Those of motion_compensate and ztest_merge besides, which are no part of an engine.
std::vector<Layout> all_layouts(const Configuration& configuration, std::vector<Layout> layouts) {
  if (has_motion(configuration.config())) {
    for (const Layout& layout : Compensator(configuration).layouts()) layouts.push_back(layout);
  }
  if (has_objects(configuration.config())) {
    for (const Layout& layout : Merger(configuration, kAnyLanes).layouts()) layouts.push_back(layout);
  }
  return layouts;
}

}  // namespace

std::string formats_package(const Configuration& configuration) {
  const Config c = configuration.config();
  const FormatTable t = format_table(c);
  // What is not there has no bits and no type.
  const bool depth = has_depth(c), gouraud = is_gouraud(c), planes = has_planes(c);
  const auto bits = [](bool there, const NumberFormat& format) { return there ? format.width : 0; };
  // Of a triangle as it comes: its colours; and of its attributes, where values of its vertices come later, their
  // order.
  const int triangle_colours = !has_colours(c) ? 0 : (gouraud ? 9 : 3) * t.colour.width;
  const int order = orders_vertices(c) ? VertexNumber::width() + Bit::width() : 0;
  const std::vector<Layout> layouts = make_engine(configuration, kAnyLanes)->layouts(),
                            all = all_layouts(configuration, layouts);
  const std::vector<std::pair<const char*, int>> constants = {
      {"HasDepth", depth},
      {"StoresDepth", stores_depth(c)},
      {"Gouraud", gouraud},
      {"Phong", is_phong(c)},
      {"HasTexture", has_texture(c)},
      {"SendsShape", sends_shape(c)},
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
      {"TriangleColourBits", triangle_colours},
      {"OrderBits", order},
      {"ColourFraction", c.colour_fraction},
      {"ColourPlaneBits", t.colour_plane.width},  // flat: the colour's
      {"PlanesWordBits", word_bits(layouts, "planes")}};
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
                        {"colour_gradient", t.colour_gradient, gouraud},
                        {"object", t.object, has_objects(c)}};

  std::string text = fmt::format(
      "// SPDX-License-Identifier: Apache-2.0\n"
      "// Number formats of configuration `{0}`. Printed by `halfspace package --config {0}` from "
      "hls/formats/formats.hpp\n"
      "// and hls/formats/records.hpp: change those, not this file.\n"
      "package hs_formats_pkg;\n\n",
      configuration.name());
  text += constants_text(constants) + lighting_text(c, layouts) + texture_text(c, layouts) + motion_text(c, all) +
          object_text(c, all) + "\n";
  for (const Type& type : types) {
    if (type.is_there)
      text += fmt::format("  typedef {}{}_t;\n", range(type.format.width, type.format.is_signed), type.name);
  }
  text += "\n";
  for (const Layout& layout : layouts) {
    if (layout.stream != "visible_attributes") text += record(layout);  // the record of attributes
  }
  for (const Layout& layout : all) {
    if (layout.stream == "merge" || layout.stream == "found") text += record(layout);
  }
  return text + "endpackage\n";
}

}  // namespace halfspace::model
