// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#define TOML_EXCEPTIONS 1
#include <toml++/toml.h>

#include "model/formats/configuration.hpp"
#include "ref/error.hpp"

namespace halfspace::model {
namespace {

// `"nearest", "bilinear" or "area"`
std::string known_words(const ConfigField& field) {
  std::string known;
  for (std::size_t i = 0; i < field.words.size(); ++i) {
    const char* before = i == 0 ? "" : i + 1 == field.words.size() ? " or " : ", ";
    known += fmt::format("{}\"{}\"", before, field.words[i]);
  }
  return known;
}

// `where`: source and line.
void set_field(Config& numbers, const ConfigField& field, const toml::node& node, const std::string& where) {
  if (field.is_number()) {
    const auto value = node.value_exact<std::int64_t>();
    if (!value || *value < 0 || *value > 1 << 30) {
      throw ref::Error(fmt::format("{}: {} is a whole number of 0 or more", where, field.name));
    }
    field.set(numbers, int(*value));
    return;
  }
  const auto value = node.value_exact<std::string>();
  for (std::size_t i = 0; i < field.words.size(); ++i) {
    if (value && *value == field.words[i]) return field.set(numbers, int(i));
  }
  throw ref::Error(fmt::format("{}: {} is {}", where, field.name, known_words(field)));
}

}  // namespace

Configuration parse_configuration(const std::string& text, const std::string& source) {
  toml::table table;
  try {
    table = toml::parse(text);
  } catch (const toml::parse_error& e) {
    throw ref::Error(fmt::format("{}:{}: {}: write a line `name = value` a field", source, e.source().begin.line,
                                 std::string(e.description())));
  }
  Config numbers{};
  std::string name;
  for (const auto& [key, node] : table) {
    const std::string where = fmt::format("{}:{}", source, node.source().begin.line);
    if (key.str() == "name") {
      const auto value = node.value_exact<std::string>();
      if (!value) throw ref::Error(fmt::format("{}: name is a string in quotes", where));
      name = *value;
      continue;
    }
    const ConfigField* field = find_field(std::string(key.str()));
    if (!field) {
      std::string known = "name";
      for (const ConfigField& f : config_fields()) known += fmt::format(", {}", f.name);
      throw ref::Error(fmt::format("{}: there is no field '{}': the fields are {}", where, key.str(), known));
    }
    set_field(numbers, *field, node, where);
  }
  if (name.empty()) throw ref::Error(fmt::format("{}: the field 'name' is missing: add a line name = \"…\"", source));
  for (const ConfigField& f : numbers_of(Part::kBase)) {
    if (!table.contains(f.name)) {
      throw ref::Error(fmt::format("{}: the field '{}' is missing: add a line {} = …", source, f.name, f.name));
    }
  }
  try {
    return Configuration(name, numbers);
  } catch (const ref::Error& e) {
    throw ref::Error(fmt::format("{}: {}", source, e.what()));
  }
}

}  // namespace halfspace::model
