// SPDX-License-Identifier: Apache-2.0
// Configurations by name or from a file: TOML with the fields of Config, all of them but `shading` and `architecture`,
// which are "gouraud" and "delta" where nothing is said, and those of lighting and of texture, which are 0, "none" and
// "affine"; and nothing else.
#ifndef HALFSPACE_MODEL_FORMATS_CONFIGURATION_HPP_
#define HALFSPACE_MODEL_FORMATS_CONFIGURATION_HPP_

#include <string>
#include <vector>

#include "hls/formats/config.hpp"
#include "ref/geometry/snap.hpp"

namespace halfspace::model {

// A number of a Config by the name it has in the file.
struct ConfigField {
  const char* name;
  int Config::*value;
  const char* what;
};
const std::vector<ConfigField>& config_fields();
// Those of lighting, which a file without it leaves out; those of texture; of frames in between; and of static objects
// buffers.
const std::vector<ConfigField>& lighting_fields();
const std::vector<ConfigField>& texture_fields();
const std::vector<ConfigField>& motion_fields();
const std::vector<ConfigField>& object_fields();

// Fields with words for values.
struct ChoiceField {
  const char* name;
  const char* what;
  std::vector<const char*> values;
  int (*get)(const Config&);  // an index into values
  void (*set)(Config&, int);
};
const std::vector<ChoiceField>& choice_fields();
const ChoiceField& choice_field(const std::string& name);
// To the value of that name, which there is.
void set_choice(Config&, const std::string& field, const std::string& value);
// The value of such a field.
const char* choice_name(const std::string& field, const Config&);

// A Config that was accepted, with the name that it points to.
class Configuration {
 public:
  // Throws ref::Error with the reason of a refusal. The name is letters, digits, '_' and '-'.
  Configuration(std::string name, const Config& numbers);

  const std::string& name() const { return name_; }
  Config config() const;

 private:
  std::string name_;
  Config numbers_;
};

// Are all numbers the same, whatever the names?
bool same_numbers(const Config&, const Config&);

// Why, as a sentence with its remedy.
std::string refusal_text(Refusal refusal);

// low, middle, high.
const std::vector<Configuration>& named_configurations();
// A name of these, or the path of a .toml file. Throws ref::Error.
Configuration find_configuration(const std::string& name_or_path);
// `source` stands in the sentences of errors.
Configuration parse_configuration(const std::string& toml, const std::string& source);
// The text of its file.
std::string configuration_toml(const Configuration&);
// The text of its header, for a compiler: a struct with the name in UpperCamelCase.
std::string configuration_header(const Configuration&);

ref::RasterFormat raster_format(const Configuration&);

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_FORMATS_CONFIGURATION_HPP_
