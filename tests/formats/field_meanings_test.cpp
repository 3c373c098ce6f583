// SPDX-License-Identifier: Apache-2.0
// Every field of every stream has its line in the table of meanings, each line is of a field that there is, and what
// valid_if names is there.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include "model/formats/field_meanings.hpp"
#include "model/formats/stream_list.hpp"
#include "model/motion/compensation.hpp"
#include "model/objects/merge.hpp"
#include "model/pipeline/engine.hpp"
#include "model/pipeline/static_runs.hpp"
#include "ref/error.hpp"

namespace halfspace::tests {
namespace {

using model::Layout;

std::vector<Layout> layouts_of(const model::Configuration& configuration) {
  std::vector<Layout> all = model::make_engine(configuration, 4)->layouts();
  const auto add = [&](const std::vector<Layout>& more) { all.insert(all.end(), more.begin(), more.end()); };
  if (has_motion(configuration.config())) add(model::Compensator(configuration).layouts());
  if (has_motion(configuration.config())) add(model::Compensator(configuration).film_layouts());
  if (has_objects(configuration.config())) {
    add(model::Merger(configuration, 4).layouts());
    add(model::StaticRuns(configuration, 4, 8, 8).layouts());
  }
  return all;
}

std::vector<std::string> configurations() {
  std::vector<std::string> names{"low", "middle", "high"};
  for (const auto& entry : std::filesystem::recursive_directory_iterator(HALFSPACE_SOURCE "/tests/configs")) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().string());
  }
  return names;
}

// A flag comes once, or once a lane as what it is of.
void check_conditions(const std::vector<Layout>& layouts, const Layout& layout, const model::Field& field) {
  std::istringstream conditions(model::field_meaning(model::record_name(layout.row), field.name).valid_if);
  for (std::string condition; conditions >> condition;) {
    std::string name = condition.substr(condition[0] == '!');
    const Layout* of = &layout;
    if (const std::size_t dot = name.find('.'); dot != std::string::npos) {
      for (const Layout& other : layouts) {
        if (other.stream == name.substr(0, dot)) of = &other;
      }
      ASSERT_NE(of, &layout) << condition;
      name = name.substr(dot + 1);
    }
    bool found = false;
    for (const model::Field& flag : of->fields) {
      found = found || (flag.name == name && (flag.count == 1 || flag.count == field.count));
    }
    EXPECT_TRUE(found) << layout.stream << "." << field.name << " counts if " << condition;
  }
}

TEST(FieldMeanings, EveryFieldHasOneAndNoneIsStale) {
  std::set<std::string> fields, used_fields, used_orders;
  std::map<std::string, std::vector<std::string>> of_record;
  for (const std::string& name : configurations()) {
    const std::vector<Layout> layouts = layouts_of(model::find_configuration(name));
    for (const Layout& layout : layouts) {
      const std::string record = model::record_name(layout.row);
      const std::string within = model::record_order(record).any_order_within;
      used_orders.insert(record);
      bool has_within = within.empty();
      for (const model::Field& field : layout.fields) {
        EXPECT_NE(model::field_meaning(record, field.name).meaning, "") << record << "." << field.name;
        has_within = has_within || field.name == within;
        check_conditions(layouts, layout, field);
        if (fields.insert(record + " " + field.name).second) of_record[record].push_back(field.name);
      }
      EXPECT_TRUE(has_within) << record;
    }
  }
  EXPECT_GT(fields.size(), 200u);
  for (const std::string& line : model::field_lines()) {
    bool used = false;
    for (const auto& [record, names] : of_record) {
      for (const std::string& field : names) used = used || model::is_line_of(line, record, field);
    }
    EXPECT_TRUE(used) << "no stream of any configuration has `" << line << "`: take it out of the table";
  }
  for (const std::string& record : model::order_lines()) EXPECT_EQ(used_orders.count(record), 1u) << record;
}

TEST(FieldMeanings, WhatIsNotKnownIsAnError) {
  EXPECT_THROW(model::field_meaning("Stamp", "colour"), ref::Error);
  EXPECT_THROW(model::field_meaning("Stamps", "x"), ref::Error);
  EXPECT_THROW(model::record_order("Stamps"), ref::Error);
}

TEST(FieldMeanings, DigitsOfAFieldStandInItsText) {
  EXPECT_EQ(model::field_meaning("MotionPlanes", "s_dx_1").valid_if, "!empty there_1");
  EXPECT_EQ(model::field_meaning("Triangle", "x2").meaning, "where vertex 2 is in the picture, row 0 on top");
  EXPECT_EQ(model::field_meaning("Merge", "last").unit, model::field_meaning("Merge", "first").unit);
  EXPECT_EQ(model::field_meaning("Stamp", "last").meaning, "ends the frame");
}

}  // namespace
}  // namespace halfspace::tests
