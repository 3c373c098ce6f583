// SPDX-License-Identifier: Apache-2.0
#include "hls/objects/scan_object.hpp"
#include "hls/top/composed/gouraud_processes.hpp"
#include "hls/top/composed/scan_process.hpp"
#include "hls/top/tops.hpp"

using namespace halfspace;

namespace {

void object_process(MemoryWord<DepthStamp> depth_buffer[DepthBuffer<TopFormats>::kWords],
                    MemoryWord<ObjectEntry> objects[ObjectTable<TopFormats>::kWords], Port<Scan>& scan,
                    Port<ObjectPixel>& object_pixel) {
  using F = TopFormats;
  static_assert(F::kHasObjects, "scan_object is of configurations with objects");
  DepthBuffer<F> depth_view = {Words<DepthStamp<F>>(depth_buffer)};
  ObjectTable<F> objects_view = {Words<ObjectEntry<F>>(objects)};
  View<Scan> scan_words(scan);
  View<ObjectPixel> object_pixel_words(object_pixel);
Words:
  while (!scan_object(scan_words, depth_view, objects_view, object_pixel_words)) {}
}

void join_process(Port<Pixel>& pixel, Port<ObjectPixel>& object_pixel, Port<Entry>& entry) {
  View<Pixel> pixel_words(pixel);
  View<ObjectPixel> object_pixel_words(object_pixel);
  View<Entry> entry_words(entry);
Words:
  while (!join_entry(pixel_words, object_pixel_words, entry_words)) {}
}

class BackObjects {
 public:
  void run(MemoryWord<IndexStamp> index_buffer[IndexBuffer<TopFormats>::kWords],
           MemoryWord<DepthStamp> depth_buffer[DepthBuffer<TopFormats>::kWords],
           MemoryWord<Planes> database[ShadingDatabase<TopFormats>::kWords],
           MemoryWord<ObjectEntry> objects[ObjectTable<TopFormats>::kWords], Port<FrameWord>& frame,
           Port<Entry>& entry) {
#ifdef HS_DATAFLOW
#pragma HLS dataflow
#endif
    HS_DEPTH(pixel_scan_, TopDepths::pixel_scan)
    HS_DEPTH(object_scan_, TopDepths::object_scan)
    fork_frame(frame, scan_frame_, shade_frame_);
    scan_process(index_buffer, scan_frame_, scan_);
    fork_scan(scan_, pixel_scan_, object_scan_);
    shade_process(database, shade_frame_, pixel_scan_, pixel_);
    object_process(depth_buffer, objects, object_scan_, object_pixel_);
    join_process(pixel_, object_pixel_, entry);
  }

 private:
  Port<FrameWord> scan_frame_, shade_frame_;
  Port<Scan> scan_, pixel_scan_, object_scan_;
  Port<Pixel> pixel_;
  Port<ObjectPixel> object_pixel_;
};

}  // namespace

extern "C" void back_objects_top(MemoryWord<IndexStamp> index_buffer[IndexBuffer<TopFormats>::kWords],
                                 MemoryWord<DepthStamp> depth_buffer[DepthBuffer<TopFormats>::kWords],
                                 MemoryWord<Planes> database[ShadingDatabase<TopFormats>::kWords],
                                 MemoryWord<ObjectEntry> objects[ObjectTable<TopFormats>::kWords],
                                 Port<FrameWord>& frame, Port<Entry>& entry) {
  HS_MEMORY_PORT(index_buffer)
  HS_MEMORY_PORT(depth_buffer)
  HS_MEMORY_PORT(database)
  HS_MEMORY_PORT(objects)
  HS_STREAM_PORT(frame)
  HS_STREAM_PORT(entry)
  HS_STARTED
  static BackObjects back_objects;
  back_objects.run(index_buffer, depth_buffer, database, objects, frame, entry);
}
