// SPDX-License-Identifier: Apache-2.0
// The objects of a glTF file, as far as they are read.
#ifndef HALFSPACE_REF_SCENE_GLTF_FILE_SCHEMA_KINDS_HPP_
#define HALFSPACE_REF_SCENE_GLTF_FILE_SCHEMA_KINDS_HPP_

#include <map>
#include <string>
#include <vector>

namespace halfspace::ref::gltf {

enum class Kind { kWhole, kNumber, kIndex, kText, kFlag, kObject };
enum class Many { kOne, kList, kMap, kListOfMaps };

struct Property {
  const char* name;
  Kind kind;
  Many many = Many::kOne;
  std::string of = {};  // an index: the list that it counts; an object: its kind
  double low = 0, high = 0;
  int length = 0;  // of a list of numbers; 0: any
  bool required = false;

  Property must() const {
    Property copy = *this;
    copy.required = true;
    return copy;
  }
};

// By the name of the kind; that of the file itself is "glTF".
const std::map<std::string, std::vector<Property>>& kinds();

}  // namespace halfspace::ref::gltf

#endif  // HALFSPACE_REF_SCENE_GLTF_FILE_SCHEMA_KINDS_HPP_
