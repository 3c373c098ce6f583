// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/gltf/file/schema.hpp"

#include <fmt/format.h>

#include "ref/scene/gltf/file/file.hpp"
#include "ref/scene/gltf/file/schema_kinds.hpp"

namespace halfspace::ref::gltf {
namespace {

using nlohmann::json;

class Check {
 public:
  Check(const std::string& path, const json& root) : path_(path), root_(root) {}

  // `where`: of the object in the file.
  void object(const json& value, const std::string& where, const std::string& kind) const {
    if (!value.is_object()) fail(where, "an object");
    for (const Property& property : kinds().at(kind)) {
      const std::string here = where.empty() ? property.name : where + '.' + property.name;
      const auto found = value.find(property.name);
      if (found != value.end()) list_or_one(*found, here, property);
      else if (property.required) refuse(path_, fmt::format("cannot be read as a mesh ({} is missing)", here));
    }
  }

 private:
  [[noreturn]] void fail(const std::string& where, const std::string& what) const {
    refuse(path_, fmt::format("cannot be read as a mesh ({} is not {})", where.empty() ? "the JSON" : where, what));
  }

  std::size_t length_of(const std::string& list) const {
    const json* at = &root_;
    const bool lights = list == "lights";
    for (const char* step : {"extensions", "KHR_lights_punctual"}) {
      if (lights && at) at = at->is_object() && at->contains(step) ? &at->at(step) : nullptr;
    }
    if (!at || !at->is_object() || !at->contains(list)) return 0;
    return at->at(list).size();
  }

  void list_or_one(const json& value, const std::string& where, const Property& property) const {
    if (property.many == Many::kOne) return one(value, where, property);
    Property part = property;
    part.many = property.many == Many::kListOfMaps ? Many::kMap : Many::kOne;
    if (property.many == Many::kMap) {
      if (!value.is_object()) fail(where, "an object");
      for (const auto& [name, entry] : value.items()) one(entry, where + '.' + name_of(name), part);
      return;
    }
    if (!value.is_array()) fail(where, "a list");
    if (property.length != 0 && value.size() != std::size_t(property.length)) {
      fail(where, fmt::format("a list of {} numbers", property.length));
    }
    for (std::size_t i = 0; i < value.size(); ++i) list_or_one(value[i], fmt::format("{}[{}]", where, i), part);
  }

  void one(const json& value, const std::string& where, const Property& property) const {
    switch (property.kind) {
      case Kind::kObject: return object(value, where, property.of);
      case Kind::kText:
        if (!value.is_string()) fail(where, "a text");
        return;
      case Kind::kFlag:
        if (!value.is_boolean()) fail(where, "true or false");
        return;
      case Kind::kIndex: {
        const std::size_t length = length_of(property.of);
        if (value.is_number_unsigned() && value.get<std::uint64_t>() < length) return;
        fail(where, fmt::format("one of the {} {}", length, property.of));
      }
      case Kind::kWhole:
        if (value.is_number_unsigned() && within(value, property)) return;
        fail(where, fmt::format("a whole number from {} to {}", property.low, property.high));
      case Kind::kNumber:
        if (value.is_number() && within(value, property)) return;
        fail(where, fmt::format("a number from {} to {}", property.low, property.high));
    }
  }

  static bool within(const json& value, const Property& property) {
    const double number = value.get<double>();
    return number >= property.low && number <= property.high;
  }

  const std::string& path_;
  const json& root_;
};

}  // namespace

void check_schema(const std::string& path, const json& root) { Check(path, root).object(root, "", "glTF"); }

}  // namespace halfspace::ref::gltf
