// SPDX-License-Identifier: Apache-2.0
#include "model/formats/format_fields.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace halfspace::model {

const std::vector<FormatField>& format_fields() {
  static const std::vector<FormatField> fields = {
#define HS_FORMAT(part, member, Type, is_used, why) {Part::part, #member, &FormatTable::member, is_used, why},
#include "hls/formats/lists/format_list.hpp"
  };
  return fields;
}

int kernel_constant(const Config& c, const std::string& name) {
#define HS_FLAG(Type, Name, function) \
  if (name == #Name) return int(function(c));
#define HS_CONSTANT(Name, field) \
  if (name == #Name) return int(c.field);
#include "hls/formats/lists/constant_list.hpp"
  throw std::logic_error("kernels know no constant " + name);
}

std::string format_name(const NumberFormat& format) {
  return fmt::format("{}{}.{}", format.is_signed ? 's' : 'u', format.integer, format.width - format.integer);
}

}  // namespace halfspace::model
