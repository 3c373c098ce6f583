// SPDX-License-Identifier: Apache-2.0
// What holds the JSON and the bytes: a text, or GLB.
#ifndef HALFSPACE_REF_SCENE_GLTF_FILE_CONTAINER_HPP_
#define HALFSPACE_REF_SCENE_GLTF_FILE_CONTAINER_HPP_

#include <cstdint>
#include <string>
#include <string_view>

namespace halfspace::ref::gltf {

struct Container {
  std::string bytes;      // of the file
  std::string_view json;  // in them
  std::string_view binary;
  bool has_binary = false;
};

// Error on what is not there, is cut, or is nested so deeply that no reader's stack is safe.
Container read_container(const std::string& path);

// The first bytes of a file, at most `most`. False if it is not regular, or cannot be read.
bool read_bytes(const std::string& path, std::size_t most, std::string* bytes);

}  // namespace halfspace::ref::gltf

#endif  // HALFSPACE_REF_SCENE_GLTF_FILE_CONTAINER_HPP_
