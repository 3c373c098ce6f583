// SPDX-License-Identifier: Apache-2.0
// Composed of the tops of units, in one translation unit with them: Bambu composes what it sees at once.
#include "hls/top/scan_index_top.cpp"
#include "hls/top/shade_gouraud_top.cpp"

namespace {

class Back {
 public:
  void run(int width, int height, int red, int green, int blue,
           MemoryWord<IndexStamp> index_buffer[IndexBuffer<TopFormats>::kWords],
           MemoryWord<Planes> database[ShadingDatabase<TopFormats>::kWords], Port<Pixel>& pixel) {
#ifdef HS_DATAFLOW
#pragma HLS dataflow
#endif
    HS_DEPTH(scan_, 4)
    scan_index_top(width, height, index_buffer, scan_);
    shade_gouraud_top(red, green, blue, database, scan_, pixel);
  }

 private:
  Port<Scan> scan_;
};

}  // namespace

extern "C" void back_top(int width, int height, int red, int green, int blue,
                         MemoryWord<IndexStamp> index_buffer[IndexBuffer<TopFormats>::kWords],
                         MemoryWord<Planes> database[ShadingDatabase<TopFormats>::kWords], Port<Pixel>& pixel) {
  HS_REGISTER_PORT(width)
  HS_REGISTER_PORT(height)
  HS_REGISTER_PORT(red)
  HS_REGISTER_PORT(green)
  HS_REGISTER_PORT(blue)
  HS_MEMORY_PORT(index_buffer)
  HS_MEMORY_PORT(database)
  HS_STREAM_PORT(pixel)
  HS_STARTED
  static Back back;
  back.run(width, height, red, green, blue, index_buffer, database, pixel);
}
