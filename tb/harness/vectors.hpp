// SPDX-License-Identifier: Apache-2.0
// A vector set: manifest.json and one .hex file a stream, as docs/vectors.md describes them.
//
// Nothing here knows the records: the fields come from the manifest. Whatever is wrong with the files ends in an
// Error of one sentence that names the file, the place and the remedy.
#ifndef HALFSPACE_TB_HARNESS_VECTORS_HPP_
#define HALFSPACE_TB_HARNESS_VECTORS_HPP_

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "tb/harness/words.hpp"

namespace halfspace::tb {

struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Field `name` of lane l: bits lsb + l·width and up. `fraction` bits stand after the binary point.
struct Field {
  std::string name;
  int lsb = 0, width = 0, count = 1;
  bool is_signed = false;
  int fraction = 0;
  std::string valid_if;  // when it counts, for who compares words that are not ours

  std::uint64_t raw(const std::uint32_t* word, int lane = 0) const { return extract(word, lsb + lane * width, width); }
};

struct Stream {
  std::string name, from, to, file;
  std::string context;           // the stream whose word of the same number tells the triangles of this one
  std::string any_order_within;  // a field: words that follow each other with one value of it may come in any order
  int bits = 0;
  std::vector<std::size_t> frame_words;
  std::vector<Field> fields;
  Words words;

  const Field* find(const std::string& field) const;
  // As find(), but the lack of it is an Error: `purpose` says what for.
  const Field& need(const std::string& field, const char* purpose) const;
};

struct Frame {
  std::uint32_t width = 0, height = 0;
  std::uint32_t background[3] = {0, 0, 0};
  std::string note;
  bool has_triangles = true;
  // Of a film, where a frame is a pass: "key", "between" or "fill"; and how much key 0 weighs in between.
  std::string pass;
  std::uint32_t weight = 0;
  // What a manifest may tell: stamps that the rasterizer visits, one a triangle at least; cycles of a unit that stands
  // alone, where it never waits. < 0: it does not.
  std::int64_t visits = -1, cycles = -1;
};

inline bool same_registers(const Frame& a, const Frame& b) {
  return a.width == b.width && a.height == b.height && a.background[0] == b.background[0] &&
         a.background[1] == b.background[1] && a.background[2] == b.background[2];
}

struct Vectors {
  std::string directory, scene, config;
  int lanes_x = 0, lanes_y = 0;
  std::size_t window =
      0;  // not 0: a triangle may take the index of the one so many before it, and waits until that is done
  std::vector<Frame> frames;
  std::vector<Stream> streams;

  int lanes() const { return lanes_x * lanes_y; }
  bool is_film() const { return !frames.front().pass.empty(); }
  const Stream* find(const std::string& name) const;
  // No frame has a triangle, so that what only triangles cause has no words.
  bool is_background() const;
  // The stream that comes out at the end of the pipeline: pixel, of a configuration with objects entry, between key
  // frames motion.
  const char* shown() const { return find("motion") ? "motion" : find("entry") ? "entry" : "pixel"; }
};

// manifest.json alone.
Vectors load_manifest(const std::string& directory);
// The words of a .hex file, `most` and one more at most.
Words read_words(const std::string& file, int bits, std::size_t most);
// The words of one stream of it.
void load_words(const std::string& directory, Stream* stream);

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_HARNESS_VECTORS_HPP_
