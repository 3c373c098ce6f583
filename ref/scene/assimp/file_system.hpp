// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_SCENE_ASSIMP_FILE_SYSTEM_HPP_
#define HALFSPACE_REF_SCENE_ASSIMP_FILE_SYSTEM_HPP_

#include <assimp/DefaultIOSystem.h>

#include <string>
#include <vector>

namespace halfspace::ref {

// How Assimp reads files. Byte order marks are passed over, which its importers take for a part of the first word, and
// UTF-16 becomes UTF-8. What it opens, or would have opened, is kept.
class FileSystem : public Assimp::DefaultIOSystem {
 public:
  // That file reads as this text.
  void replace(const std::string& path, std::string text);

  Assimp::IOStream* Open(const char* path, const char* mode) override;

  const std::vector<std::string>& opened() const { return opened_; }
  const std::vector<std::string>& missing() const { return missing_; }

 private:
  std::string replaced_, text_;
  std::vector<std::string> opened_, missing_;
};

// What is in a file, in UTF-8 without a byte order mark. Error with the path.
std::string text_of(const std::string& path);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_SCENE_ASSIMP_FILE_SYSTEM_HPP_
