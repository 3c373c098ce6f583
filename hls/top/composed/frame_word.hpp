// SPDX-License-Identifier: Apache-2.0
// What the registers of the units say of a frame, as a word of a stream: what starts a frame of a composed top. Its
// processes run for ever, so that a register would be read while it is still that of the frame before.
#ifndef HALFSPACE_HLS_TOP_COMPOSED_FRAME_WORD_HPP_
#define HALFSPACE_HLS_TOP_COMPOSED_FRAME_WORD_HPP_

#include "hls/top/ports/ports.hpp"

namespace halfspace {

template <class F>
struct FrameWord {
  Frame<F> frame;

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("width", frame.width), v("height", frame.height);
    v("r", frame.r), v("g", frame.g), v("b", frame.b);
  }
};

inline Frame<TopFormats> read_frame(Port<FrameWord>& frame) {
  View<FrameWord> words(frame);
  return words.read().frame;
}

// A word to each process that asks for it. Bambu takes no list of parameters that share a name.
inline void fork_frame(Port<FrameWord>& frame, Port<FrameWord>& first, Port<FrameWord>& second) {
  const Packed<FrameWord<TopFormats>> word = frame.read();
  first.write(word);
  second.write(word);
}
inline void fork_frame(Port<FrameWord>& frame, Port<FrameWord>& first, Port<FrameWord>& second,
                       Port<FrameWord>& third) {
  const Packed<FrameWord<TopFormats>> word = frame.read();
  first.write(word);
  second.write(word);
  third.write(word);
}
inline void fork_frame(Port<FrameWord>& frame, Port<FrameWord>& first, Port<FrameWord>& second, Port<FrameWord>& third,
                       Port<FrameWord>& fourth) {
  const Packed<FrameWord<TopFormats>> word = frame.read();
  first.write(word);
  second.write(word);
  third.write(word);
  fourth.write(word);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_TOP_COMPOSED_FRAME_WORD_HPP_
