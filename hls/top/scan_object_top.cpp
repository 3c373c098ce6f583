// SPDX-License-Identifier: Apache-2.0
#include "hls/objects/scan_object.hpp"

#include "hls/top/tops.hpp"

using namespace halfspace;

extern "C" void scan_object_top(MemoryWord<DepthStamp> depth_buffer[DepthBuffer<TopFormats>::kWords],
                                MemoryWord<ObjectEntry> objects[ObjectTable<TopFormats>::kWords], Port<Scan>& scan,
                                Port<ObjectPixel>& object_pixel) {
  HS_MEMORY_PORT(depth_buffer)
  HS_MEMORY_PORT(objects)
  HS_STREAM_PORT(scan)
  HS_STREAM_PORT(object_pixel)
  HS_STARTED
  using F = TopFormats;
  static_assert(F::kHasObjects, "scan_object is of configurations with objects");
  View<Scan> scan_words(scan);
  View<ObjectPixel> object_pixel_words(object_pixel);
  DepthBuffer<F> depth_buffer_view = {Words<DepthStamp<F>>(depth_buffer)};
  ObjectTable<F> objects_view = {Words<ObjectEntry<F>>(objects)};
  scan_object_frame(scan_words, depth_buffer_view, objects_view, object_pixel_words);
}
