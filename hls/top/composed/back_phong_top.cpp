// SPDX-License-Identifier: Apache-2.0
#include "hls/shade/shade_phong.hpp"
#include "hls/top/composed/scan_process.hpp"
#include "hls/top/tops.hpp"

using namespace halfspace;

namespace {

void shade_process(MemoryWord<NormalPlanes> database[NormalDatabase<TopFormats>::kWords],
                   MemoryWord<Light> lights[LightTable<TopFormats>::kWords],
                   MemoryWord<Material> materials[MaterialTable<TopFormats>::kWords], Port<FrameWord>& frame,
                   Port<Scan>& scan, Port<Pixel>& pixel) {
  using F = TopFormats;
  static_assert(F::kPhong, "shade_phong is of Phong shading");
  const Frame<F> registers = read_frame(frame);
  NormalDatabase<F> database_view = {Words<NormalPlanes<F>>(database)};
  LightTable<F> lights_view = {Words<Light<F>>(lights)};
  MaterialTable<F> materials_view = {WordRows<Material<F>, kMostLights>(materials)};
  View<Scan> scan_words(scan);
  View<Pixel> pixel_words(pixel);
  shade_phong_frame(registers, scan_words, database_view, lights_view, materials_view, pixel_words);
}

class BackPhong {
 public:
  void run(MemoryWord<IndexStamp> index_buffer[IndexBuffer<TopFormats>::kWords],
           MemoryWord<NormalPlanes> normals_database[NormalDatabase<TopFormats>::kWords],
           MemoryWord<Light> lights[LightTable<TopFormats>::kWords],
           MemoryWord<Material> materials[MaterialTable<TopFormats>::kWords], Port<FrameWord>& frame,
           Port<Pixel>& pixel) {
#ifdef HS_DATAFLOW
#pragma HLS dataflow
#endif
    HS_DEPTH(scan_, TopDepths::scan)
    fork_frame(frame, scan_frame_, shade_frame_);
    scan_process(index_buffer, scan_frame_, scan_);
    shade_process(normals_database, lights, materials, shade_frame_, scan_, pixel);
  }

 private:
  Port<FrameWord> scan_frame_, shade_frame_;
  Port<Scan> scan_;
};

}  // namespace

extern "C" void back_phong_top(MemoryWord<IndexStamp> index_buffer[IndexBuffer<TopFormats>::kWords],
                               MemoryWord<NormalPlanes> normals_database[NormalDatabase<TopFormats>::kWords],
                               MemoryWord<Light> lights[LightTable<TopFormats>::kWords],
                               MemoryWord<Material> materials[MaterialTable<TopFormats>::kWords],
                               Port<FrameWord>& frame, Port<Pixel>& pixel) {
  HS_MEMORY_PORT(index_buffer)
  HS_MEMORY_PORT(normals_database)
  HS_MEMORY_PORT(lights)
  HS_MEMORY_PORT(materials)
  HS_STREAM_PORT(frame)
  HS_STREAM_PORT(pixel)
  HS_STARTED
  static BackPhong back_phong;
  back_phong.run(index_buffer, normals_database, lights, materials, frame, pixel);
}
