// SPDX-License-Identifier: Apache-2.0
// The rows of the format table, each with its name and the reason of its width, for people and for tests; and what a
// configuration tells the kernels, by name.
#ifndef HALFSPACE_MODEL_FORMATS_FORMAT_FIELDS_HPP_
#define HALFSPACE_MODEL_FORMATS_FORMAT_FIELDS_HPP_

#include <string>
#include <vector>

#include "hls/formats/formats.hpp"

namespace halfspace::model {

struct FormatField {
  Part part;
  const char* name;
  NumberFormat FormatTable::*format;
  bool (*is_used)(const Config&);  // else no unit has such a number
  const char* why;                 // of the width, in the letters of format_list.hpp
};
const std::vector<FormatField>& format_fields();

// k<name> of a view of the formats, a number of constant_list.hpp, which has it.
int kernel_constant(const Config&, const std::string& name);

// "u13.0", "s11.8": sign, bits before and after the point.
std::string format_name(const NumberFormat& format);

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_FORMATS_FORMAT_FIELDS_HPP_
