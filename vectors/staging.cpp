// SPDX-License-Identifier: Apache-2.0
#include "vectors/staging.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "ref/error.hpp"

namespace halfspace::model {
namespace {

namespace fs = std::filesystem;

int standard_output = STDOUT_FILENO;  // where files of that name go

[[noreturn]] void cannot_write(const std::string& name, int error) {
  const bool full = error == ENOSPC || error == EDQUOT, large = error == EFBIG;
  throw ref::Error(fmt::format("{}: cannot write it ({}): {}", name, std::strerror(error),
                               full    ? "free some space, or name a file on another disk"
                               : large ? "raise the limit (ulimit -f), or write less"
                                       : "name a file that you may write"));
}

// That the name stands for; −1 for none.
int descriptor_of(const std::string& path) {
  if (path == "-" || path == "/dev/stdout") return STDOUT_FILENO;
  if (path == "/dev/stderr") return STDERR_FILENO;
  for (const std::string folder : {"/dev/fd/", "/proc/self/fd/"}) {
    const std::string number = path.substr(0, folder.size()) == folder ? path.substr(folder.size()) : "";
    if (!number.empty() && number.size() < 6 && number.find_first_not_of("0123456789") == std::string::npos)
      return std::stoi(number);
  }
  return -1;
}

// All bytes, or false with errno.
bool put(int file, const char* bytes, std::size_t count) {
  while (count != 0) {
    const ssize_t done = ::write(file, bytes, count);
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) return false;
    bytes += done, count -= std::size_t(done);
  }
  return true;
}

// To the end of `from`, or false with errno.
bool copy(int from, int to) {
  std::vector<char> buffer(1 << 16);
  for (;;) {
    const ssize_t count = ::read(from, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return count == 0;
    if (!put(to, buffer.data(), std::size_t(count))) return false;
  }
}

// The last file of a chain of links, which need not be there.
fs::path behind_links(const fs::path& path) {
  fs::path at = path;
  std::error_code error;
  for (int n = 0; n < 40 && fs::is_symlink(at, error); ++n) {
    const fs::path next = fs::read_symlink(at, error);
    at = next.is_absolute() ? next : at.parent_path() / next;
  }
  return at;
}

// Of a file or folder.
fs::path parent_of(const fs::path& path) {
  const fs::path parent = path.parent_path();
  return parent.empty() ? "." : parent;
}

// Without "." and a slash at the end.
fs::path plain(const std::string& folder) {
  const fs::path path = fs::path(folder).lexically_normal();
  return path.has_filename() ? path : path.parent_path();
}

void need_folder(const std::string& name, const fs::path& folder, const char* what) {
  std::error_code error;
  if (fs::is_directory(folder, error)) return;
  throw ref::Error(
      fs::exists(folder, error)
          ? fmt::format("{}: {} is not a folder: name another {}", name, folder.string(), what)
          : fmt::format("{}: there is no folder {}: make it, or name another {}", name, folder.string(), what));
}

// No name twice: of one target, several may be on their way in several threads or programs.
std::string part_name(const fs::path& target) {
  static std::atomic<unsigned> count{0};
  // The ending stays in place: what writes films chooses the format by it.
  return fmt::format(".{}.{}.part.{}", getpid(), ++count, target.filename().string());
}

}  // namespace

bool is_standard_output(const std::string& path) { return descriptor_of(path) == STDOUT_FILENO; }

void give_standard_output_to_files() {
  if (standard_output != STDOUT_FILENO) return;
  const int kept = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3);
  if (kept < 0) return;
  std::fflush(stdout);
  standard_output = kept;
  dup2(STDERR_FILENO, STDOUT_FILENO);
}

void check_folder(const std::string& folder) {
  const fs::path path = plain(folder);
  std::error_code error;
  if (path.empty() || fs::is_directory(path, error)) return;
  if (fs::exists(path, error)) throw ref::Error(fmt::format("{}: it is a file: name a folder", folder));
  need_folder(folder, parent_of(path), "one");
  if (fs::equivalent(parent_of(path), "/", error))
    throw ref::Error(fmt::format(
        "{}: there is no such folder, and none is made at the root of the disk: make it, or name another", folder));
}

bool make_folder(const std::string& folder) {
  check_folder(folder);
  const fs::path path = plain(folder);
  std::error_code error;
  if (path.empty() || fs::is_directory(path, error)) return false;
  if (!fs::create_directory(path, error) && !fs::is_directory(path)) {
    throw ref::Error(
        fmt::format("{}: cannot make this folder ({}): name one that you may write to", folder, error.message()));
  }
  return true;
}

StagedFile::StagedFile(const std::string& path) : name_(path), target_(path), descriptor_(descriptor_of(path)) {
  if (descriptor_ == STDOUT_FILENO) name_ = "standard output", descriptor_ = standard_output;
  struct stat seen {};
  const bool is_there = stat(path.c_str(), &seen) == 0;
  is_stream_ = descriptor_ >= 0 || (is_there && !S_ISREG(seen.st_mode) && !S_ISDIR(seen.st_mode));
  if (is_stream_) return;
  const fs::path target = behind_links(path);
  target_ = target.string();
  need_folder(path, parent_of(target), "file");
  if ((is_there && S_ISDIR(seen.st_mode)) || !target.has_filename())
    throw ref::Error(fmt::format("{}: it is a folder: name a file", path));
  if (is_there && access(target_.c_str(), W_OK) != 0) cannot_write(path, errno);
  if (access(parent_of(target).c_str(), W_OK | X_OK) != 0) cannot_write(path, errno);
  part_ = (target.parent_path() / part_name(target)).string();
  unfinished_.emplace(part_);
}

StagedFile::~StagedFile() {
  if (!part_.empty()) unlink(part_.c_str());
}

std::string StagedFile::path() {
  if (part_.empty()) unfinished_.emplace(part_ = (fs::temp_directory_path() / part_name(target_)).string());
  return part_;
}

void StagedFile::write(const std::string& bytes) {
  if (is_stream_) {
    held_ += bytes;
    return;
  }
  const int file = open(part_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) cannot_write(name_, errno);
  const int failed = put(file, bytes.data(), bytes.size()) ? 0 : errno;
  if (close(file) != 0 || failed) cannot_write(name_, failed ? failed : errno);
}

void StagedFile::commit() {
  if (is_stream_) return commit_stream();
  struct stat old {};
  if (stat(target_.c_str(), &old) == 0) chmod(part_.c_str(), old.st_mode & 07777);
  if (rename(part_.c_str(), target_.c_str()) != 0) cannot_write(name_, errno);
  unfinished_.reset();
  part_.clear();
}

void StagedFile::commit_stream() {
  const bool is_open = descriptor_ >= 0;
  if (descriptor_ == STDOUT_FILENO) std::fflush(stdout);
  const int to = is_open ? descriptor_ : open(target_.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC);
  int failed = to >= 0 && put(to, held_.data(), held_.size()) ? 0 : errno;
  if (!failed && !part_.empty()) {
    const int from = open(part_.c_str(), O_RDONLY | O_CLOEXEC);
    if (from < 0 || !copy(from, to)) failed = errno;
    if (from >= 0) close(from);
  }
  if (to >= 0 && !is_open && close(to) != 0 && !failed) failed = errno;
  if (failed) cannot_write(name_, failed);
}

StagedFile& StagedFiles::file(const std::string& path) {
  for (auto& [name, file] : files_) {
    if (name == path) return *file;
  }
  files_.emplace_back(path, std::make_unique<StagedFile>(path));
  return *files_.back().second;
}

void StagedFiles::commit() {
  for (auto& [name, file] : files_) file->commit();
  files_.clear();
}

StagedFolder::StagedFolder(const std::string& folder) : folder_(folder.empty() ? "." : folder) {
  made_ = make_folder(folder_);
  if (access(folder_.c_str(), W_OK | X_OK) != 0) {
    throw ref::Error(fmt::format("{}: cannot write to this folder ({}): name one that you may write to", folder_,
                                 std::strerror(errno)));
  }
}

StagedFolder::~StagedFolder() {
  files_.reset();
  std::error_code ignored;
  if (made_ && fs::is_empty(folder_, ignored)) fs::remove(folder_, ignored);
}

StagedFile& StagedFolder::file(const std::string& name) { return files_->file((fs::path(folder_) / name).string()); }

void write_file(const std::string& path, const std::string& bytes) {
  StagedFile staged(path);
  staged.write(bytes);
  staged.commit();
}

}  // namespace halfspace::model
