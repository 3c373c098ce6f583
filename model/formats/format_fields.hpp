// SPDX-License-Identifier: Apache-2.0
// The rows of the format table, each with its name and the reason of its width, for people and for tests.
#ifndef HALFSPACE_MODEL_FORMATS_FORMAT_FIELDS_HPP_
#define HALFSPACE_MODEL_FORMATS_FORMAT_FIELDS_HPP_

#include <string>
#include <vector>

#include "hls/formats/formats.hpp"

namespace halfspace::model {

struct FormatField {
  const char* name;
  NumberFormat FormatTable::*format;
  const char* why;                 // of the width; c: bits of a position, f: sub-pixel bits, b: bits of the channel
  bool (*is_used)(const Config&);  // else no unit has such a number
};
const std::vector<FormatField>& format_fields();
// Those of lighting.
const std::vector<FormatField>& lighting_format_fields();
// Those of texture.
const std::vector<FormatField>& texture_format_fields();
const std::vector<FormatField>& motion_format_fields();
const std::vector<FormatField>& object_format_fields();

// "u13.0", "s11.8": sign, bits before and after the point.
std::string format_name(const NumberFormat& format);

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_FORMATS_FORMAT_FIELDS_HPP_
