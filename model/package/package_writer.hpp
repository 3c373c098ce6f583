// SPDX-License-Identifier: Apache-2.0
// The text of a package of formats, a declaration after the other; each room's are in a file of their own.
#ifndef HALFSPACE_MODEL_PACKAGE_PACKAGE_WRITER_HPP_
#define HALFSPACE_MODEL_PACKAGE_PACKAGE_WRITER_HPP_

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "model/formats/config_fields.hpp"
#include "model/formats/format_fields.hpp"
#include "model/formats/layout.hpp"

namespace halfspace::model {

// What is not there has no bits: its constants are 0, and the words of its streams have one bit, as a port has.
class PackageWriter {
 public:
  PackageWriter(const Config& config, const std::vector<Layout>& layouts) : config_(config), layouts_(layouts) {}

  const Config& config() const { return config_; }
  const FormatTable& table() const { return table_; }
  const std::string& text() const { return text_; }
  void line(const std::string& text) { text_ += text; }

  void number(const std::string& name, int value);
  // Those of hls/formats/lists/constant_list.hpp, by name.
  void constants(const std::vector<const char*>& names);
  // Fields of the configuration: depth_fraction is DepthFraction.
  void fields(const std::vector<const char*>& names);
  // Widths of formats: edge_step is EdgeStepBits.
  void bits(const std::vector<NumberFormat FormatTable::*>& formats);
  // Widths of words by their record: Motion is MotionWordBits; else by their stream.
  void words(const std::vector<const char*>& records);
  void word(const std::string& name, const char* stream);
  // Formats as types: edge_step is edge_step_t.
  void types(const std::vector<NumberFormat FormatTable::*>& formats);
  // The fields of a record that come once: the whole of it, or the head of a record with lanes.
  void record(const Layout& layout);
  // A packed array, entry 0 in the least significant place; `first` entries in the first line, six in the others.
  void entries(const char* name, const std::vector<std::uint64_t>& entries, int bits, int first);
  // In the place of a table that is not there.
  void no_table(const char* name);

 private:
  void word(const std::string& name, const std::function<bool(const Layout&)>& is_it);

  Config config_;
  FormatTable table_ = format_table(config_);
  const std::vector<Layout>& layouts_;
  std::string text_;
};

// A segment is {v, s}: a value and a slope.
template <class Table>
std::vector<std::uint64_t> segments_of(const Table& table, int segments, int slope_bits) {
  std::vector<std::uint64_t> entries;
  for (int n = 0; n < segments; ++n) entries.push_back(std::uint64_t(table.value[n]) << slope_bits | table.slope[n]);
  return entries;
}

// The declarations of a room each.
void add_lighting(PackageWriter&);
void add_texture(PackageWriter&);
void add_motion(PackageWriter&);

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_PACKAGE_PACKAGE_WRITER_HPP_
