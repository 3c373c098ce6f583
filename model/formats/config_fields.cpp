// SPDX-License-Identifier: Apache-2.0
#include "model/formats/config_fields.hpp"

#include <algorithm>
#include <stdexcept>

namespace halfspace::model {

const std::vector<ConfigField>& config_fields() {
  using limits::or_none;
  using limits::power;
  using limits::range;
  static const std::vector<ConfigField> fields = {
#define HS_NUMBER(part, field, is_there, allowed, refused, what) \
  {Part::part,                                                   \
   #field,                                                       \
   what,                                                         \
   &Config::field,                                               \
   allowed,                                                      \
   Refusal::refused,                                             \
   {},                                                           \
   "",                                                           \
   [](const Config& c) { return c.field; },                      \
   [](Config& c, int value) { c.field = value; }},
#define HS_CHOICE(part, field, Type, what, ...)  \
  {Part::part,                                   \
   #field,                                       \
   what,                                         \
   nullptr,                                      \
   {},                                           \
   Refusal::kNone,                               \
   {__VA_ARGS__},                                \
   #Type,                                        \
   [](const Config& c) { return int(c.field); }, \
   [](Config& c, int value) { c.field = Type(value); }},
#include "hls/formats/lists/config_list.hpp"
  };
  return fields;
}

const ConfigField* find_field(const std::string& name) {
  const auto& fields = config_fields();
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const ConfigField& f) { return name == f.name; });
  return found == fields.end() ? nullptr : &*found;
}

std::vector<ConfigField> numbers_of(Part part) {
  std::vector<ConfigField> numbers;
  for (const ConfigField& field : config_fields()) {
    if (field.is_number() && field.part == part) numbers.push_back(field);
  }
  return numbers;
}

void clear_part(Config& c, Part part) {
  for (const ConfigField& field : config_fields()) {
    if (field.part == part) field.set(c, 0);
  }
}

void set_choice(Config& c, const std::string& name, const std::string& word) {
  const ConfigField* field = find_field(name);
  if (!field) throw std::logic_error("there is no choice " + name);
  field->set(c, int(std::find(field->words.begin(), field->words.end(), word) - field->words.begin()));
}

bool same_numbers(const Config& a, const Config& b) {
  const auto& fields = config_fields();
  return std::all_of(fields.begin(), fields.end(), [&](const ConfigField& f) { return f.get(a) == f.get(b); });
}

}  // namespace halfspace::model
