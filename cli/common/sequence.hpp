// SPDX-License-Identifier: Apache-2.0
// Frame-rate up-conversion of an animation: key frames, and what is made between them.
#ifndef HALFSPACE_CLI_COMMON_SEQUENCE_HPP_
#define HALFSPACE_CLI_COMMON_SEQUENCE_HPP_

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/common/scene_input.hpp"
#include "model/formats/configuration.hpp"
#include "ref/motion/up_convert.hpp"

namespace halfspace::cli {

constexpr int kFramesASecond = 30;

struct SequenceOptions {
  ref::SceneChoice choice;
  std::string scene, engine = "hls", config, motion, size = "320x240", keys = "1:4";
  std::string filter, mapping, method = "exact", texture = "none", shading = "gouraud";
  std::string key_faces = ref::name_of(ref::UpConversion{}.key_faces);
  int samples = 1, key_scale = 1;
  int first = 0, frames = 0;  // frames 0: to the end of the animation
  bool relight = true, half = false, index_test = true, surfaces = false;
  bool render_holes = true;    // of the reference; else what no key shows is taken untested
  bool pixel_vectors = false;  // of the reference, with samples: a vector a pixel, all the same
  bool static_buffer = false;
  bool foresee = false;
  bool held_planes = false;    // depth planes of all frames together, as with static_buffer, so that both draw the same
  double psnr = 45;            // of --keys auto
  double zoom = 1, speed = 1;  // how large the scene is in the frame, and how fast its time goes by
  std::vector<std::string> set;  // "weight_bits=4": of the motion's configuration
};

void add_sequence_options(CLI::App* command, SequenceOptions& options);

// What frames in between take of the kernels.
struct Work {
  std::size_t triangles = 0, static_triangles = 0;  // handed to the pipeline for the field, and for the S-buffer
  std::size_t words = 0, tiles = 0, cycles = 0;     // of motion; of keys, that the caches fetch; of the compensation
  std::size_t second_words = 0;                     // that go to the second faces of key pixels as well
};
void add(Work& sum, const Work& work);

// A frame between keys, or a key.
struct SequenceFrame {
  std::optional<double> foreseen;  // PSNR_Y, where it was asked for or decides, and can be foreseen
  int number = 0;                  // of the sequence, from 0 on
  bool is_key = false;
  ref::Colours shown;            // compensated; a key as it is drawn
  ref::Colours rendered;         // without up-conversion
  ref::Colours average, repeat;  // of the keys; empty of a key
  std::vector<bool> of_keys;     // pixels that are made of keys alone
  ref::Shares shares;
  Work work;
};

void add(ref::Shares& sum, const ref::Shares& shares);

// What a sequence was made of.
struct Sequence {
  int width, height, frames;
  std::vector<int> keys;       // their numbers
  std::string colour, motion;  // configurations, of kernels
  int tile_bytes = 0;          // of a key frame, likewise
};

// Tells of each frame in order. begin() comes before them, and again before the first where the sequence is drawn anew:
// where no configuration is named, a frame that does not fit `middle` has all of them drawn with `high`. Progress on
// standard error. Throws ref::Error.
Sequence run_sequence(const SequenceOptions& options, const std::function<void()>& begin,
                      const std::function<void(const SequenceFrame&)>& sink);

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_COMMON_SEQUENCE_HPP_
