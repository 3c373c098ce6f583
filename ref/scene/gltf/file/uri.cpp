// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/gltf/file/uri.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>

#include "ref/scene/gltf/file/file.hpp"

namespace halfspace::ref::gltf {
namespace {

namespace fs = std::filesystem;

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

std::string without_per_cent(const std::string& uri) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool is_code =
        uri[i] == '%' && i + 2 < uri.size() && hex_digit(uri[i + 1]) >= 0 && hex_digit(uri[i + 2]) >= 0;
    text += is_code ? char(hex_digit(uri[i + 1]) << 4 | hex_digit(uri[i + 2])) : uri[i];
    if (is_code) i += 2;
  }
  return text;
}

constexpr std::array<std::int8_t, 256> digits() {
  std::array<std::int8_t, 256> of{};
  for (auto& digit : of) digit = -1;
  for (int i = 0; i < 26; ++i)
    of[std::size_t('A' + i)] = std::int8_t(i), of[std::size_t('a' + i)] = std::int8_t(26 + i);
  for (int i = 0; i < 10; ++i) of[std::size_t('0' + i)] = std::int8_t(52 + i);
  of['+'] = of['-'] = 62, of['/'] = of['_'] = 63;
  return of;
}

// Without the padding; false on what is no digit.
bool decode(std::string_view base64, std::string* bytes) {
  static constexpr std::array<std::int8_t, 256> kDigits = digits();
  while (!base64.empty() && base64.back() == '=') base64.remove_suffix(1);
  bytes->reserve(base64.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int held = 0;
  for (const char c : base64) {
    const int digit = kDigits[std::uint8_t(c)];
    if (digit < 0) return false;
    bits = bits << 6 | std::uint32_t(digit), held += 6;
    if (held < 8) continue;
    held -= 8;
    *bytes += char(bits >> held & 0xFF);
  }
  return true;
}

}  // namespace

std::optional<std::string> data_of(const std::string& scene, const std::string& uri) {
  if (uri.compare(0, 5, "data:") != 0) return std::nullopt;
  const std::size_t comma = uri.find(',');
  if (comma == uri.npos) refuse(scene, "has a data URI without data");
  const bool is_base64 = comma >= 7 && uri.compare(comma - 7, 7, ";base64") == 0;
  if (!is_base64) return without_per_cent(uri.substr(comma + 1));
  std::string bytes;
  if (!decode(std::string_view(uri).substr(comma + 1), &bytes)) refuse(scene, "has a data URI that is not base64");
  return bytes;
}

std::string file_of(const std::string& scene, const std::string& uri) {
  const fs::path folder = fs::path(scene).parent_path();
  for (std::string name : {without_per_cent(uri), uri}) {
    std::replace(name.begin(), name.end(), '\\', '/');
    if (name.find('\0') != name.npos) continue;
    for (const fs::path& candidate : {folder / name, folder / fs::path(name).filename()}) {
      std::error_code error;
      if (fs::is_regular_file(candidate, error)) return candidate.string();
    }
  }
  return {};
}

std::string shown(const std::string& uri) {
  constexpr std::size_t kLongest = 80;
  return uri.size() > kLongest ? name_of(uri.substr(0, kLongest)) + "..." : name_of(uri);
}

}  // namespace halfspace::ref::gltf
