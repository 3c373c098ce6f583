// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#define TINYGLTF_IMPLEMENTATION
#include "ref/scene/gltf/file/tinygltf.hpp"
