// SPDX-License-Identifier: Apache-2.0
#include "hls/objects/scan_object.hpp"

#include "hls/top/tops.hpp"

using namespace halfspace;

extern "C" void scan_object_top(TopDepthBuffer& depth_buffer, const TopObjectTable& objects, Port<Scan>& scan,
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
Words:
  while (!scan_object(scan_words, depth_buffer, objects, object_pixel_words)) {}
}
