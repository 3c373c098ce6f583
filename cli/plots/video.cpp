// SPDX-License-Identifier: Apache-2.0
#include "cli/plots/video.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <optional>
#include <utility>

#include "cli/common/program.hpp"
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

// Of ffmpeg: raw pictures in; a write that fails is its end.
std::vector<std::string> command(int width, int height, int frames_a_second) {
  return {"ffmpeg",   "-v",
          "error",    "-xerror",
          "-f",       "rawvideo",
          "-pix_fmt", "rgb24",
          "-s",       fmt::format("{}x{}", width, height),
          "-r",       std::to_string(frames_a_second),
          "-i",       "-"};
}

void append(std::vector<std::string>& words, std::initializer_list<std::string> more) {
  words.insert(words.end(), more);
}

bool send(FedProgram& ffmpeg, const Picture& picture) {
  return ffmpeg.feed(picture.pixels.data(), 3 * picture.pixels.size());
}

// Its status does not tell of all that it could not write.
bool is_whole(const ProgramEnd& end) { return end.status == 0 && end.said.find("rror ") == std::string::npos; }

}  // namespace

bool ffmpeg_is_installed() { return is_installed("ffmpeg"); }

FrameWriter::FrameWriter(std::string path, int width, int height, int frames_a_second) : path_(std::move(path)) {
  if (numbered(path_)) return;
  model::StagedFile& file = staged_->file(path_);
  std::string ending = fs::path(path_).extension().string();
  if (ending.empty() && file.is_stream()) ending = ".mkv";
  if (ending != ".mp4" && ending != ".mkv" && ending != ".webm" && ending != ".gif") {
    throw ref::Error(
        fmt::format("{}: neither a film (.mp4, .mkv, .webm, .gif) nor numbered pictures: write it like out.mp4 or "
                    "frame_%04d.png",
                    path_));
  }
  need_ffmpeg(path_);
  std::vector<std::string> words = command(width, height, frames_a_second);
  // Films of 4:2:0 have even sides.
  if (ending != ".gif") append(words, {"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", "-crf", "12"});
  append(words, {"-f", ending == ".mkv" ? "matroska" : ending.substr(1), "-y", "file:" + file.path()});
  film_ = std::make_unique<FedProgram>(words);
}

FrameWriter::~FrameWriter() = default;

void FrameWriter::end_film(bool taken) {
  const ProgramEnd end = std::exchange(film_, nullptr)->end();
  if (!taken || !is_whole(end))
    throw ref::Error(fmt::format("{}: ffmpeg did not write it: {}", path_, in_short(end.said)));
}

void FrameWriter::write(const Picture& picture) {
  if (film_) {
    if (!send(*film_, picture)) end_film(false);
  } else {
    const Numbered name = *numbered(path_);
    const std::string path = fmt::format("{}{:0{}d}{}", name.before, frames_, name.digits, name.after);
    staged_->file(path).write(encoded(path, picture));
  }
  ++frames_;
}

void FrameWriter::finish() {
  if (film_) end_film(true);
  staged_->commit();
}

std::vector<Picture> interpolated_by_ffmpeg(const std::vector<Picture>& keys, int factor) {
  need_ffmpeg("minterpolate");
  const int width = keys.at(0).width, height = keys[0].height, rate = 6;
  model::StagedFile made((fs::temp_directory_path() / "halfspace_between.rgb").string());  // never committed
  std::vector<std::string> words = command(width, height, rate);
  append(words,
         {"-vf",
          fmt::format("minterpolate=fps={}:mi_mode=mci:mc_mode=aobmc:me_mode=bidir:vsbmc=1:scd=none", rate * factor),
          "-f", "rawvideo", "-pix_fmt", "rgb24", "-y", "file:" + made.path()});
  FedProgram ffmpeg(words);
  bool sent = true;
  for (const Picture& key : keys) sent = sent && send(ffmpeg, key);
  const ProgramEnd end = ffmpeg.end();
  if (!is_whole(end) || !sent) throw ref::Error("minterpolate: ffmpeg does not do it: " + in_short(end.said));

  std::vector<Picture> pictures;
  FILE* const file = std::fopen(made.path().c_str(), "rb");
  if (!file) throw ref::Error("minterpolate: ffmpeg wrote no pictures");
  for (;;) {
    Picture picture{width, height, std::vector<std::array<std::uint8_t, 3>>(std::size_t(width) * height)};
    if (std::fread(picture.pixels.data(), 3, picture.pixels.size(), file) != picture.pixels.size()) break;
    pictures.push_back(std::move(picture));
  }
  std::fclose(file);
  return pictures;
}

}  // namespace halfspace::cli
