// SPDX-License-Identifier: Apache-2.0
// A glTF file as it stands, checked, and what its parts are read to.
#ifndef HALFSPACE_REF_SCENE_GLTF_FILE_FILE_HPP_
#define HALFSPACE_REF_SCENE_GLTF_FILE_FILE_HPP_

#include <deque>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "ref/error.hpp"
#include "ref/scene/document.hpp"
#include "ref/scene/gltf/file/container.hpp"
#include "ref/scene/gltf/file/tinygltf.hpp"

namespace halfspace::ref::gltf {

// Error("PATH: what; export the file again").
[[noreturn]] void refuse(const std::string& path, const std::string& what);

// By its URI, or in a buffer view.
struct Picture {
  std::string uri;
  int view = -1;
};

class File {
 public:
  File(const std::string& path, const ReadChoice& choice);

  [[noreturn]] void refuse(const std::string& what) const { gltf::refuse(path, what); }
  // The bytes of a buffer view, from its buffer.
  std::string_view view(int number) const;
  // Of an accessor.
  bool has_view(int accessor) const { return model.accessors[std::size_t(accessor)].bufferView != no_view_; }
  // Said once.
  void remark(const std::string& sentence);

  const std::string path;
  const ReadChoice choice;
  tinygltf::Model model;  // all but buffers and images
  std::vector<Picture> pictures;
  Document document;

 private:
  void add_buffer(nlohmann::json* buffer);
  void add_picture(nlohmann::json* image);

  int no_view_ = -1;  // that accessors have which have none
  Container container_;
  std::deque<std::string> own_;  // of buffers that are not in the container
  std::vector<std::string_view> buffers_;
};

// The names of files as they are for people: without what would break a line.
std::string name_of(const std::string&);

}  // namespace halfspace::ref::gltf

#endif  // HALFSPACE_REF_SCENE_GLTF_FILE_FILE_HPP_
