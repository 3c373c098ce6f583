// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/gltf/file/schema_kinds.hpp"

namespace halfspace::ref::gltf {
namespace {

constexpr double kWholes = 9007199254740992.0, kInt = 2147483647.0, kFar = 1e30, kPi = 3.141592653589793;
constexpr double kLeast = 1e-30;

Property whole(const char* name, double low = 0, double high = kWholes) {
  return {name, Kind::kWhole, Many::kOne, {}, low, high};
}
Property number(const char* name, double low = -kFar, double high = kFar) {
  return {name, Kind::kNumber, Many::kOne, {}, low, high};
}
Property numbers(const char* name, int length, double low = -kFar) {
  return {name, Kind::kNumber, Many::kList, {}, low, kFar, length};
}
Property index(const char* name, const char* of) { return {name, Kind::kIndex, Many::kOne, of}; }
Property indices(const char* name, const char* of) { return {name, Kind::kIndex, Many::kList, of}; }
Property text(const char* name) { return {name, Kind::kText}; }
Property texts(const char* name) { return {name, Kind::kText, Many::kList}; }
Property flag(const char* name) { return {name, Kind::kFlag}; }
Property object(const char* name, const char* of) { return {name, Kind::kObject, Many::kOne, of}; }
Property objects(const char* name, const char* of) { return {name, Kind::kObject, Many::kList, of}; }
Property map(const char* name) { return {name, Kind::kIndex, Many::kMap, "accessors"}; }
Property maps(const char* name) { return {name, Kind::kIndex, Many::kListOfMaps, "accessors"}; }

}  // namespace

const std::map<std::string, std::vector<Property>>& kinds() {
  static const std::map<std::string, std::vector<Property>> table{
      {"glTF",
       {object("asset", "asset").must(), index("scene", "scenes"), objects("scenes", "scene"), objects("nodes", "node"),
        objects("meshes", "mesh"), objects("accessors", "accessor"), objects("bufferViews", "view"),
        objects("buffers", "buffer"), objects("materials", "material"), objects("textures", "texture"),
        objects("images", "image"), objects("samplers", "sampler"), objects("skins", "skin"),
        objects("cameras", "camera"), objects("animations", "animation"), texts("extensionsUsed"),
        texts("extensionsRequired"), object("extensions", "extensions")}},
      {"extensions", {object("KHR_lights_punctual", "lights")}},
      {"lights", {objects("lights", "light").must()}},
      {"light",
       {text("name"), text("type").must(), numbers("color", 3, 0), number("intensity", 0), number("range", kLeast),
        object("spot", "spot")}},
      {"spot", {number("innerConeAngle", 0, kPi), number("outerConeAngle", kLeast, kPi)}},
      {"asset", {text("version").must(), text("minVersion")}},
      {"scene", {indices("nodes", "nodes"), text("name")}},
      {"node",
       {indices("children", "nodes"), index("mesh", "meshes"), index("skin", "skins"), index("camera", "cameras"),
        numbers("matrix", 16), numbers("translation", 3), numbers("rotation", 4), numbers("scale", 3),
        numbers("weights", 0), text("name"), object("extensions", "node_extensions")}},
      {"node_extensions",
       {object("KHR_lights_punctual", "light_of_node"), object("EXT_mesh_gpu_instancing", "instancing")}},
      {"light_of_node", {index("light", "lights").must()}},
      {"instancing", {map("attributes").must()}},
      {"mesh", {objects("primitives", "primitive").must(), numbers("weights", 0), text("name")}},
      {"primitive",
       {map("attributes").must(), index("indices", "accessors"), index("material", "materials"), whole("mode", 0, 6),
        maps("targets")}},
      {"accessor",
       {index("bufferView", "bufferViews"), whole("byteOffset"), whole("componentType", 5120, 5126).must(),
        flag("normalized"), whole("count", 1).must(), text("type").must(), object("sparse", "sparse")}},
      {"sparse",
       {whole("count", 1, kInt).must(), object("indices", "sparse_indices").must(),
        object("values", "sparse_values").must()}},
      {"sparse_indices",
       {index("bufferView", "bufferViews").must(), whole("byteOffset", 0, kInt),
        whole("componentType", 5121, 5125).must()}},
      {"sparse_values", {index("bufferView", "bufferViews").must(), whole("byteOffset", 0, kInt)}},
      {"view",
       {index("buffer", "buffers").must(), whole("byteOffset"), whole("byteLength", 1).must(),
        whole("byteStride", 4, 252)}},
      {"buffer", {whole("byteLength", 1).must(), text("uri")}},
      {"image", {text("uri"), index("bufferView", "bufferViews"), text("mimeType")}},
      {"texture", {index("sampler", "samplers"), index("source", "images")}},
      {"sampler",
       {whole("magFilter", 0, 65535), whole("minFilter", 0, 65535), whole("wrapS", 0, 65535),
        whole("wrapT", 0, 65535)}},
      {"material",
       {text("name"), object("pbrMetallicRoughness", "roughness"), object("emissiveTexture", "texture_info"),
        numbers("emissiveFactor", 3, 0), text("alphaMode"), number("alphaCutoff", 0), flag("doubleSided"),
        object("extensions", "material_extensions")}},
      {"roughness",
       {numbers("baseColorFactor", 4, 0), object("baseColorTexture", "texture_info"), number("metallicFactor", 0),
        number("roughnessFactor", 0)}},
      {"material_extensions",
       {object("KHR_materials_unlit", "none"), object("KHR_materials_emissive_strength", "strength"),
        object("KHR_materials_pbrSpecularGlossiness", "glossiness")}},
      {"none", {}},
      {"strength", {number("emissiveStrength", 0)}},
      {"glossiness",
       {numbers("diffuseFactor", 4, 0), numbers("specularFactor", 3, 0), number("glossinessFactor", 0),
        object("diffuseTexture", "texture_info")}},
      {"texture_info",
       {index("index", "textures").must(), whole("texCoord", 0, kInt), object("extensions", "info_extensions")}},
      {"info_extensions", {object("KHR_texture_transform", "transform")}},
      {"transform", {numbers("offset", 2), numbers("scale", 2), number("rotation"), whole("texCoord", 0, kInt)}},
      {"skin",
       {indices("joints", "nodes").must(), index("inverseBindMatrices", "accessors"), index("skeleton", "nodes")}},
      {"camera",
       {text("type").must(), text("name"), object("perspective", "perspective"),
        object("orthographic", "orthographic")}},
      {"perspective",
       {number("yfov", kLeast, kPi).must(), number("aspectRatio", kLeast), number("znear", kLeast).must(),
        number("zfar", kLeast)}},
      {"orthographic",
       {number("xmag").must(), number("ymag").must(), number("znear", 0).must(), number("zfar", kLeast).must()}},
      {"animation", {text("name"), objects("channels", "channel").must(), objects("samplers", "keys").must()}},
      {"channel", {whole("sampler", 0, kInt).must(), object("target", "target").must()}},
      {"target", {index("node", "nodes"), text("path").must()}},
      {"keys", {index("input", "accessors").must(), index("output", "accessors").must(), text("interpolation")}},
  };
  return table;
}

}  // namespace halfspace::ref::gltf
