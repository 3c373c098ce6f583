// SPDX-License-Identifier: Apache-2.0
#include "vectors/package.hpp"

#include <fmt/format.h>

#include "vectors/engine.hpp"

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

}  // namespace

std::string formats_package(const Configuration& configuration) {
  const Config c = configuration.config();
  const FormatTable t = format_table(c);
  const std::pair<const char*, int> constants[] = {
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
      {"ReciprocalBits", t.reciprocal.width},
      {"ShiftBits", t.shift.width},
      {"SetupInterval", setup_interval(c)},
      {"DepthBits", t.depth.width},
      {"DepthFraction", c.depth_fraction},
      {"DepthPlaneBits", t.depth_plane.width},
      {"ColourBits", t.colour.width},
      {"ColourFraction", c.colour_fraction},
      {"ColourPlaneBits", t.colour_plane.width}};
  const std::pair<const char*, NumberFormat> types[] = {
      {"x", t.x},
      {"y", t.y},
      {"index", t.index},
      {"coord", t.coord},
      {"delta", t.delta},
      {"area", t.area},
      {"edge_step", t.edge_step},
      {"reciprocal", t.reciprocal},
      {"shift", t.shift},
      {"depth", t.depth},
      {"depth_plane", t.depth_plane},
      {"depth_gradient", t.depth_gradient},
      {"colour", t.colour},
      {"colour_plane", t.colour_plane},
      {"colour_gradient", t.colour_gradient}};

  std::string text = fmt::format(
      "// SPDX-License-Identifier: Apache-2.0\n"
      "// Number formats of configuration `{0}`. Printed by `halfspace package --config {0}` from hls/formats.hpp\n"
      "// and hls/records.hpp: change those, not this file.\n"
      "package hs_formats_pkg;\n\n",
      configuration.name());
  for (const auto& [name, value] : constants) text += fmt::format("  localparam int unsigned {} = {};\n", name, value);
  text += "\n";
  for (const auto& [name, format] : types) text += fmt::format("  typedef {}{}_t;\n", range(format.width, format.is_signed), name);
  text += "\n";
  // Any number of lanes would do: nothing printed depends on it.
  for (const Layout& layout : make_engine(configuration, 2)->layouts()) text += record(layout);
  return text + "endpackage\n";
}

}  // namespace halfspace::vectors
