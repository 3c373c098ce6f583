// SPDX-License-Identifier: Apache-2.0
// motion_compensate as a driver sees it, for any configuration with motion: key frames, the motion of the pixels in
// between, and what becomes of these.
#ifndef HALFSPACE_MODEL_MOTION_COMPENSATION_HPP_
#define HALFSPACE_MODEL_MOTION_COMPENSATION_HPP_

#include <array>
#include <cstdint>
#include <vector>

#include "hls/formats/formats.hpp"
#include "model/formats/configuration.hpp"
#include "model/formats/layout.hpp"
#include "model/motion/motion_words.hpp"

namespace halfspace::model {

// Row by row. Colours of colour_bits; the face that a pixel shows and that they are of, 0: none.
struct KeyFrame {
  int width = 0, height = 0;
  std::vector<std::array<std::uint8_t, 3>> rgb;
  std::vector<std::uint32_t> face;
};

// A frame in between of width × height pixels: key frames have one for `samples` of them each way, rounded up.
struct CompensationInput {
  int width = 0, height = 0;
  std::array<const KeyFrame*, 2> key{};
  std::vector<RawMotion> motion;  // in any order
  int weight = 0;                 // of key 0, 0 … 2^weight_bits; key 1 has the rest
  bool by_tiles = true;           // words go by tiles of a key frame, which its cache likes; else as they come
};

struct CompensatedPixel {
  int x = 0, y = 0;
  std::array<std::uint8_t, 3> rgb{};
  int keys = 0;  // bit k: key k contributed; 0: a hole, or the background, and black
};

struct CompensatedFrame {
  std::vector<CompensatedPixel> pixels;  // a pixel a word, in the order of words
  std::array<std::size_t, 2> misses{};   // tiles that each key's cache fetched
  std::size_t fills = 0;   // of a word the larger number of the two, summed: the caches fill at the same time
  std::size_t cycles = 0;  // that hs_motion_compensate takes where nothing makes it wait
};

// Bits of a pixel of a key frame in its memory.
int key_pixel_bits(const Config& config);

class Compensator {
 public:
  // Throws ref::Error without motion.
  explicit Compensator(const Configuration& configuration);
  // `table` may differ from the one that follows from the configuration.
  Compensator(const Configuration& configuration, const FormatTable& table);

  CompensatedFrame run(const CompensationInput& input) const;
  // The words of its streams as well, in flow order.
  CompensatedFrame capture(const CompensationInput& input, std::vector<StreamWords>& streams) const;
  // Of those streams.
  std::vector<Layout> layouts() const;
  // Of the streams of a film besides those of its pipeline; none where the configuration makes no films.
  std::vector<Layout> film_layouts() const;

 private:
  Configuration configuration_;
  FormatTable table_;
};

// The order in which words are sent: by tiles of a key frame, row by row of tiles, and row by row inside.
void order_by_tiles(std::vector<RawMotion>& motion, const Config& config);

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_MOTION_COMPENSATION_HPP_
