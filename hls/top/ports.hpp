// SPDX-License-Identifier: Apache-2.0
// What the ports of all tops are made of. A top is a process on channels of words, each the word of vectors:
//
//   Channel<Record>&     a stream: AXI4-Stream, or what the tool has for a channel
//   a number             a register of the frame: AXI4-Lite
//   a buffer             a memory beside the top
//
// It takes a frame, from its first word to its last, and is then started again; one that cannot know its last word
// takes one word and is started again at once. docs/port.md tells how to bring one to a tool.
#ifndef HALFSPACE_HLS_TOP_PORTS_HPP_
#define HALFSPACE_HLS_TOP_PORTS_HPP_

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
#include "hls/formats/object_records.hpp"

#ifndef HALFSPACE_TOP_CONFIG
#define HALFSPACE_TOP_CONFIG Middle
#endif
#ifndef HALFSPACE_TOP_STAMP
#define HALFSPACE_TOP_STAMP Stamp4
#endif

// The first lines of a top say what its ports are; Catapult and Bambu take it from their own files.
#ifdef HS_PRAGMA
#define HS_STREAM_PORT(name) HS_PRAGMA(HLS INTERFACE mode = axis port = name)
#define HS_REGISTER_PORT(name) HS_PRAGMA(HLS INTERFACE mode = s_axilite port = name)
#define HS_MEMORY_PORT(name) HS_PRAGMA(HLS INTERFACE mode = ap_memory port = name)
#define HS_STARTED HS_PRAGMA(HLS INTERFACE mode = s_axilite port = return )
#define HS_FREE_RUNNING HS_PRAGMA(HLS INTERFACE mode = ap_ctrl_none port = return )
#else
#define HS_STREAM_PORT(name)
#define HS_REGISTER_PORT(name)
#define HS_MEMORY_PORT(name)
#define HS_STARTED
#define HS_FREE_RUNNING
#endif

namespace halfspace {

using TopFormats = Formats<HALFSPACE_TOP_CONFIG, HALFSPACE_TOP_STAMP>;

template <template <class> class Record>
using Port = Channel<Record<TopFormats>>;
template <template <class> class Record>
using View = Stream<Record<TopFormats>>;

// Of the side that the filter of the configuration needs.
template <class F>
using TopKeyBlock = KeyBlock<F, key_side(F::kFilter)>;

// The memories, by names of their own: what a tool writes about a top names them, and has this header for it.
#define HS_TOP_MEMORY(Name) \
  struct Top##Name : Name<TopFormats> {}
HS_TOP_MEMORY(IndexBuffer);
HS_TOP_MEMORY(DepthBuffer);
HS_TOP_MEMORY(ObjectTable);
HS_TOP_MEMORY(ShadingDatabase);
HS_TOP_MEMORY(NormalDatabase);
HS_TOP_MEMORY(TextureDatabase);
HS_TOP_MEMORY(MotionDatabase);
HS_TOP_MEMORY(VisibilityDatabase);
HS_TOP_MEMORY(LightTable);
HS_TOP_MEMORY(MaterialTable);
HS_TOP_MEMORY(TextureTable);
HS_TOP_MEMORY(TextureMemory);
#undef HS_TOP_MEMORY

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

#endif  // HALFSPACE_HLS_TOP_PORTS_HPP_
