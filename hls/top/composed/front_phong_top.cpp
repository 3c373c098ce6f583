// SPDX-License-Identifier: Apache-2.0
#include "hls/shade/phong_setup.hpp"
#include "hls/shade/shade_phong.hpp"
#include "hls/top/composed/draw_processes.hpp"
#include "hls/top/tops.hpp"

using namespace halfspace;

namespace {

void phong_setup_process(Port<Attributes>& attributes, Port<Normals>& normals, Port<NormalPlanes>& planes) {
  static_assert(TopFormats::kPhong, "phong_setup is of Phong shading");
  View<Attributes> attributes_words(attributes);
  View<Normals> normals_words(normals);
  View<NormalPlanes> planes_words(planes);
Words:
  while (!phong_setup(attributes_words, normals_words, planes_words)) {}
}

void store_process(MemoryWord<NormalPlanes> database[NormalDatabase<TopFormats>::kWords], Port<NormalPlanes>& planes,
                   Port<FrameWord>& frame, Port<FrameWord>& stored_frame) {
  NormalDatabase<TopFormats> view = {Words<NormalPlanes<TopFormats>>(database)};
  View<NormalPlanes> planes_words(planes);
Words:
  while (!store_planes(planes_words, view)) {}
  stored_frame.write(frame.read());
}

class FrontPhong {
 public:
  void run(MemoryWord<IndexStamp> index_buffer[IndexBuffer<TopFormats>::kWords],
           MemoryWord<DepthStamp> depth_buffer[DepthBuffer<TopFormats>::kWords],
           MemoryWord<NormalPlanes> normals_database[NormalDatabase<TopFormats>::kWords], Port<FrameWord>& frame,
           Port<Triangle>& triangle, Port<Normals>& normals, Port<Visible>& visible, Port<FrameWord>& drawn) {
#ifdef HS_DATAFLOW
#pragma HLS dataflow
#endif
    HS_DEPTH(setup_, TopDepths::setup)
    HS_DEPTH(attributes_, TopDepths::attributes)
    HS_DEPTH(stamp_, TopDepths::stamp)
    fork_frame(frame, setup_frame_, raster_frame_, test_frame_);
    triangle_process(setup_frame_, triangle, setup_, attributes_);
    raster_process(raster_frame_, setup_, stamp_);
    test_process(index_buffer, depth_buffer, test_frame_, stamp_, tested_, tested_frame_);
    select_process(attributes_, tested_, visible, passed_);
    phong_setup_process(passed_, normals, planes_);
    store_process(normals_database, planes_, tested_frame_, drawn);
  }

 private:
  Port<FrameWord> setup_frame_, raster_frame_, test_frame_, tested_frame_;
  Port<Setup> setup_;
  Port<Attributes> attributes_, passed_;
  Port<Stamp> stamp_;
  Port<Visible> tested_;
  Port<NormalPlanes> planes_;
};

}  // namespace

extern "C" void front_phong_top(MemoryWord<IndexStamp> index_buffer[IndexBuffer<TopFormats>::kWords],
                                MemoryWord<DepthStamp> depth_buffer[DepthBuffer<TopFormats>::kWords],
                                MemoryWord<NormalPlanes> normals_database[NormalDatabase<TopFormats>::kWords],
                                Port<FrameWord>& frame, Port<Triangle>& triangle, Port<Normals>& normals,
                                Port<Visible>& visible, Port<FrameWord>& drawn) {
  HS_MEMORY_PORT(index_buffer)
  HS_MEMORY_PORT(depth_buffer)
  HS_MEMORY_PORT(normals_database)
  HS_STREAM_PORT(frame)
  HS_STREAM_PORT(triangle)
  HS_STREAM_PORT(normals)
  HS_STREAM_PORT(visible)
  HS_STREAM_PORT(drawn)
  HS_STARTED
  static FrontPhong front_phong;
  front_phong.run(index_buffer, depth_buffer, normals_database, frame, triangle, normals, visible, drawn);
}
