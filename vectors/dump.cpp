// SPDX-License-Identifier: Apache-2.0
#include "vectors/dump.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "ref/error.hpp"
#include "ref/geometry/triangle_list.hpp"
#include "vectors/staging.hpp"

namespace halfspace::model {

namespace fs = std::filesystem;

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "dumps are little endian and are written as memory stands");

namespace {

template <class T>
std::string bytes_of(const std::vector<T>& values) {
  return std::string(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

std::string file_bytes(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  if (!file)
    throw ref::Error(fmt::format("{}: cannot read it: give a folder that halfspace has written", path.string()));
  return bytes.str();
}

struct Size {
  int width, height;
};
Size dump_size(const fs::path& folder) {
  const ref::TriangleList list = ref::read_tri((folder / "triangles.tri").string(), true);
  return {list.width, list.height};
}

// `channels` values of type T a pixel.
template <class T>
Difference compare_buffers(const fs::path& a, const fs::path& b, const char* file, Size size, int channels) {
  const std::string bytes[2] = {file_bytes(a / file), file_bytes(b / file)};
  const std::size_t count = std::size_t(size.width) * size.height * channels;
  for (int i = 0; i < 2; ++i) {
    if (bytes[i].size() != count * sizeof(T)) {
      throw ref::Error(fmt::format("{}: it has {} bytes and a frame of {}x{} has {}: dump the scene again",
                                   ((i ? b : a) / file).string(), bytes[i].size(), size.width, size.height,
                                   count * sizeof(T)));
    }
  }
  Difference result;
  result.part = file;
  result.values = count;
  std::vector<T> values[2];
  for (int i = 0; i < 2; ++i) {
    values[i].resize(count);
    std::memcpy(values[i].data(), bytes[i].data(), bytes[i].size());
  }
  for (std::size_t n = 0; n < count; ++n) {
    if (values[0][n] == values[1][n]) continue;
    const std::size_t pixel = n / channels;
    if (result.different++ == 0) {
      result.first = fmt::format("pixel ({}, {}){}: {} and {}", pixel % size.width, pixel / size.width,
                                 channels == 4 ? fmt::format(" {}", "rgba"[n % 4]) : "", values[0][n], values[1][n]);
    }
    result.largest = std::max<std::int64_t>(result.largest, std::llabs(std::int64_t(values[0][n]) - values[1][n]));
  }
  return result;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("//", 0) != 0 && !line.empty()) lines.push_back(line);
  }
  return lines;
}

nlohmann::json manifest_of(const fs::path& folder) {
  try {
    return nlohmann::json::parse(file_bytes(folder / "manifest.json"));
  } catch (const nlohmann::json::exception& error) {
    throw ref::Error(fmt::format("{}: not a manifest ({}): write the vectors again",
                                 (folder / "manifest.json").string(), error.what()));
  }
}

Difference compare_streams(const fs::path& a, const fs::path& b, const std::string& name) {
  const std::vector<std::string> words[2] = {lines_of(file_bytes(a / (name + ".hex"))),
                                             lines_of(file_bytes(b / (name + ".hex")))};
  Difference result;
  result.part = name;
  result.values = std::max(words[0].size(), words[1].size());
  for (std::size_t n = 0; n < result.values; ++n) {
    const std::string none = "no word";
    const std::string& left = n < words[0].size() ? words[0][n] : none;
    const std::string& right = n < words[1].size() ? words[1][n] : none;
    if (left != right && result.different++ == 0) result.first = fmt::format("word {}: {} and {}", n, left, right);
  }
  return result;
}

}  // namespace

void write_dump(const std::string& folder, const ref::SnappedList& scene, const ref::Frame& frame) {
  StagedFolder staged(folder);
  staged.write("index.u32", bytes_of(frame.index));
  staged.write("depth.u32", bytes_of(frame.depth));
  staged.write("colour.rgba8", bytes_of(frame.colour));
  std::ostringstream triangles;
  // Other tools read this file: a size and triangles, no line of ours for the background, and no flat shading but by
  // equal colours.
  ref::TriangleList list = ref::unsnap(scene);
  list.background = {0, 0, 0};
  if (scene.format.flat) {
    for (auto& t : list.triangles) {
      for (ref::Vertex& v : t) v.r = t[0].r, v.g = t[0].g, v.b = t[0].b;
    }
  }
  ref::write_tri(triangles, list);
  staged.write("triangles.tri", triangles.str());
  staged.commit();
}

std::vector<Difference> compare_folders(const std::string& a, const std::string& b) {
  const fs::path left(a), right(b);
  for (const fs::path& folder : {left, right}) {
    if (!fs::exists(folder / "index.u32") && !fs::exists(folder / "manifest.json")) {
      throw ref::Error(
          fmt::format("{}: neither a dump nor a vector set: give a folder that `halfspace render --dump` "
                      "or `halfspace vectors` has written",
                      folder.string()));
    }
  }
  const bool dumps = fs::exists(left / "index.u32");
  if (dumps != fs::exists(right / "index.u32")) {
    throw ref::Error(fmt::format("{} and {}: one is a dump and one a vector set: give two of a kind", a, b));
  }
  std::vector<Difference> result;
  if (dumps) {
    const Size size = dump_size(left), other = dump_size(right);
    if (size.width != other.width || size.height != other.height) {
      throw ref::Error(fmt::format("{} has {}x{} pixels and {} has {}x{}: give two dumps of one size", a, size.width,
                                   size.height, b, other.width, other.height));
    }
    result.push_back(compare_buffers<std::uint32_t>(left, right, "index.u32", size, 1));
    result.push_back(compare_buffers<std::uint32_t>(left, right, "depth.u32", size, 1));
    result.push_back(compare_buffers<std::uint8_t>(left, right, "colour.rgba8", size, 4));
    return result;
  }
  const nlohmann::json streams = manifest_of(left).value("streams", nlohmann::json::array());
  if (streams.size() != manifest_of(right).value("streams", nlohmann::json::array()).size()) {
    throw ref::Error(fmt::format("{} and {}: the sets have different streams: write both with one version", a, b));
  }
  for (const auto& stream : streams) result.push_back(compare_streams(left, right, stream.value("name", "")));
  return result;
}

}  // namespace halfspace::model
