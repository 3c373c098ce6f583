// SPDX-License-Identifier: Apache-2.0
#include "hls/top/fields.hpp"

using namespace halfspace;

// A stamp of the finished frame and its colours, from the caller's buffers.
extern "C" void scan_object_top(const std::int64_t scan[kScanFields], const std::int64_t pixel[kPixelFields],
                                DepthBuffer<TopFormats>* depth_buffer, const ObjectTable<TopFormats>* table,
                                std::int64_t entry[kEntryFields]) {
  using F = TopFormats;
  Stream<Scan<F>> in;
  Stream<Pixel<F>> colours;
  Stream<ObjectPixel<F>> objects;
  Stream<Entry<F>> out;
  in.write(read_fields<Scan<F>>(scan));
  colours.write(read_fields<Pixel<F>>(pixel));
  scan_object(in, *depth_buffer, *table, objects);
  join_entry(colours, objects, out);
  write_fields(out.read(), entry);
}
