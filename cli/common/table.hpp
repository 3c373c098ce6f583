// SPDX-License-Identifier: Apache-2.0
// Tables of a command, for a terminal and for a page.
#ifndef HALFSPACE_CLI_COMMON_TABLE_HPP_
#define HALFSPACE_CLI_COMMON_TABLE_HPP_

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

namespace halfspace::cli {

struct Table {
  std::string name, heading;
  std::vector<std::vector<std::string>> rows;  // the first has the names of the columns
};

struct TableOptions {
  std::string only;  // the name of a table; empty: all, each under its heading
  bool markdown = false;
};
void add_table_options(CLI::App* command, TableOptions& options, const std::vector<std::string>& names);

// Padded columns, those of numbers to the right; or Markdown.
std::string text_of(const Table& table, bool markdown);
void print_tables(const std::vector<Table>& tables, const TableOptions& options);

// 1,234,567
std::string grouped(std::uint64_t number);
// "44.0 %"; "–" of nothing.
std::string share(double part, double whole);

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_COMMON_TABLE_HPP_
