// SPDX-License-Identifier: Apache-2.0
#include "vectors/dump.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
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

bool is_dump(const std::string& folder) { return fs::exists(fs::path(folder) / "index.u32"); }

std::vector<Difference> compare_dumps(const std::string& a, const std::string& b) {
  const fs::path left(a), right(b);
  const Size size = dump_size(left), other = dump_size(right);
  if (size.width != other.width || size.height != other.height) {
    throw ref::Error(fmt::format("{} has {}x{} pixels and {} has {}x{}: give two dumps of one size", a, size.width,
                                 size.height, b, other.width, other.height));
  }
  return {compare_buffers<std::uint32_t>(left, right, "index.u32", size, 1),
          compare_buffers<std::uint32_t>(left, right, "depth.u32", size, 1),
          compare_buffers<std::uint8_t>(left, right, "colour.rgba8", size, 4)};
}

}  // namespace halfspace::model
