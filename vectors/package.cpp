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

std::string formats_package(const std::string& config) {
  // Any number of lanes would do: nothing printed depends on it.
  const auto engine = make_engine(config, 2);
  std::string text = fmt::format(
      "// SPDX-License-Identifier: Apache-2.0\n"
      "// Number formats of configuration `{0}`. Printed by `halfspace package --config {0}` from hls/formats.hpp\n"
      "// and hls/records.hpp: change those, not this file.\n"
      "package hs_formats_pkg;\n\n",
      config);
  for (const FormatConstant& constant : engine->constants()) {
    text += fmt::format("  localparam int unsigned {} = {};\n", constant.name, constant.value);
  }
  text += "\n";
  for (const FormatType& type : engine->types()) {
    text += fmt::format("  typedef {}{}_t;\n", range(type.width, type.is_signed), type.name);
  }
  text += "\n";
  for (const Layout& layout : engine->layouts()) text += record(layout);
  return text + "endpackage\n";
}

}  // namespace halfspace::vectors
