// SPDX-License-Identifier: Apache-2.0
#include "model/package/package_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "model/formats/stream_list.hpp"

namespace halfspace::model {
namespace {

// "edge_step": EdgeStep
std::string upper_camel(const std::string& name) {
  std::string text;
  bool upper = true;
  for (const unsigned char c : name) {
    if (c != '_') text += upper ? char(std::toupper(c)) : char(c);
    upper = c == '_';
  }
  return text;
}

std::string range(int width, bool is_signed) {
  const std::string sign = is_signed ? "signed " : "";
  return width == 1 ? "logic " + sign : fmt::format("logic {}[{}:0] ", sign, width - 1);
}

const FormatField& row_of(NumberFormat FormatTable::*format) {
  const auto& rows = format_fields();
  return *std::find_if(rows.begin(), rows.end(), [&](const FormatField& row) { return row.format == format; });
}

}  // namespace

void PackageWriter::number(const std::string& name, int value) {
  text_ += fmt::format("  localparam int unsigned {} = {};\n", name, value);
}

void PackageWriter::constants(const std::vector<const char*>& names) {
  for (const char* name : names) number(name, kernel_constant(config_, name));
}

void PackageWriter::fields(const std::vector<const char*>& names) {
  for (const char* name : names) {
    const ConfigField* field = find_field(name);
    if (!field) throw std::logic_error(fmt::format("there is no field {}", name));
    number(upper_camel(name), field->get(config_));
  }
}

void PackageWriter::bits(const std::vector<NumberFormat FormatTable::*>& formats) {
  for (const auto format : formats) {
    const FormatField& row = row_of(format);
    number(upper_camel(row.name) + "Bits", row.is_used(config_) ? (table_.*format).width : 0);
  }
}

void PackageWriter::words(const std::vector<const char*>& records) {
  for (const char* record : records)
    word(record, [&](const Layout& layout) { return record_name(layout.row) == record; });
}

void PackageWriter::word(const std::string& name, const char* stream) {
  word(name, [&](const Layout& layout) { return layout.stream == stream; });
}

void PackageWriter::word(const std::string& name, const std::function<bool(const Layout&)>& is_it) {
  const auto found = std::find_if(layouts_.begin(), layouts_.end(), is_it);
  number(name + "WordBits", found == layouts_.end() ? 1 : found->bits);
}

void PackageWriter::types(const std::vector<NumberFormat FormatTable::*>& formats) {
  for (const auto format : formats) {
    const FormatField& row = row_of(format);
    const NumberFormat number = table_.*format;
    if (row.is_used(config_))
      text_ += fmt::format("  typedef {}{}_t;\n", range(number.width, number.is_signed), row.name);
  }
}

void PackageWriter::record(const Layout& layout) {
  const bool has_lanes = layout.head_bits != layout.bits;
  if (has_lanes) {
    text_ += fmt::format("  // {0}: {{{0}_head_t", layout.stream);
    for (const Field& field : layout.fields) {
      if (field.lsb + field.width * field.count <= layout.bits - layout.head_bits) {
        text_ += field.width == 1 ? fmt::format(", {}[Lanes]", field.name)
                                  : fmt::format(", {}[Lanes][{}:0]", field.name, field.width - 1);
      }
    }
    text_ += "}\n";
  }
  text_ += "  typedef struct packed {\n";
  for (const Field& field : layout.fields) {
    if (field.lsb < layout.bits - layout.head_bits) continue;
    text_ += fmt::format("    {}{};\n", range(field.width, field.is_signed), field.name);
  }
  text_ += fmt::format("  }} {}{}_t;\n\n", layout.stream, has_lanes ? "_head" : "");
}

void PackageWriter::entries(const char* name, const std::vector<std::uint64_t>& entries, int bits, int first) {
  const int digits = (bits + 3) / 4, count = int(entries.size());
  text_ += fmt::format("  localparam logic [{}:0] {} = {{\n   ", count * bits - 1, name);
  for (int n = 1; n <= count; ++n) {
    const bool ends_line = (n - first) % 6 == 0;
    text_ += fmt::format(" {}'h{:0{}x}{}", bits, entries[std::size_t(count - n)], digits,
                         n == count  ? "\n  };\n"
                         : ends_line ? ",\n   "
                                     : ",");
  }
}

void PackageWriter::no_table(const char* name) { text_ += fmt::format("  localparam logic [0:0] {} = '0;\n", name); }

}  // namespace halfspace::model
