// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/assimp/file_system.hpp"

#include <assimp/MemoryIOWrapper.h>
#include <fmt/format.h>

#include <cstring>
#include <fstream>
#include <memory>
#include <utility>

#include "ref/error.hpp"

namespace halfspace::ref {
namespace {

constexpr char kMark[] = "\xEF\xBB\xBF";
constexpr std::size_t kMarkSize = 3;

// A file behind its mark.
class Marked : public Assimp::IOStream {
 public:
  explicit Marked(std::unique_ptr<Assimp::IOStream> file) : file_(std::move(file)) {}
  std::size_t Read(void* to, std::size_t size, std::size_t count) override { return file_->Read(to, size, count); }
  std::size_t Write(const void*, std::size_t, std::size_t) override { return 0; }
  aiReturn Seek(std::size_t offset, aiOrigin origin) override {
    return file_->Seek(origin == aiOrigin_SET ? offset + kMarkSize : offset, origin);
  }
  std::size_t Tell() const override { return file_->Tell() - kMarkSize; }
  std::size_t FileSize() const override { return file_->FileSize() - kMarkSize; }
  void Flush() override {}

 private:
  std::unique_ptr<Assimp::IOStream> file_;
};

}  // namespace

void FileSystem::replace(const std::string& path, std::string text) {
  replaced_ = path;
  text_ = std::move(text);
}

Assimp::IOStream* FileSystem::Open(const char* path, const char* mode) {
  if (!replaced_.empty() && path == replaced_) {
    return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(text_.data()), text_.size());
  }
  std::unique_ptr<Assimp::IOStream> file(DefaultIOSystem::Open(path, mode));
  (file ? opened_ : missing_).emplace_back(path);
  if (!file || std::strchr(mode, 'w')) return file.release();
  char start[kMarkSize] = {};
  const bool is_marked = file->Read(start, 1, kMarkSize) == kMarkSize && std::memcmp(start, kMark, kMarkSize) == 0;
  if (is_marked) return new Marked(std::move(file));
  file->Seek(0, aiOrigin_SET);
  return file.release();
}

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) throw Error(fmt::format("{}: cannot be read; check the file", path));
  std::string text(std::size_t(file.tellg()), '\0');
  file.seekg(0);
  file.read(text.data(), std::streamsize(text.size()));
  if (!file) throw Error(fmt::format("{}: cannot be read; check the file", path));
  if (text.compare(0, kMarkSize, kMark) == 0) text.erase(0, kMarkSize);
  return text;
}

}  // namespace halfspace::ref
