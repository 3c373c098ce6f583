// SPDX-License-Identifier: Apache-2.0
#include "hls/motion/motion_compensate.hpp"
#include "hls/top/composed/field_process.hpp"
#include "hls/top/composed/key_memory.hpp"
#include "hls/top/composed/scan_process.hpp"
#include "hls/top/tops.hpp"

using namespace halfspace;

static_assert(TopFormats::kHasMotion, "motion_field is of configurations with motion");

namespace {

void compensate_process(MemoryWord<TopKeyBlock> key_frame_0[KeyMemory<TopFormats>::kWords],
                        MemoryWord<TopKeyBlock> key_frame_1[KeyMemory<TopFormats>::kWords], Port<FrameWord>& frame,
                        Port<KeyWeightWord>& key_weight, Port<Motion>& motion, Port<Compensated>& compensated) {
  using F = TopFormats;
  constexpr int kSide = key_side(F::kFilter);
  static constexpr KeyWeights<F> kWeights = key_weights<F>();
  const Frame<F> size = read_frame(frame);
  View<KeyWeightWord> key_weight_words(key_weight);
  CompensationFrame<F> registers;
  registers.width = size.width;
  registers.height = size.height;
  registers.weight = key_weight_words.read().weight;
  KeyCache<F, kSide> cache_0, cache_1;
  empty_cache(cache_0);
  empty_cache(cache_1);
  const int tiles_x = key_tiles<F>(int(raw(size.width)));
  KeyMemory<F> memory_0 = {Words<TopKeyBlock<F>>(key_frame_0), tiles_x, 0};
  KeyMemory<F> memory_1 = {Words<TopKeyBlock<F>>(key_frame_1), tiles_x, 0};
  View<Motion> motion_words(motion);
  View<Compensated> compensated_words(compensated);
Words:
  while (!motion_compensate<F, kSide>(registers, kWeights, cache_0, cache_1, memory_0, memory_1, motion_words,
                                      compensated_words)) {}
}

class BackCompensate {
 public:
  void run(MemoryWord<IndexStamp> index_buffer[IndexBuffer<TopFormats>::kWords],
           MemoryWord<MotionPlanes> motion_database[MotionDatabase<TopFormats>::kWords],
           MemoryWord<TopKeyBlock> key_frame_0[KeyMemory<TopFormats>::kWords],
           MemoryWord<TopKeyBlock> key_frame_1[KeyMemory<TopFormats>::kWords], Port<FrameWord>& frame,
           Port<KeyWeightWord>& key_weight, Port<Compensated>& compensated) {
#ifdef HS_DATAFLOW
#pragma HLS dataflow
#endif
    HS_DEPTH(scan_, TopDepths::scan)
    HS_DEPTH(motion_, TopDepths::motion)
    fork_frame(frame, scan_frame_, compensate_frame_);
    scan_process(index_buffer, scan_frame_, scan_);
    field_process(motion_database, scan_, motion_);
    compensate_process(key_frame_0, key_frame_1, compensate_frame_, key_weight, motion_, compensated);
  }

 private:
  Port<FrameWord> scan_frame_, compensate_frame_;
  Port<Scan> scan_;
  Port<Motion> motion_;
};

}  // namespace

extern "C" void back_compensate_top(MemoryWord<IndexStamp> index_buffer[IndexBuffer<TopFormats>::kWords],
                                    MemoryWord<MotionPlanes> motion_database[MotionDatabase<TopFormats>::kWords],
                                    MemoryWord<TopKeyBlock> key_frame_0[KeyMemory<TopFormats>::kWords],
                                    MemoryWord<TopKeyBlock> key_frame_1[KeyMemory<TopFormats>::kWords],
                                    Port<FrameWord>& frame, Port<KeyWeightWord>& key_weight,
                                    Port<Compensated>& compensated) {
  HS_MEMORY_PORT(index_buffer)
  HS_MEMORY_PORT(motion_database)
  HS_MEMORY_PORT(key_frame_0)
  HS_MEMORY_PORT(key_frame_1)
  HS_STREAM_PORT(frame)
  HS_STREAM_PORT(key_weight)
  HS_STREAM_PORT(compensated)
  HS_STARTED
  static BackCompensate back_compensate;
  back_compensate.run(index_buffer, motion_database, key_frame_0, key_frame_1, frame, key_weight, compensated);
}
