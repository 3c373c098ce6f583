// SPDX-License-Identifier: Apache-2.0
#include "vectors/staging.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "ref/error.hpp"

namespace halfspace::model {

namespace fs = std::filesystem;

StagedFolder::StagedFolder(const std::string& folder) : folder_(folder.empty() ? "." : folder) {
  std::error_code error;
  made_ = fs::create_directories(folder_, error);
  if (error || !fs::is_directory(folder_) || access(folder_.c_str(), W_OK) != 0) {
    throw ref::Error(fmt::format("{}: cannot write to this folder: name one that you may write to", folder_));
  }
}

StagedFolder::~StagedFolder() {
  std::error_code ignored;
  for (const std::string& name : names_) fs::remove(path(name), ignored);
  if (made_ && fs::is_empty(folder_, ignored)) fs::remove(folder_, ignored);
}

std::string StagedFolder::path(const std::string& name) {
  bool known = false;
  for (const std::string& other : names_) known = known || other == name;
  if (!known) names_.push_back(name);
  // The ending stays in place: image writers choose the format by it.
  return (fs::path(folder_) / fmt::format(".{}.part.{}", getpid(), name)).string();
}

void StagedFolder::write(const std::string& name, const std::string& bytes) {
  std::ofstream file(path(name), std::ios::binary);
  file << bytes;
  file.close();
  if (!file) {
    throw ref::Error(fmt::format("{}: cannot write it: is the disk full?", (fs::path(folder_) / name).string()));
  }
}

void StagedFolder::commit() {
  for (const std::string& name : names_) {
    std::error_code error;
    const fs::path target = fs::path(folder_) / name;
    if (fs::is_directory(target)) error = std::make_error_code(std::errc::is_a_directory);
    else fs::rename(path(name), target, error);
    if (error) throw ref::Error(fmt::format("{}: cannot write it: {}", target.string(), error.message()));
  }
  names_.clear();
}

void write_file(const std::string& path, const std::string& bytes) {
  const fs::path target(path);
  StagedFolder staged(target.parent_path().string());
  staged.write(target.filename().string(), bytes);
  staged.commit();
}

}  // namespace halfspace::model
