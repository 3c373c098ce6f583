// SPDX-License-Identifier: Apache-2.0
// Processes of composed tops that scan the I-buffer out. A call is a frame.
#ifndef HALFSPACE_HLS_TOP_COMPOSED_SCAN_PROCESS_HPP_
#define HALFSPACE_HLS_TOP_COMPOSED_SCAN_PROCESS_HPP_

#include "hls/shade/scan_index.hpp"
#include "hls/top/composed/frame_word.hpp"

namespace halfspace {

inline void scan_process(MemoryWord<IndexStamp> index_buffer[IndexBuffer<TopFormats>::kWords], Port<FrameWord>& frame,
                         Port<Scan>& scan) {
  const Frame<TopFormats> registers = read_frame(frame);
  IndexBuffer<TopFormats> view = {Words<IndexStamp<TopFormats>>(index_buffer)};
  View<Scan> scan_words(scan);
  scan_index_frame(registers, view, scan_words);
}

// A stamp to two readers.
inline void fork_scan(Port<Scan>& scan, Port<Scan>& first, Port<Scan>& second) {
  View<Scan> scan_words(scan), first_words(first), second_words(second);
  bool done = false;
Stamps:
  while (!done) {
    HS_PIPELINE(1)
    const Scan<TopFormats> word = scan_words.read();
    first_words.write(word);
    second_words.write(word);
    done = is_set(word.last);
  }
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_TOP_COMPOSED_SCAN_PROCESS_HPP_
