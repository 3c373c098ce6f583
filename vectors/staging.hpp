// SPDX-License-Identifier: Apache-2.0
// Output that appears whole or not at all.
#ifndef HALFSPACE_VECTORS_STAGING_HPP_
#define HALFSPACE_VECTORS_STAGING_HPP_

#include <string>
#include <vector>

namespace halfspace::model {

// Files are written under other names and get their own in commit(); without it they are removed.
class StagedFolder {
 public:
  // Makes the folder if it is not there. Throws ref::Error when it cannot be written to.
  explicit StagedFolder(const std::string& folder);
  ~StagedFolder();
  StagedFolder(const StagedFolder&) = delete;
  StagedFolder& operator=(const StagedFolder&) = delete;

  // Where to write file `name` of the folder now.
  std::string path(const std::string& name);
  void write(const std::string& name, const std::string& bytes);
  void commit();

 private:
  std::string folder_;
  bool made_ = false;
  std::vector<std::string> names_;
};

// One file, likewise.
void write_file(const std::string& path, const std::string& bytes);

}  // namespace halfspace::model

#endif  // HALFSPACE_VECTORS_STAGING_HPP_
