// SPDX-License-Identifier: Apache-2.0
// What the fields of the streams' words mean, and in which order the words come: for manifests, and for whoever
// compares words of a unit of his own.
#ifndef HALFSPACE_MODEL_FORMATS_FIELD_MEANINGS_HPP_
#define HALFSPACE_MODEL_FORMATS_FIELD_MEANINGS_HPP_

#include <string>
#include <vector>

namespace halfspace::model {

struct FieldMeaning {
  std::string meaning;
  // Of a value after `fraction` of its bits are behind the point: "stamps", "pixels", "depth" (0 … 2^b − 1 of the
  // configuration), "colour" (likewise), …; "": it has none.
  std::string unit;
  // When the field counts: names of fields of the word, with a blank between them, that are not 0, or are 0 where a `!`
  // stands before one. Of fields that come once a lane the lane decides. STREAM.FIELD: of the word of the same number
  // of another stream. "": always. A field that does not count may be anything.
  std::string valid_if;
};

struct RecordOrder {
  std::string order;
  // A field: words that follow each other with the same value of it may come in any order, and what ends them goes with
  // the last; "": the order is as said.
  std::string any_order_within;
};

// Of a field of a record (record_name() of a row of the table of streams). A field or record that is not known is a
// ref::Error: the table has a line for each.
FieldMeaning field_meaning(const std::string& record, const std::string& field);
RecordOrder record_order(const std::string& record);

// The lines of the table as "RECORD FIELD", # in the place of a digit: for the test that finds stale ones. A record
// `*` is any.
std::vector<std::string> field_lines();
std::vector<std::string> order_lines();
// Whether a line of field_lines() stands for this field of this record.
bool is_line_of(const std::string& line, const std::string& record, const std::string& field);

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_FORMATS_FIELD_MEANINGS_HPP_
