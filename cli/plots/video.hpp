// SPDX-License-Identifier: Apache-2.0
// Sequences of pictures: numbered files, or a film through the program ffmpeg.
#ifndef HALFSPACE_CLI_PLOTS_VIDEO_HPP_
#define HALFSPACE_CLI_PLOTS_VIDEO_HPP_

#include <memory>
#include <string>
#include <vector>

#include "cli/common/program.hpp"
#include "cli/plots/picture.hpp"
#include "vectors/staging.hpp"

namespace halfspace::cli {

bool ffmpeg_is_installed();

// Whole or not at all: nothing is in its place before finish(). Throws ref::Error.
class FrameWriter {
 public:
  // `path` has one %d or %04d for the number of a picture, from 0 on, or ends as ffmpeg knows films: .mp4, .mkv, .webm,
  // .gif. A device or pipe without an ending gets Matroska.
  FrameWriter(std::string path, int width, int height, int frames_a_second);
  ~FrameWriter();

  void write(const Picture&);
  void finish();

 private:
  void end_film(bool taken);

  std::string path_;
  std::unique_ptr<model::StagedFiles> staged_ = std::make_unique<model::StagedFiles>();
  std::unique_ptr<FedProgram> film_;  // ffmpeg
  int frames_ = 0;
};

// What ffmpeg's filter minterpolate puts between pictures that are `factor` frames apart: the frames from the first of
// `keys` to the last, as many as it gives. Its motion comes from the pictures alone. Throws ref::Error.
std::vector<Picture> interpolated_by_ffmpeg(const std::vector<Picture>& keys, int factor);

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_PLOTS_VIDEO_HPP_
