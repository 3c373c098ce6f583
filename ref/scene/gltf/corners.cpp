// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/gltf/corners.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace halfspace::ref::gltf {
namespace {

constexpr std::size_t kMostCorners = std::size_t(1) << 27;

std::vector<std::uint32_t> indices_of(const File& file, const tinygltf::Primitive& primitive, std::size_t count) {
  std::vector<std::uint32_t> indices;
  if (primitive.indices < 0) {
    indices.resize(count);
    std::iota(indices.begin(), indices.end(), 0u);
    return indices;
  }
  const Accessor accessor(file, primitive.indices, "indices", {1});
  if (!accessor.is_unsigned()) accessor.refuse("is not of unsigned numbers");
  if (accessor.count() > kMostCorners) accessor.refuse(fmt::format("has more than {} elements", kMostCorners));
  indices.reserve(accessor.count());
  for (std::size_t i = 0; i < accessor.count(); ++i) {
    const double index = accessor.at(i);
    if (!(index < double(count))) {
      accessor.refuse(fmt::format("has element {}, index {}, beyond {} vertices", i, index, count));
    }
    indices.push_back(std::uint32_t(index));
  }
  return indices;
}

// Numbers of indices, by the mode.
std::vector<std::array<std::uint32_t, 3>> triangles_of(int mode, std::size_t count) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  if (count < 3) return triangles;
  const std::size_t many = mode == TINYGLTF_MODE_TRIANGLES ? count / 3 : count - 2;
  triangles.reserve(many);
  for (std::uint32_t i = 0; i < many; ++i) {
    if (mode == TINYGLTF_MODE_TRIANGLES) triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    else if (mode == TINYGLTF_MODE_TRIANGLE_FAN) triangles.push_back({i + 1, i + 2, 0});
    else triangles.push_back({i, i + 1 + i % 2, i + 2 - i % 2});
  }
  return triangles;
}

}  // namespace

Corners corners_of(const File& file, const tinygltf::Primitive& primitive, std::size_t count) {
  std::vector<std::uint32_t> indices = indices_of(file, primitive, count);
  if (primitive.mode == TINYGLTF_MODE_TRIANGLES && indices.size() % 3 != 0) {
    file.refuse(fmt::format("cannot be read as a mesh ({} corners are no whole triangles)", indices.size()));
  }
  Corners corners;
  corners.vertices = indices;
  std::sort(corners.vertices.begin(), corners.vertices.end());
  corners.vertices.erase(std::unique(corners.vertices.begin(), corners.vertices.end()), corners.vertices.end());
  const bool all = corners.vertices.size() == count;
  for (std::uint32_t& index : indices) {
    if (all) break;
    const auto at = std::lower_bound(corners.vertices.begin(), corners.vertices.end(), index);
    index = std::uint32_t(at - corners.vertices.begin());
  }
  corners.triangles = triangles_of(primitive.mode, indices.size());
  for (auto& triangle : corners.triangles) {
    for (std::uint32_t& corner : triangle) corner = indices[corner];
  }
  return corners;
}

}  // namespace halfspace::ref::gltf
