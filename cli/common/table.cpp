// SPDX-License-Identifier: Apache-2.0
#include "cli/common/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdio>

namespace halfspace::cli {
namespace {

// Of UTF-8 text: its bytes but those that continue a character.
std::size_t width_of(const std::string& text) {
  return std::size_t(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

bool looks_numeric(const std::string& cell) {
  if (cell.empty() || cell == "–") return true;
  const std::size_t sign = cell[0] == '-' || cell[0] == '+' ? 1 : 0;
  return cell.size() > sign && std::isdigit(static_cast<unsigned char>(cell[sign]));
}

struct Column {
  std::size_t width = 0;
  bool right = true;
};

std::vector<Column> columns_of(const Table& table) {
  std::vector<Column> columns;
  for (const auto& row : table.rows) {
    if (columns.size() < row.size()) columns.resize(row.size());
    for (std::size_t c = 0; c < row.size(); ++c) {
      columns[c].width = std::max(columns[c].width, width_of(row[c]));
      if (&row != &table.rows[0]) columns[c].right = columns[c].right && looks_numeric(row[c]);
    }
  }
  return columns;
}

}  // namespace

std::string text_of(const Table& table, bool markdown) {
  const std::vector<Column> columns = columns_of(table);
  std::string text;
  for (const auto& row : table.rows) {
    std::string line = markdown ? "|" : "";
    for (std::size_t c = 0; c < row.size(); ++c) {
      if (markdown) {
        line += " " + row[c] + (row[c].empty() ? "|" : " |");
        continue;
      }
      const std::string pad(columns[c].width - width_of(row[c]), ' ');
      line += (columns[c].right ? pad + row[c] : row[c] + pad) + "  ";
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    if (markdown && &row == &table.rows[0]) {
      for (std::size_t c = 0; c < row.size(); ++c) text += "|---";
      text += "|\n";
    }
  }
  return text;
}

void print_tables(const std::vector<Table>& tables, const TableOptions& options) {
  bool first = true;
  for (const Table& table : tables) {
    if (!options.only.empty() && table.name != options.only) continue;
    if (options.only.empty()) fmt::print("{}{}\n\n", first ? "" : "\n", table.heading);
    std::fputs(text_of(table, options.markdown).c_str(), stdout);
    first = false;
  }
}

void add_table_options(CLI::App* command, TableOptions& options, const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  command->add_option("--table", options.only, "one table alone, without its heading: " + all)
      ->check(CLI::IsMember(names));
  command->add_flag("--markdown", options.markdown, "tables in Markdown");
}

std::string grouped(std::uint64_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, ",");
  return digits;
}

std::string share(double part, double whole) { return whole == 0 ? "–" : fmt::format("{:.1f} %", 100 * part / whole); }

}  // namespace halfspace::cli
