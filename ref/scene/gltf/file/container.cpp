// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/gltf/file/container.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "ref/scene/gltf/file/file.hpp"
#include "ref/scene/gltf/read_gltf.hpp"
#include "ref/scene/input_file.hpp"

namespace halfspace::ref::gltf {
namespace {

constexpr std::size_t kMostBytes = std::size_t(1) << 32;  // GLB has no more
constexpr int kDeepest = 100;                             // of JSON; glTF itself needs a dozen
constexpr std::size_t kHeader = 12, kChunkHeader = 8;
constexpr std::uint32_t kJson = 0x4E4F534A, kBinary = 0x004E4942;

std::uint32_t word(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i) value = value << 8 | std::uint8_t(bytes[at + std::size_t(i)]);
  return value;
}

void check_depth(const std::string& path, std::string_view json) {
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (quoted) {
      if (c == '\\') ++i;
      else if (c == '"') quoted = false;
      continue;
    }
    if (c == '"') quoted = true;
    if (c == ']' || c == '}') --depth;
    if ((c == '[' || c == '{') && ++depth > kDeepest) {
      refuse(path, fmt::format("its JSON is nested more than {} deep", kDeepest));
    }
  }
}

void split(const std::string& path, Container* of) {
  const std::string_view all = of->bytes;
  if (all.size() < kHeader + kChunkHeader) refuse(path, "cannot be read as a mesh (GLB that is cut off)");
  const std::uint32_t version = word(all, 4), length = word(all, 8);
  if (version == 1) throw FirstGltf(fmt::format("{}: is of glTF 1; export it as glTF 2.0", path));
  if (version != 2) refuse(path, fmt::format("is GLB of version {}, and 2 is read", version));
  if (length > all.size()) {
    refuse(path, fmt::format("cannot be read as a mesh (GLB of {} bytes that is cut off at {})", length, all.size()));
  }
  int number = 0;
  for (std::size_t at = kHeader; at + kChunkHeader <= length; ++number) {
    const std::size_t size = word(all, at);
    const std::uint32_t type = word(all, at + 4);
    at += kChunkHeader;
    if (size > length - at) refuse(path, fmt::format("cannot be read as a mesh (chunk {} is cut off)", number));
    if (number == 0 && type == kJson) of->json = all.substr(at, size);
    if (number == 1 && type == kBinary) of->binary = all.substr(at, size), of->has_binary = true;
    at += size;
  }
  if (of->json.empty()) refuse(path, "cannot be read as a mesh (GLB whose first chunk is not JSON)");
}

}  // namespace

bool read_bytes(const std::string& path, std::size_t most, std::string* bytes) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) return false;
  std::ifstream file(path, std::ios::binary);
  bytes->resize(std::size_t(std::min<std::uintmax_t>(size, most)));
  return file && file.read(bytes->data(), std::streamsize(bytes->size()));
}

Container read_container(const std::string& path) {
  Container container;
  check_input_file(path);
  if (!read_bytes(path, kMostBytes, &container.bytes)) throw Error(path + ": cannot be read; check the file");
  if (container.bytes.compare(0, 4, "glTF") == 0) split(path, &container);
  else container.json = container.bytes;
  check_depth(path, container.json);
  return container;
}

}  // namespace halfspace::ref::gltf
