// SPDX-License-Identifier: Apache-2.0
#include "hls/motion/motion_field.hpp"
#include "hls/motion/motion_setup.hpp"
#include "hls/top/composed/draw_processes.hpp"
#include "hls/top/tops.hpp"

using namespace halfspace;

namespace {

void motion_setup_process(Port<Attributes>& attributes, Port<MotionVectors>& vectors, Port<MotionPlanes>& planes) {
  static_assert(TopFormats::kHasMotion, "motion_setup is of configurations with motion");
  View<Attributes> attributes_words(attributes);
  View<MotionVectors> vectors_words(vectors);
  View<MotionPlanes> planes_words(planes);
Words:
  while (!motion_setup(attributes_words, vectors_words, planes_words)) {}
}

void store_process(MemoryWord<MotionPlanes> database[MotionDatabase<TopFormats>::kWords], Port<MotionPlanes>& planes,
                   Port<FrameWord>& frame, Port<FrameWord>& stored_frame) {
  MotionDatabase<TopFormats> view = {Words<MotionPlanes<TopFormats>>(database)};
  View<MotionPlanes> planes_words(planes);
Words:
  while (!store_planes(planes_words, view)) {}
  stored_frame.write(frame.read());
}

class FrontMotion {
 public:
  void run(MemoryWord<IndexStamp> index_buffer[IndexBuffer<TopFormats>::kWords],
           MemoryWord<DepthStamp> depth_buffer[DepthBuffer<TopFormats>::kWords],
           MemoryWord<MotionPlanes> motion_database[MotionDatabase<TopFormats>::kWords], Port<FrameWord>& frame,
           Port<Triangle>& triangle, Port<MotionVectors>& vectors, Port<Visible>& visible, Port<FrameWord>& drawn) {
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
    motion_setup_process(passed_, vectors, planes_);
    store_process(motion_database, planes_, tested_frame_, drawn);
  }

 private:
  Port<FrameWord> setup_frame_, raster_frame_, test_frame_, tested_frame_;
  Port<Setup> setup_;
  Port<Attributes> attributes_, passed_;
  Port<Stamp> stamp_;
  Port<Visible> tested_;
  Port<MotionPlanes> planes_;
};

}  // namespace

extern "C" void front_motion_top(MemoryWord<IndexStamp> index_buffer[IndexBuffer<TopFormats>::kWords],
                                 MemoryWord<DepthStamp> depth_buffer[DepthBuffer<TopFormats>::kWords],
                                 MemoryWord<MotionPlanes> motion_database[MotionDatabase<TopFormats>::kWords],
                                 Port<FrameWord>& frame, Port<Triangle>& triangle, Port<MotionVectors>& vectors,
                                 Port<Visible>& visible, Port<FrameWord>& drawn) {
  HS_MEMORY_PORT(index_buffer)
  HS_MEMORY_PORT(depth_buffer)
  HS_MEMORY_PORT(motion_database)
  HS_STREAM_PORT(frame)
  HS_STREAM_PORT(triangle)
  HS_STREAM_PORT(vectors)
  HS_STREAM_PORT(visible)
  HS_STREAM_PORT(drawn)
  HS_STARTED
  static FrontMotion front_motion;
  front_motion.run(index_buffer, depth_buffer, motion_database, frame, triangle, vectors, visible, drawn);
}
