// SPDX-License-Identifier: Apache-2.0
// The widths of frames between key frames: places, vectors, weights, sums; and of static objects.
#ifndef HALFSPACE_HLS_FORMATS_MOTION_FORMATS_HPP_
#define HALFSPACE_HLS_FORMATS_MOTION_FORMATS_HPP_

#include "hls/formats/format_table.hpp"

namespace halfspace {

// Pixels of a tile of a key frame, each way: what its cache fetches at once.
constexpr int kKeyTile = 8;

// The numbers of frames between key frames; without them no record carries one, and the types are idle.
constexpr FormatTable motion_formats(const Config& c, FormatTable t) {
  const int faces = has_motion(c) ? c.face_bits : 1;
  t.face = {faces, faces, false};  // 0: background
  // Where the places of a triangle in a key frame begin, in whole pixels, and log2 of how far they go at most:
  // positions.
  t.origin = {c.range_bits, c.range_bits, true};
  t.extent = {bits_for(c.range_bits), bits_for(c.range_bits), false};
  t.vector = {c.vector_range + 1 + c.vector_fraction, c.vector_range + 1, true};
  t.key_weight = {c.weight_bits + 1, 1, false};  // 0 … 1
  const int samples = has_motion(c) ? c.samples : 1, point = exact_log2(samples), w = c.weight_bits;
  const int tiles_x = (c.width + kKeyTile * samples - 1) / (kKeyTile * samples);
  const int tiles_y = (c.height + kKeyTile * samples - 1) / (kKeyTile * samples);
  t.tile_x = {bits_for(tiles_x - 1), bits_for(tiles_x - 1), false};
  t.tile_y = {bits_for(tiles_y - 1), bits_for(tiles_y - 1), false};
  // A place in a key frame less half a pixel of that, in pixels in between: at least ½ − 2^r − 2, and less than side +
  // 2^r, which has r + 1 bits or more. The pixels of a key frame move the point.
  const int reach = 1 + bits_for(max_of(c.width, c.height) + (1 << c.vector_range));
  t.key_place = {reach + c.vector_fraction, reach - point, true};
  t.tap_weight = {w + 2, 2, true};  // −½ … 1
  // Σ weights·colours of one key, exact; a bicubic one lies in (−½, 3/2) of full scale, and a difference adds (−1, 1).
  const int head = c.colour_bits + int(c.filter == KeyFilter::kBicubic) + int(relights(c)) + 1;
  t.key_sum = {head + 2 * w, head, true};
  t.key_blend = {head + 3 * w, head, true};  // a mean of two of them
  return t;
}

// The numbers of static objects buffers.
constexpr FormatTable object_formats(const Config& c, FormatTable t) {
  // 0 is the background; and how many pixels of a frame show an object.
  const int object = has_objects(c) ? c.object_bits : 1;
  t.object = {object, object, false};
  t.object_count = {bits_for(c.width * c.height), bits_for(c.width * c.height), false};
  return t;
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_FORMATS_MOTION_FORMATS_HPP_
