// SPDX-License-Identifier: Apache-2.0
// What the ports of all tops are made of. A top is a process on channels of words, each the word of vectors:
//
//   Channel<Record>&     a stream: AXI4-Stream, or what the tool has for a channel
//   a number             a register of the frame: AXI4-Lite
//   an array             a memory beside the top, of words too
//
// It takes a frame, from its first word to its last, and is then started again; one that cannot know its last word
// takes one word and is started again at once. docs/port.md tells how to bring one to a tool.
#ifndef HALFSPACE_HLS_TOP_PORTS_PORTS_HPP_
#define HALFSPACE_HLS_TOP_PORTS_PORTS_HPP_

#include "hls/numbers/stream.hpp"
// Whoever compiles a top names its configuration, and the file on the include path that has it: bare, as quotes do not
// come through every tool's command line.
#ifdef HALFSPACE_TOP_HEADER
#define HS_QUOTED_TEXT(name) #name
#define HS_QUOTED(name) HS_QUOTED_TEXT(name)
#include HS_QUOTED(HALFSPACE_TOP_HEADER)
#else
#include "hls/formats/configs/high.hpp"
#include "hls/formats/configs/low.hpp"
#include "hls/formats/configs/middle.hpp"
#endif
#include "hls/formats/buffers.hpp"
#include "hls/formats/key_records.hpp"
#include "hls/formats/static_records.hpp"
#include "hls/formats/stream_depths.hpp"
#include "hls/top/ports/port_pragmas.hpp"

#ifndef HALFSPACE_TOP_CONFIG
#define HALFSPACE_TOP_CONFIG Middle
#endif
#ifndef HALFSPACE_TOP_STAMP
#define HALFSPACE_TOP_STAMP Stamp4
#endif

namespace halfspace {

using TopFormats = Formats<HALFSPACE_TOP_CONFIG, HALFSPACE_TOP_STAMP>;
using TopDepths = StreamDepths<TopFormats>;  // of channels inside a composed top

template <template <class> class Record>
using Port = Channel<Record<TopFormats>>;
template <template <class> class Record>
using View = Stream<Record<TopFormats>>;

// Of the side that the filter of the configuration needs.
template <class F>
using TopKeyBlock = KeyBlock<F, key_side(F::kFilter)>;

// A word of a memory.
template <template <class> class Record>
using MemoryWord = Packed<Record<TopFormats>>;
// Complete before a port names it: a tool asks for its size.
template <template <class> class... Records>
constexpr std::size_t complete_words() {
  const std::size_t sizes[] = {sizeof(MemoryWord<Records>)...};
  return sizeof(sizes);
}
static_assert(complete_words<IndexStamp, DepthStamp, ObjectEntry, DepthEntry, TexelColour, Planes, NormalPlanes,
                             TexturePlanes, MotionPlanes, Light, Material, TextureEntry>() > 0,
              "words of memories");

// Pixels of the frame.
inline Frame<TopFormats> top_frame(int width, int height) {
  Frame<TopFormats> frame{};
  frame.width = from_raw<TopFormats::X>(width);
  frame.height = from_raw<TopFormats::Y>(height);
  return frame;
}
inline Frame<TopFormats> background_frame(int red, int green, int blue) {
  Frame<TopFormats> frame{};
  frame.r = from_raw<TopFormats::Colour>(red);
  frame.g = from_raw<TopFormats::Colour>(green);
  frame.b = from_raw<TopFormats::Colour>(blue);
  return frame;
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_TOP_PORTS_PORTS_HPP_
