// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/assimp/file_system.hpp"

#include <assimp/MemoryIOWrapper.h>
#include <fmt/format.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <utility>

#include "ref/error.hpp"
#include "ref/scene/input_file.hpp"

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

void append_utf8(std::uint32_t code, std::string* text) {
  const auto more = [&](int shift) { *text += char(0x80 | (code >> shift & 0x3F)); };
  if (code < 0x80) {
    *text += char(code);
  } else if (code < 0x800) {
    *text += char(0xC0 | code >> 6), more(0);
  } else if (code < 0x10000) {
    *text += char(0xE0 | code >> 12), more(6), more(0);
  } else {
    *text += char(0xF0 | code >> 18), more(12), more(6), more(0);
  }
}

bool is_utf16(const std::string& start) {
  return start.compare(0, 2, "\xFF\xFE") == 0 || start.compare(0, 2, "\xFE\xFF") == 0;
}

// A text without its mark, in UTF-8.
std::string unmarked(std::string text) {
  if (text.compare(0, kMarkSize, kMark) == 0) return text.erase(0, kMarkSize);
  if (!is_utf16(text)) return text;
  const std::size_t high = text[0] == '\xFE' ? 0 : 1;
  const auto unit = [&](std::size_t at) {
    return std::uint32_t(std::uint8_t(text[at + high])) << 8 | std::uint8_t(text[at + 1 - high]);
  };
  std::string out;
  for (std::size_t at = 2; at + 1 < text.size(); at += 2) {
    std::uint32_t code = unit(at);
    const bool is_pair = code >= 0xD800 && code < 0xDC00 && at + 3 < text.size();
    if (is_pair) code = 0x10000 + ((code & 0x3FF) << 10 | (unit(at += 2) & 0x3FF));
    append_utf8(code, &out);
  }
  return out;
}

// The files of an OBJ's line of material libraries, which Assimp takes for one name, with the spaces behind it; none if
// one of them is not there.
std::vector<std::string> libraries_of(const std::string& path) {
  const std::size_t folder_end = path.find_last_of('/') + 1;
  const std::string folder = path.substr(0, folder_end);
  std::istringstream words(path.substr(folder_end));
  std::vector<std::string> files;
  for (std::string word; words >> word;) {
    std::error_code error;
    files.push_back(folder + word);
    if (extension_of(word) != "mtl" || !std::filesystem::is_regular_file(files.back(), error)) return {};
  }
  return files;
}

Assimp::IOStream* in_memory(const std::string& text) {
  auto* const bytes = new std::uint8_t[text.size()];  // the stream deletes them
  std::memcpy(bytes, text.data(), text.size());
  return new Assimp::MemoryIOStream(bytes, text.size(), true);
}

}  // namespace

void FileSystem::replace(const std::string& path, std::string text) {
  replaced_ = path;
  text_ = std::move(text);
}

Assimp::IOStream* FileSystem::Open(const char* path, const char* mode) {
  if (!replaced_.empty() && path == replaced_) {
    return in_memory(text_);
  }
  std::unique_ptr<Assimp::IOStream> file(DefaultIOSystem::Open(path, mode));
  if (!file) {
    const std::vector<std::string> parts = libraries_of(path);
    std::string text;
    for (const std::string& part : parts) text += text_of(part) + '\n';
    opened_.insert(opened_.end(), parts.begin(), parts.end());
    if (!parts.empty()) return in_memory(text);
  }
  (file ? opened_ : missing_).emplace_back(path);
  if (!file || std::strchr(mode, 'w')) return file.release();
  std::string start(kMarkSize, '\0');
  start.resize(file->Read(start.data(), 1, kMarkSize));
  if (start == kMark) return new Marked(std::move(file));
  file->Seek(0, aiOrigin_SET);
  if (is_utf16(start)) {
    std::string text(file->FileSize(), '\0');
    text.resize(file->Read(text.data(), 1, text.size()));
    return in_memory(unmarked(std::move(text)));
  }
  return file.release();
}

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) throw Error(fmt::format("{}: cannot be read; check the file", path));
  std::string text(std::size_t(file.tellg()), '\0');
  file.seekg(0);
  file.read(text.data(), std::streamsize(text.size()));
  if (!file) throw Error(fmt::format("{}: cannot be read; check the file", path));
  return unmarked(std::move(text));
}

}  // namespace halfspace::ref
