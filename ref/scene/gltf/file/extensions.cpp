// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/gltf/file/extensions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace halfspace::ref::gltf {
namespace {

constexpr std::array<std::string_view, 7> kDrawn{"KHR_mesh_quantization",
                                                 "KHR_texture_transform",
                                                 "KHR_materials_unlit",
                                                 "KHR_materials_emissive_strength",
                                                 "KHR_materials_pbrSpecularGlossiness",
                                                 "KHR_lights_punctual",
                                                 "EXT_mesh_gpu_instancing"};

// What is said of a thing but not seen of it.
constexpr std::array<std::string_view, 12> kUnseen{"KHR_xmp",
                                                   "KHR_xmp_json_ld",
                                                   "KHR_audio",
                                                   "KHR_audio_emitter",
                                                   "EXT_mesh_features",
                                                   "MSFT_packing_occlusionRoughnessMetallic",
                                                   "EXT_structural_metadata",
                                                   "EXT_instance_features",
                                                   "KHR_physics_rigid_bodies",
                                                   "KHR_implicit_shapes",
                                                   "KHR_interactivity",
                                                   "KHR_node_selectability"};

// What is there without them too, or is said to be missing where it is.
constexpr std::array<std::string_view, 8> kWithAnother{
    "KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression", "KHR_texture_basisu",
    "EXT_texture_webp",           "EXT_texture_avif",        "MSFT_texture_dds",        "MSFT_lod"};

template <class List>
bool holds(const List& list, const std::string& name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

}  // namespace

void check_extensions(File* file) {
  for (const std::string& name : file->model.extensionsRequired) {
    if (holds(kDrawn, name) || holds(kUnseen, name)) continue;
    throw Error(
        fmt::format("{}: requires the extension {}, which is not drawn; export it without", file->path, name_of(name)));
  }
  std::string others;
  for (const std::string& name : file->model.extensionsUsed) {
    if (holds(kDrawn, name) || holds(kUnseen, name) || holds(kWithAnother, name)) continue;
    others += (others.empty() ? "" : ", ") + name_of(name);
  }
  if (!others.empty()) file->remark(fmt::format("drawn without what these extensions add: {}", others));
}

}  // namespace halfspace::ref::gltf
