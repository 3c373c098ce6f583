// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/gltf/file/accessor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace halfspace::ref::gltf {
namespace {

constexpr std::size_t kMostWithoutBuffer = std::size_t(1) << 24;  // elements, which no byte of the file bears out

std::size_t bytes_of(int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT: return 4;
    default: return 0;
  }
}

std::pair<int, int> columns_and_rows(int type) {
  switch (type) {
    case TINYGLTF_TYPE_VEC2: return {1, 2};
    case TINYGLTF_TYPE_VEC3: return {1, 3};
    case TINYGLTF_TYPE_VEC4: return {1, 4};
    case TINYGLTF_TYPE_MAT2: return {2, 2};
    case TINYGLTF_TYPE_MAT3: return {3, 3};
    case TINYGLTF_TYPE_MAT4: return {4, 4};
    default: return {1, 1};
  }
}

template <class Number>
double plain(const std::uint8_t* bytes) {
  Number number;
  std::memcpy(&number, bytes, sizeof number);
  return double(number);
}

std::uint32_t place(int type, const std::uint8_t* bytes) {
  if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return *bytes;
  if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) return std::uint32_t(plain<std::uint16_t>(bytes));
  return std::uint32_t(plain<std::uint32_t>(bytes));
}

bool is_unsigned_type(int type) {
  return type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
         type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

}  // namespace

Accessor::Accessor(const File& file, int number, const std::string& what, std::initializer_list<int> components)
    : file_(file), number_(number), what_(what) {
  const tinygltf::Accessor& source = file.model.accessors[std::size_t(number)];
  count_ = source.count, type_ = source.componentType, normalized_ = source.normalized;
  std::tie(columns_, rows_) = columns_and_rows(source.type);
  const std::size_t bytes = bytes_of(type_);
  if (bytes == 0) refuse(fmt::format("has the component type {}", type_));
  if (std::find(components.begin(), components.end(), columns_ * rows_) == components.end()) {
    refuse(fmt::format("has {} numbers an element", columns_ * rows_));
  }
  // Columns of a matrix begin at a multiple of four bytes.
  column_ = std::size_t(rows_) * bytes;
  if (columns_ > 1) column_ = (column_ + 3) / 4 * 4;
  size_ = std::size_t(columns_) * column_;
  if (file.has_view(number)) {
    const std::size_t stride = file.model.bufferViews[std::size_t(source.bufferView)].byteStride;
    if (stride != 0 && stride < size_) refuse(fmt::format("has elements of {} bytes every {}", size_, stride));
    values_ = values_of(source.bufferView, source.byteOffset, count_, size_, stride == 0 ? size_ : stride);
  } else if (count_ > kMostWithoutBuffer) {
    refuse(fmt::format("has {} elements without a buffer, and {} are read", count_, kMostWithoutBuffer));
  }
  if (source.sparse.isSparse) read_sparse(source);
}

void Accessor::refuse(const std::string& why) const {
  file_.refuse(fmt::format("cannot be read as a mesh (accessor {}, {}, {})", number_, what_, why));
}

Accessor::Values Accessor::values_of(int view, std::size_t offset, std::size_t count, std::size_t size,
                                     std::size_t stride) const {
  const std::string_view bytes = file_.view(view);
  if (offset > bytes.size() || size > bytes.size() - offset || (count - 1) > (bytes.size() - offset - size) / stride) {
    refuse(fmt::format("has {} elements, which its buffer view does not hold", count));
  }
  return {reinterpret_cast<const std::uint8_t*>(bytes.data()) + offset, stride};
}

void Accessor::read_sparse(const tinygltf::Accessor& source) {
  const auto& sparse = source.sparse;
  const std::size_t many = std::size_t(sparse.count), bytes = bytes_of(sparse.indices.componentType);
  if (!is_unsigned_type(sparse.indices.componentType)) refuse("has sparse indices that are not unsigned");
  if (many > count_) refuse("replaces more elements than it has");
  const Values at = values_of(sparse.indices.bufferView, std::size_t(sparse.indices.byteOffset), many, bytes, bytes);
  replaced_ = values_of(sparse.values.bufferView, std::size_t(sparse.values.byteOffset), many, size_, size_);
  places_.reserve(many);
  for (std::size_t i = 0; i < many; ++i) {
    const std::uint32_t here = place(sparse.indices.componentType, at.first + i * at.stride);
    if (here >= count_) refuse(fmt::format("replaces element {}, and has {}", here, count_));
    if (i != 0 && here <= places_.back()) refuse("has sparse indices that do not rise");
    places_.push_back(here);
  }
}

bool Accessor::is_unsigned() const { return is_unsigned_type(type_) && !normalized_; }

double Accessor::number(const std::uint8_t* bytes) const {
  switch (type_) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return normalized_ ? std::max(plain<std::int8_t>(bytes) / 127, -1.0) : plain<std::int8_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return *bytes / (normalized_ ? 255.0 : 1.0);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return normalized_ ? std::max(plain<std::int16_t>(bytes) / 32767, -1.0) : plain<std::int16_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return plain<std::uint16_t>(bytes) / (normalized_ ? 65535.0 : 1.0);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: return plain<std::uint32_t>(bytes) / (normalized_ ? 4294967295.0 : 1.0);
    default: return plain<float>(bytes);
  }
}

double Accessor::at(std::size_t element, int component) const {
  Values values = values_;
  if (!places_.empty()) {
    const auto found = std::lower_bound(places_.begin(), places_.end(), element);
    if (found != places_.end() && *found == element) {
      values = replaced_;
      element = std::size_t(found - places_.begin());
    }
  }
  if (!values.first) return 0;
  const std::size_t column = std::size_t(component / rows_), row = std::size_t(component % rows_);
  const double value = number(values.first + element * values.stride + column * column_ + row * (bytes_of(type_)));
  if (!std::isfinite(value)) refuse(fmt::format("has NaN or infinity as element {}", element));
  return value;
}

std::vector<double> Accessor::all() const {
  std::vector<double> numbers;
  numbers.reserve(count_ * std::size_t(components()));
  for (std::size_t i = 0; i < count_; ++i) {
    for (int c = 0; c < components(); ++c) numbers.push_back(at(i, c));
  }
  return numbers;
}

}  // namespace halfspace::ref::gltf
