// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_SCENE_GLTF_FILE_ACCESSOR_HPP_
#define HALFSPACE_REF_SCENE_GLTF_FILE_ACCESSOR_HPP_

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

#include "ref/scene/gltf/file/file.hpp"

namespace halfspace::ref::gltf {

// The numbers of an accessor, by element: normalized, and replaced where it is sparse; zeros where it has no buffer.
class Accessor {
 public:
  // `what`: of what it is, for sentences. `components`: those it may have, 16 of a 4×4 matrix. Error where it goes
  // beyond its view.
  Accessor(const File&, int number, const std::string& what, std::initializer_list<int> components);

  std::size_t count() const { return count_; }
  int components() const { return columns_ * rows_; }
  bool is_unsigned() const;  // whole numbers from 0 on
  // Error on NaN and infinity.
  double at(std::size_t element, int component = 0) const;
  std::vector<double> all() const;

  [[noreturn]] void refuse(const std::string& why) const;

 private:
  struct Values {  // one behind the other
    const std::uint8_t* first = nullptr;
    std::size_t stride = 0;
  };
  Values values_of(int view, std::size_t offset, std::size_t count, std::size_t size, std::size_t stride) const;
  void read_sparse(const tinygltf::Accessor&);
  double number(const std::uint8_t*) const;

  const File& file_;
  const int number_;
  const std::string what_;
  std::size_t count_ = 0;
  int type_ = 0, columns_ = 1, rows_ = 1;
  std::size_t size_ = 0, column_ = 0;  // bytes, of an element and of a column
  bool normalized_ = false;
  Values values_, replaced_;
  std::vector<std::uint32_t> places_;  // that are replaced, rising
};

}  // namespace halfspace::ref::gltf

#endif  // HALFSPACE_REF_SCENE_GLTF_FILE_ACCESSOR_HPP_
