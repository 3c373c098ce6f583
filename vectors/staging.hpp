// SPDX-License-Identifier: Apache-2.0
// Everything that the program writes goes through here, and appears whole or not at all.
#ifndef HALFSPACE_VECTORS_STAGING_HPP_
#define HALFSPACE_VECTORS_STAGING_HPP_

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "vectors/unfinished.hpp"

namespace halfspace::model {

// "-" and the names that a system has for it.
bool is_standard_output(const std::string& path);
// From now on what is printed goes to standard error, and standard output has the files of that name alone.
void give_standard_output_to_files();

// Throws ref::Error where make_folder() would, as far as that can be seen.
void check_folder(const std::string& folder);
// Makes the folder if its parent is there and is not the root of the disk; a folder that is there stays as it is.
// Returns whether it was made. Throws ref::Error.
bool make_folder(const std::string& folder);

// A file that is written under another name beside its target, which it takes in commit(); without it nothing is left.
// Of a link the target is written. A device, a pipe and standard output are written to, in commit(), and not replaced.
class StagedFile {
 public:
  // Throws ref::Error when nothing can be written there: there is no such folder, or it is one.
  explicit StagedFile(const std::string& path);
  ~StagedFile();
  StagedFile(const StagedFile&) = delete;
  StagedFile& operator=(const StagedFile&) = delete;

  // Where to write now, for what writes files itself. Has the ending of the target.
  std::string path();
  // A device, a pipe or an open descriptor.
  bool is_stream() const { return is_stream_; }
  void write(const std::string& bytes);
  void commit();

 private:
  void commit_stream();

  std::string name_, target_, part_;  // as given; what it stands for; where it is now, if anywhere
  std::string held_;                  // of a stream, what was given to write()
  int descriptor_ = -1;               // one that is open, if that is named
  std::optional<Unfinished> unfinished_;
  bool is_stream_ = false;
};

// Several, which appear when all are whole.
class StagedFiles {
 public:
  StagedFile& file(const std::string& path);
  void commit();

 private:
  std::vector<std::pair<std::string, std::unique_ptr<StagedFile>>> files_;
};

// Those of a folder, which is made if need be.
class StagedFolder {
 public:
  // Throws ref::Error when the folder cannot be written to.
  explicit StagedFolder(const std::string& folder);
  ~StagedFolder();
  StagedFolder(const StagedFolder&) = delete;
  StagedFolder& operator=(const StagedFolder&) = delete;

  // Where to write file `name` of the folder now.
  std::string path(const std::string& name) { return file(name).path(); }
  void write(const std::string& name, const std::string& bytes) { file(name).write(bytes); }
  void commit() { files_->commit(); }

 private:
  StagedFile& file(const std::string& name);

  std::string folder_;
  bool made_ = false;
  std::unique_ptr<StagedFiles> files_ = std::make_unique<StagedFiles>();
};

// One file, likewise.
void write_file(const std::string& path, const std::string& bytes);

}  // namespace halfspace::model

#endif  // HALFSPACE_VECTORS_STAGING_HPP_
