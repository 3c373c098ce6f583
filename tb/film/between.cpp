// SPDX-License-Identifier: Apache-2.0
#include "tb/film/between.hpp"

#include <algorithm>

#include "tb/harness/plan.hpp"

namespace halfspace::tb {
namespace {

constexpr const char* kPurpose = "the stream between";

// Writes a field of a word.
void put(std::uint32_t* word, const Field& field, std::uint64_t value) {
  const std::uint32_t parts[2] = {std::uint32_t(value), std::uint32_t(value >> 32)};
  copy_bits(word, field.lsb, parts, 0, field.width);
}

}  // namespace

void add_between(Vectors* vectors) {
  const Stream& compensated = need_stream(*vectors, "compensated");
  Stream between;
  between.name = "between";
  between.from = "hole_find", between.to = "film_buffer";
  between.frame_words = compensated.frame_words;
  // The first field of a word is on top.
  for (const char* const name : {"b", "g", "r", "hole", "shown", "y", "x", "last"}) {
    Field field;
    field.name = name;
    field.lsb = between.bits;
    const Field* const same = compensated.find(name);
    field.width = same ? same->width : 1;
    between.bits += field.width;
    between.fields.insert(between.fields.begin(), field);
  }
  between.words = Words(between.bits);
  vectors->streams.push_back(between);
}

void fill_between(Vectors* vectors) {
  const Stream &ordered = need_stream(*vectors, "ordered"), &compensated = need_stream(*vectors, "compensated");
  Stream& between = *std::find_if(vectors->streams.begin(), vectors->streams.end(),
                                  [](const Stream& stream) { return stream.name == "between"; });
  between.words = Words(between.bits);
  for (std::size_t n = 0; n < compensated.words.size(); ++n) {
    const std::uint32_t* const in = compensated.words[n];
    const bool shown = compensated.need("keys", kPurpose).raw(in) != 0;
    const bool hole = !shown && ordered.need("face", kPurpose).raw(ordered.words[n]) != 0;
    std::uint32_t* const word = between.words.append();
    for (const char* const name : {"last", "x", "y", "r", "g", "b"}) {
      put(word, between.need(name, kPurpose), compensated.need(name, kPurpose).raw(in));
    }
    put(word, between.need("shown", kPurpose), shown);
    put(word, between.need("hole", kPurpose), hole);
  }
}

}  // namespace halfspace::tb
