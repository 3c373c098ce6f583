// SPDX-License-Identifier: Apache-2.0
#include "cli/plots/video.hpp"

#include <fmt/format.h>

#include <csignal>
#include <filesystem>
#include <optional>

#include "cli/common/shell.hpp"
#include "ref/error.hpp"
#include "vectors/staging.hpp"

namespace halfspace::cli {
namespace {

namespace fs = std::filesystem;

// "frame_%04d.png" as what stands before and after the number, and its digits; none without a number.
struct Numbered {
  std::string before, after;
  int digits;
};
std::optional<Numbered> numbered(const std::string& path) {
  const std::size_t begin = path.find('%'), end = path.find('d', begin);
  if (begin == std::string::npos) return std::nullopt;
  const std::string digits = end == std::string::npos ? "x" : path.substr(begin + 1, end - begin - 1);
  const bool plain = digits.find_first_not_of("0123456789") == std::string::npos && digits.size() <= 2;
  if (!plain || path.find('%', begin + 1) != std::string::npos) {
    throw ref::Error(
        fmt::format("{}: one number stands in the name of the pictures: write it like frame_%04d.png", path));
  }
  return Numbered{path.substr(0, begin), path.substr(end + 1), digits.empty() ? 1 : std::stoi(digits)};
}

void need_ffmpeg(const std::string& path) {
  if (!ffmpeg_is_installed()) {
    throw ref::Error(fmt::format(
        "{}: the program ffmpeg is not installed: install it, or write pictures like frame_%04d.png", path));
  }
}

std::string raw_input(int width, int height, int frames_a_second) {
  return fmt::format("ffmpeg -v error -f rawvideo -pix_fmt rgb24 -s {}x{} -r {} -i -", width, height, frames_a_second);
}

bool send(FILE* pipe, const Picture& picture) {
  return std::fwrite(picture.pixels.data(), 3, picture.pixels.size(), pipe) == picture.pixels.size();
}

// A program that ends early must not end this one with it.
FILE* open_pipe(const std::string& command) {
  std::signal(SIGPIPE, SIG_IGN);
  FILE* const pipe = popen(command.c_str(), "w");
  if (!pipe) throw ref::Error("ffmpeg cannot be started: free some memory");
  return pipe;
}

}  // namespace

bool ffmpeg_is_installed() { return is_installed("ffmpeg"); }

FrameWriter::FrameWriter(std::string path, int width, int height, int frames_a_second) : path_(std::move(path)) {
  const fs::path target(path_);
  staged_ = std::make_unique<model::StagedFolder>(target.parent_path().string());
  if (numbered(path_)) return;
  const std::string ending = target.extension().string();
  if (ending != ".mp4" && ending != ".mkv" && ending != ".webm" && ending != ".gif") {
    throw ref::Error(
        fmt::format("{}: neither a film (.mp4, .mkv, .webm, .gif) nor numbered pictures: write it like out.mp4 or "
                    "frame_%04d.png",
                    path_));
  }
  need_ffmpeg(path_);
  // Films of 4:2:0 have even sides.
  const std::string format = ending == ".gif" ? "" : " -vf 'pad=ceil(iw/2)*2:ceil(ih/2)*2' -pix_fmt yuv420p -crf 12";
  film_ = open_pipe(raw_input(width, height, frames_a_second) + format + " -y " +
                    shell_quoted(staged_->path(target.filename().string())));
}

FrameWriter::~FrameWriter() {
  if (film_) pclose(film_);
}

void FrameWriter::write(const Picture& picture) {
  if (film_) {
    if (!send(film_, picture))
      throw ref::Error(fmt::format("{}: ffmpeg does not take the pictures: its own message says why", path_));
  } else {
    const Numbered name = *numbered(fs::path(path_).filename().string());
    write_picture(staged_->path(fmt::format("{}{:0{}d}{}", name.before, frames_, name.digits, name.after)), picture);
  }
  ++frames_;
}

void FrameWriter::finish() {
  if (film_) {
    const int status = pclose(film_);
    film_ = nullptr;
    if (status != 0) throw ref::Error(fmt::format("{}: ffmpeg did not write it: its own message says why", path_));
  }
  staged_->commit();
}

std::vector<Picture> interpolated_by_ffmpeg(const std::vector<Picture>& keys, int factor) {
  need_ffmpeg("minterpolate");
  const int width = keys.at(0).width, height = keys[0].height, rate = 6;
  model::StagedFolder folder((fs::temp_directory_path() / "halfspace").string());  // never committed
  const std::string out = folder.path("between.rgb");
  FILE* const pipe =
      open_pipe(raw_input(width, height, rate) +
                fmt::format(" -vf minterpolate=fps={}:mi_mode=mci:mc_mode=aobmc:me_mode=bidir:vsbmc=1:scd=none"
                            " -f rawvideo -pix_fmt rgb24 -y {}",
                            rate * factor, shell_quoted(out)));
  bool sent = true;
  for (const Picture& key : keys) sent = sent && send(pipe, key);
  if (pclose(pipe) != 0 || !sent)
    throw ref::Error("minterpolate: ffmpeg did not take the pictures: its own message says why");

  std::vector<Picture> pictures;
  FILE* const file = std::fopen(out.c_str(), "rb");
  if (!file) throw ref::Error("minterpolate: ffmpeg wrote no pictures: its own message says why");
  for (;;) {
    Picture picture{width, height, std::vector<std::array<std::uint8_t, 3>>(std::size_t(width) * height)};
    if (std::fread(picture.pixels.data(), 3, picture.pixels.size(), file) != picture.pixels.size()) break;
    pictures.push_back(std::move(picture));
  }
  std::fclose(file);
  return pictures;
}

}  // namespace halfspace::cli
