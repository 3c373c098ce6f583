// SPDX-License-Identifier: Apache-2.0
// How good frames between key frames are, beside what needs no motion and what finds motion in pictures.
#ifndef HALFSPACE_CLI_PLOTS_SEQUENCE_QUALITY_HPP_
#define HALFSPACE_CLI_PLOTS_SEQUENCE_QUALITY_HPP_

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "cli/common/sequence.hpp"
#include "ref/motion/quality.hpp"

namespace halfspace::cli {

// Means over the frames in between, against these as rendered.
struct SequenceQuality {
  Sequence sequence;
  int between = 0;
  ref::Quality compensated, average, repeat;
  std::optional<double> alone;  // PSNR_Y of the pixels that are made of keys alone, of frames that have such
  std::optional<ref::Quality> minterpolate;
  std::string no_minterpolate;  // why there is none, if it was asked for
  ref::Shares shares;           // of pixels of the field, all frames
  Work work;
  // Of the picture's pixels that are covered, those that have a sample that no key shows.
  double rendered_share() const { return shares.pixels ? double(shares.rendered) / double(shares.pixels) : 0; }
  std::vector<std::array<double, ref::kBlockClasses>> blocks;  // of each frame in between
  std::vector<std::array<double, ref::kBlockClasses>> average_blocks;
};

SequenceQuality measure_sequence(const SequenceOptions& options, bool with_minterpolate);

Json to_json(const Work& work, int tile_bytes);
Json to_json(const SequenceQuality& quality);
// Shares of blocks a frame, stacked: of the temporal average above, compensated below.
void plot_blocks(const SequenceQuality& quality, const std::string& title, const std::string& picture);

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_PLOTS_SEQUENCE_QUALITY_HPP_
