// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "model/formats/configuration.hpp"

namespace halfspace::model {
namespace {

// "lit_low": LitLow, and LIT_LOW.
struct Names {
  std::string type, guard;
};
Names names_of(const std::string& name) {
  Names names;
  bool upper = true;
  for (const unsigned char c : name) {
    const bool letter = std::isalnum(c);
    names.guard += letter ? char(std::toupper(c)) : '_';
    if (letter) names.type += upper ? char(std::toupper(c)) : char(c);
    upper = !letter;
  }
  if (names.type.empty() || std::isdigit(static_cast<unsigned char>(names.type[0])))
    names.type = "Configuration" + names.type;
  return names;
}

// Those of the parts that are there.
std::vector<ConfigField> fields_of(const Config& c) {
  std::vector<ConfigField> fields;
  for (const ConfigField& field : config_fields()) {
    if (has_part(field.part, c)) fields.push_back(field);
  }
  return fields;
}

}  // namespace

std::string configuration_toml(const Configuration& configuration) {
  std::string text = fmt::format("name = \"{}\"\n", configuration.name());
  const Config c = configuration.config();
  for (const ConfigField& field : fields_of(c)) {
    const char* quote = field.is_number() ? "" : "\"";
    const std::string line = fmt::format("{} = {}{}{}", field.name, quote, field.text(c), quote);
    text += *field.what ? fmt::format("{:<23} # {}\n", line, field.what) : line + "\n";
  }
  return text;
}

std::string configuration_header(const Configuration& configuration) {
  const Names names = names_of(configuration.name());
  const Config c = configuration.config();
  // Positions of an aggregate: all fields as far as the last that is there.
  const auto& fields = config_fields();
  const auto end =
      std::find_if(fields.rbegin(), fields.rend(), [&](const ConfigField& f) { return has_part(f.part, c); }).base();
  std::string numbers = fmt::format("    return {{\"{}\"", configuration.name());
  std::size_t line = 0;  // where the last one begins
  for (auto field = fields.begin(); field != end; ++field) {
    std::string value = field->text(c);
    if (!field->is_number()) {
      value[0] = char(std::toupper(static_cast<unsigned char>(value[0])));
      value = fmt::format("{}::k{}", field->type, value);
    }
    const bool fits = numbers.size() - line + value.size() + 4 <= 120;
    numbers += fits ? ", " : ",\n            ";
    if (!fits) line = numbers.rfind('\n') + 1;
    numbers += value;
  }
  return fmt::format(
      "// SPDX-License-Identifier: Apache-2.0\n"
      "// Configuration `{0}` for the kernels, in the order of Config.\n"
      "// Printed by `halfspace config {0} --header FILE` from its .toml file: change that, not this one.\n"
      "#ifndef HALFSPACE_CONFIGS_{1}_HPP_\n"
      "#define HALFSPACE_CONFIGS_{1}_HPP_\n\n"
      "#include \"hls/formats/config.hpp\"\n\n"
      "namespace halfspace {{\n\n"
      "struct {2} {{\n"
      "  static constexpr Config config() {{\n{3}}};\n  }}\n"
      "}};\n\n"
      "}}  // namespace halfspace\n\n"
      "#endif  // HALFSPACE_CONFIGS_{1}_HPP_\n",
      configuration.name(), names.guard, names.type, numbers);
}

}  // namespace halfspace::model
