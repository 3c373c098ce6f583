// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/gltf/file/file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "ref/scene/gltf/file/container.hpp"
#include "ref/scene/gltf/file/extensions.hpp"
#include "ref/scene/gltf/file/schema.hpp"
#include "ref/scene/gltf/file/uri.hpp"
#include "ref/scene/gltf/read_gltf.hpp"
#include "ref/scene/input_file.hpp"

namespace halfspace::ref::gltf {
namespace {

using nlohmann::json;

constexpr std::size_t kLongestName = 200;  // bytes

json parse(const std::string& path, std::string_view text) {
  try {
    return json::parse(text);
  } catch (const json::exception& error) {
    refuse(path, fmt::format("cannot be read as a mesh ({})", one_line(error.what())));
  }
}

std::string text_of(const json& object, const char* name) {
  const auto found = object.is_object() ? object.find(name) : object.end();
  return object.is_object() && found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

void check_version(const std::string& path, const json& root) {
  if (!root.is_object() || !root.contains("asset")) refuse(path, "cannot be read as a mesh (there is no asset)");
  const std::string version = text_of(root["asset"], "version"), least = text_of(root["asset"], "minVersion");
  if (version.compare(0, 2, "1.") == 0 || version == "1") {
    throw FirstGltf(fmt::format("{}: is of glTF {}; export it as glTF 2.0", path, name_of(version)));
  }
  if (version.compare(0, 2, "2.") != 0 || (!least.empty() && least != "2.0")) {
    refuse(path,
           fmt::format("asks for a reader of glTF '{}', and 2.0 is read", name_of(least.empty() ? version : least)));
  }
}

std::string buffer_of_uri(const std::string& path, const std::string& uri, std::size_t size) {
  if (std::optional<std::string> data = data_of(path, uri)) return std::move(*data);
  const std::string name = file_of(path, uri);
  if (name.empty()) {
    throw Error(fmt::format("{}: cannot be read as a mesh (its buffer '{}' is not there); put it beside the file", path,
                            shown(uri)));
  }
  std::string bytes;
  if (!read_bytes(name, size, &bytes)) {
    refuse(path, fmt::format("cannot be read as a mesh (its buffer '{}' cannot be read)", shown(uri)));
  }
  return bytes;
}

// tinygltf takes an index for out of range if its accessor has no view, which the specification allows. It has the one
// behind the last here, which nothing refers to.
int add_empty_view(json* root) {
  if (!root->contains("accessors")) return -1;
  json& views = (*root)["bufferViews"];
  if (views.is_null()) views = json::array();
  const int number = int(views.size());
  for (json& accessor : (*root)["accessors"]) {
    if (!accessor.contains("bufferView")) accessor["bufferView"] = number;
  }
  views.push_back({{"buffer", 0}, {"byteLength", 1}});
  return number;
}

tinygltf::Model model_of(const std::string& path, const json& root) {
  const std::string text = root.dump();
  tinygltf::Model model;
  std::string error, warning;
  if (text.size() > 0xFFFFFFFFu) refuse(path, "has more than 4 GB of JSON");
  if (!tinygltf::TinyGLTF().LoadASCIIFromString(&model, &error, &warning, text.data(), unsigned(text.size()), "")) {
    refuse(path, fmt::format("cannot be read as a mesh ({})", one_line(error)));
  }
  return model;
}

}  // namespace

void refuse(const std::string& path, const std::string& what) {
  throw Error(fmt::format("{}: {}; check the file, or export it again", path, what));
}

std::string name_of(const std::string& text) {
  std::size_t length = std::min<std::size_t>(text.size(), kLongestName);
  while (length < text.size() && length > 0 && (text[length] & 0xC0) == 0x80) --length;  // no part of a letter
  std::string name;
  for (const char c : text.substr(0, length)) name += std::uint8_t(c) < 0x20 || c == 0x7F ? ' ' : c;
  return name;
}

File::File(const std::string& of, const ReadChoice& read) : path(of), choice(read), container_(read_container(of)) {
  json root = parse(path, container_.json);
  if (!container_.has_binary) container_ = {};
  check_version(path, root);
  check_schema(path, root);
  for (const char* list : {"buffers", "images"}) {
    const auto found = root.find(list);
    if (found == root.end()) continue;
    for (json& entry : *found) list[0] == 'b' ? add_buffer(&entry) : add_picture(&entry);
    root.erase(found);
  }
  no_view_ = add_empty_view(&root);
  model = model_of(path, root);
  check_extensions(this);
}

void File::add_buffer(nlohmann::json* buffer) {
  const std::size_t size = (*buffer)["byteLength"].get<std::size_t>();
  std::string_view all;
  if (buffer->contains("uri")) {
    all = own_.emplace_back(buffer_of_uri(path, (*buffer)["uri"].get_ref<const std::string&>(), size));
  } else if (buffers_.empty() && container_.has_binary) {
    all = container_.binary;
  }
  if (!all.empty() && all.size() < size) {
    refuse(fmt::format("cannot be read as a mesh (buffer {} says that it has {} bytes and has {})", buffers_.size(),
                       size, all.size()));
  }
  buffers_.push_back(all.substr(0, size));
}

void File::add_picture(nlohmann::json* image) {
  Picture& picture = pictures.emplace_back();
  if (image->contains("bufferView")) picture.view = (*image)["bufferView"].get<int>();
  if (!image->contains("uri")) return;
  picture.uri = std::move((*image)["uri"].get_ref<std::string&>());
}

std::string_view File::view(int number) const {
  const tinygltf::BufferView& view = model.bufferViews[std::size_t(number)];
  const std::string_view buffer = buffers_[std::size_t(view.buffer)];
  for (const char* codec : {"EXT_meshopt_compression", "KHR_meshopt_compression", "MESHOPT_compression"}) {
    if (buffer.empty() && view.extensions.count(codec)) {
      throw Error(fmt::format("{}: is compressed by {}, which is not read; export it without", path, codec));
    }
  }
  if (view.byteOffset > buffer.size() || view.byteLength > buffer.size() - view.byteOffset) {
    refuse(fmt::format("cannot be read as a mesh (buffer view {} goes beyond the {} bytes of its buffer)", number,
                       buffer.size()));
  }
  return buffer.substr(view.byteOffset, view.byteLength);
}

void File::remark(const std::string& sentence) {
  std::vector<std::string>& all = document.remarks;
  if (std::find(all.begin(), all.end(), sentence) == all.end()) all.push_back(sentence);
}

}  // namespace halfspace::ref::gltf
