// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_SCENE_GLTF_FILE_SCHEMA_HPP_
#define HALFSPACE_REF_SCENE_GLTF_FILE_SCHEMA_HPP_

#include <nlohmann/json.hpp>
#include <string>

namespace halfspace::ref::gltf {

// Holds all that is read of a file against what the specification allows: kinds, ranges, and that what is referred to
// is there. tinygltf takes what has the wrong kind for not there, and a number of more than 32 bits for another one.
void check_schema(const std::string& path, const nlohmann::json& root);

}  // namespace halfspace::ref::gltf

#endif  // HALFSPACE_REF_SCENE_GLTF_FILE_SCHEMA_HPP_
