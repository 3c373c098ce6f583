// SPDX-License-Identifier: Apache-2.0
// The fields of Config by the names they have in a file.
#ifndef HALFSPACE_MODEL_FORMATS_CONFIG_FIELDS_HPP_
#define HALFSPACE_MODEL_FORMATS_CONFIG_FIELDS_HPP_

#include <string>
#include <vector>

#include "hls/formats/refusal.hpp"

namespace halfspace::model {

// A number, or a choice: an enumeration with a word a value.
struct ConfigField {
  Part part;
  const char* name;
  const char* what;
  int Config::*number;             // null of a choice
  Limits allowed;                  // of a number that is there
  Refusal refused;                 // of one outside
  std::vector<const char*> words;  // of a choice, in the order of its values
  const char* type;                // of a choice
  int (*get)(const Config&);       // a number; an index into words
  void (*set)(Config&, int);

  bool is_number() const { return number != nullptr; }
  // "640", "gouraud"
  std::string text(const Config& c) const { return is_number() ? std::to_string(get(c)) : words[get(c)]; }
};
// In the order of Config.
const std::vector<ConfigField>& config_fields();
// Null if there is none of that name.
const ConfigField* find_field(const std::string& name);
// The numbers of a part.
std::vector<ConfigField> numbers_of(Part part);

// Its fields to 0.
void clear_part(Config&, Part);
// Of a choice, to a word that it has.
void set_choice(Config&, const std::string& name, const std::string& word);

// Are all fields the same, whatever the names?
bool same_numbers(const Config&, const Config&);

// Why, as a sentence with its remedy.
std::string refusal_text(Refusal refusal);

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_FORMATS_CONFIG_FIELDS_HPP_
