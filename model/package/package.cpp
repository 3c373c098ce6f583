// SPDX-License-Identifier: Apache-2.0
#include "model/package/package.hpp"

#include <fmt/format.h>

#include "hls/formats/records.hpp"
#include "hls/formats/setup_interval.hpp"
#include "model/motion/compensation.hpp"
#include "model/objects/merge.hpp"
#include "model/package/package_writer.hpp"
#include "model/pipeline/engine.hpp"

namespace halfspace::model {
namespace {

// Nothing printed depends on it.
constexpr int kAnyLanes = 2;

void add_setup(PackageWriter& out) {
  using T = FormatTable;
  const Config& c = out.config();
  const FormatTable& t = out.table();
  out.constants({"HasDepth", "StoresDepth", "Gouraud", "Phong", "HasTexture", "SendsShape"});
  out.number("MaxWidth", c.width);
  out.number("MaxHeight", c.height);
  out.constants({"Triangles", "CullsBack", "CullsFront", "GivesIndices", "IndexWindow"});
  out.bits({&T::x, &T::y, &T::index});
  out.constants({"SubpixelBits"});
  out.bits({&T::coord, &T::delta, &T::area, &T::edge, &T::edge_step});
  out.constants({"ReciprocalFraction"});
  out.bits({&T::reciprocal, &T::shift});
  out.number("SetupInterval", setup_interval(c));
  out.bits({&T::depth});
  out.fields({"depth_fraction"});
  out.bits({&T::depth_plane, &T::colour});
  // Of a triangle as it comes: its colours; and of its attributes, where values of its vertices come later, their
  // order.
  out.number("TriangleColourBits", !has_colours(c) ? 0 : (is_gouraud(c) ? 9 : 3) * t.colour.width);
  out.number("OrderBits", orders_vertices(c) ? VertexNumber::width() + Bit::width() : 0);
  out.fields({"colour_fraction"});
  out.number("ColourPlaneBits", t.colour_plane.width);  // flat: the colour's
  out.word("Planes", "planes");
}

void add_objects(PackageWriter& out) {
  using T = FormatTable;
  out.constants({"HasObjects"});
  out.bits({&T::object, &T::object_count});
  out.words({"Merge", "Found"});
}

// Those of motion_compensate and ztest_merge besides, which are no part of an engine.
std::vector<Layout> all_layouts(const Configuration& configuration, std::vector<Layout> layouts) {
  if (has_motion(configuration.config())) {
    const Compensator compensator(configuration);
    for (const Layout& layout : compensator.layouts()) layouts.push_back(layout);
    for (const Layout& layout : compensator.film_layouts()) layouts.push_back(layout);
  }
  if (has_objects(configuration.config())) {
    for (const Layout& layout : Merger(configuration, kAnyLanes).layouts()) layouts.push_back(layout);
  }
  return layouts;
}

}  // namespace

std::string formats_package(const Configuration& configuration) {
  using T = FormatTable;
  const std::vector<Layout> layouts = make_engine(configuration, kAnyLanes)->layouts(),
                            all = all_layouts(configuration, layouts);
  PackageWriter out(configuration.config(), all);
  out.line(
      fmt::format("// SPDX-License-Identifier: Apache-2.0\n"
                  "// Number formats of configuration `{0}`. Printed by `halfspace package --config {0}` from "
                  "hls/formats/formats.hpp\n"
                  "// and hls/formats/records.hpp: change those, not this file.\n"
                  "package hs_formats_pkg;\n\n",
                  configuration.name()));
  add_setup(out);
  add_lighting(out);
  add_texture(out);
  add_motion(out);
  add_objects(out);
  out.line("\n");
  out.types({&T::x, &T::y, &T::index, &T::coord, &T::delta, &T::area, &T::edge_step, &T::reciprocal, &T::shift,
             &T::depth, &T::depth_plane, &T::depth_gradient, &T::colour, &T::colour_plane, &T::colour_gradient,
             &T::object});
  out.line("\n");
  for (const Layout& layout : layouts) {
    // The records of attributes, and of scan.
    if (layout.stream != "visible_attributes" && layout.stream != "masked") out.record(layout);
    if (layout.stream != "triangle" || gives_indices(configuration.config())) continue;
    Layout numbered = layout;  // as it comes
    numbered.stream = "numbered";
    out.record(numbered);
  }
  for (const Layout& layout : all) {
    for (const char* record : {"merge", "found", "asked", "film"}) {
      if (layout.stream == record) out.record(layout);
    }
  }
  out.line("endpackage\n");
  return out.text();
}

}  // namespace halfspace::model
