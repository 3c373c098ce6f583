// SPDX-License-Identifier: Apache-2.0
// Configurations by name or from a file: TOML with the fields of Config and nothing else. A file may leave out choices,
// which are the first word then, and the numbers of a part that is not there, which are 0.
#ifndef HALFSPACE_MODEL_FORMATS_CONFIGURATION_HPP_
#define HALFSPACE_MODEL_FORMATS_CONFIGURATION_HPP_

#include <string>
#include <vector>

#include "model/formats/config_fields.hpp"
#include "ref/geometry/snap.hpp"

namespace halfspace::model {

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

// low, middle, high.
const std::vector<Configuration>& named_configurations();
// A name of these, or the path of a .toml file. Throws ref::Error.
Configuration find_configuration(const std::string& name_or_path);
// `source` stands in the sentences of errors.
Configuration parse_configuration(const std::string& text, const std::string& source);
// The text of its file.
std::string configuration_toml(const Configuration&);
// The text of its header, for a compiler: a struct with the name in UpperCamelCase.
std::string configuration_header(const Configuration&);

ref::RasterFormat raster_format(const Configuration&);

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_FORMATS_CONFIGURATION_HPP_
