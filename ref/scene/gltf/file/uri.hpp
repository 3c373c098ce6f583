// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_SCENE_GLTF_FILE_URI_HPP_
#define HALFSPACE_REF_SCENE_GLTF_FILE_URI_HPP_

#include <optional>
#include <string>

namespace halfspace::ref::gltf {

// What a data URI holds, by base64 or by per cent; none: it is another URI. Error on one that is no base64.
std::optional<std::string> data_of(const std::string& scene, const std::string& uri);

// The file that a URI means, seen from the scene's folder: "a%20b.png" is "a b.png". Exporters write paths of their own
// machines: where there is no such file, that of its name beside the scene. Empty: there is none.
std::string file_of(const std::string& scene, const std::string& uri);

// For a sentence: short.
std::string shown(const std::string& uri);

}  // namespace halfspace::ref::gltf

#endif  // HALFSPACE_REF_SCENE_GLTF_FILE_URI_HPP_
