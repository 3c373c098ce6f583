// SPDX-License-Identifier: Apache-2.0
// Processes of composed tops for colours at the vertices. A call is a frame.
#ifndef HALFSPACE_HLS_TOP_COMPOSED_GOURAUD_PROCESSES_HPP_
#define HALFSPACE_HLS_TOP_COMPOSED_GOURAUD_PROCESSES_HPP_

#include "hls/setup/shade_setup.hpp"
#include "hls/shade/shade_gouraud.hpp"
#include "hls/top/composed/frame_word.hpp"

namespace halfspace {

inline void planes_process(Port<Attributes>& attributes, Port<Planes>& planes) {
  View<Attributes> attributes_words(attributes);
  View<Planes> planes_words(planes);
Words:
  while (!shade_setup(attributes_words, planes_words)) {}
}

// Into TdbS. The word of the frame goes on once its planes are there.
inline void store_process(MemoryWord<Planes> database[ShadingDatabase<TopFormats>::kWords], Port<Planes>& planes,
                          Port<FrameWord>& frame, Port<FrameWord>& stored_frame) {
  ShadingDatabase<TopFormats> view = {Words<Planes<TopFormats>>(database)};
  View<Planes> planes_words(planes);
Words:
  while (!store_planes(planes_words, view)) {}
  stored_frame.write(frame.read());
}

inline void shade_process(MemoryWord<Planes> database[ShadingDatabase<TopFormats>::kWords], Port<FrameWord>& frame,
                          Port<Scan>& scan, Port<Pixel>& pixel) {
  const Frame<TopFormats> registers = read_frame(frame);
  ShadingDatabase<TopFormats> view = {Words<Planes<TopFormats>>(database)};
  View<Scan> scan_words(scan);
  View<Pixel> pixel_words(pixel);
  shade_gouraud_frame(registers, scan_words, view, pixel_words);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_TOP_COMPOSED_GOURAUD_PROCESSES_HPP_
