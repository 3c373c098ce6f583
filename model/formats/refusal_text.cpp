// SPDX-License-Identifier: Apache-2.0
// Refusals as sentences: those of limits from the limits themselves.
#include <fmt/format.h>

#include "model/formats/config_fields.hpp"

namespace halfspace::model {
namespace {

// "a", "a and b", "a, b and c"
std::string listed(const std::vector<std::string>& words, const char* last) {
  std::string text;
  for (std::size_t n = 0; n < words.size(); ++n) text += (n == 0 ? "" : n + 1 == words.size() ? last : ", ") + words[n];
  return text;
}

// "1 to 12", "0 or 1", "1, 2 or 4", "a power of two, 4 to 1048576"
std::string limits_text(const Limits& allowed) {
  const int most_listed = 16;
  std::vector<std::string> values;
  for (int v = allowed.low; v <= allowed.high && v <= most_listed; v += allowed.is_power ? v : 1)
    values.push_back(std::to_string(v));
  const bool lists = allowed.is_power ? allowed.high <= most_listed : allowed.high - allowed.low == 1;
  if (lists) return listed(values, " or ");
  return fmt::format("{}{} to {}", allowed.is_power ? "a power of two, " : "", allowed.low, allowed.high);
}

// "width and height are 1 to 8192": the fields with this refusal, those of the same limits together.
std::string fields_text(Refusal refusal) {
  std::string text;
  std::vector<std::string> names;
  std::string of_names;
  const auto say = [&] {
    if (names.empty()) return;
    text += fmt::format("{}{} {} {}", text.empty() ? "" : ", ", listed(names, " and "),
                        names.size() == 1 ? "is" : "are", of_names);
    names.clear();
  };
  for (const ConfigField& field : config_fields()) {
    if (!field.is_number() || field.refused != refusal) continue;
    if (const std::string of_field = limits_text(field.allowed); of_field != of_names) {
      say();
      of_names = of_field;
    }
    names.push_back(field.name);
  }
  say();
  return text;
}

}  // namespace

std::string refusal_text(Refusal refusal) {
#define HS_LIMIT(name, more) \
  if (refusal == Refusal::name) return fields_text(refusal) + (more);
#define HS_REFUSAL(name, sentence) \
  if (refusal == Refusal::name) return sentence;
#include "hls/formats/lists/refusal_list.hpp"
  return "it is accepted";
}

}  // namespace halfspace::model
