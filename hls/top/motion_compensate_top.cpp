// SPDX-License-Identifier: Apache-2.0
#include "hls/motion/motion_compensate.hpp"

#include "hls/top/tops.hpp"

using namespace halfspace;

namespace {

// A key frame beyond two streams.
struct KeyStreams {
  View<KeyRequest> requests;
  View<TopKeyBlock> blocks;

  HS_INLINE void request(const KeyRequest<TopFormats>& tile) { requests.write(tile); }
  HS_INLINE TopKeyBlock<TopFormats> read() { return blocks.read(); }
};

}  // namespace

extern "C" void motion_compensate_top(int width, int height, int weight, Port<Motion>& motion,
                                      Port<KeyRequest>& key_request_0, Port<TopKeyBlock>& key_block_0,
                                      Port<KeyRequest>& key_request_1, Port<TopKeyBlock>& key_block_1,
                                      Port<Compensated>& compensated) {
  HS_REGISTER_PORT(width)
  HS_REGISTER_PORT(height)
  HS_REGISTER_PORT(weight)
  HS_STREAM_PORT(motion)
  HS_STREAM_PORT(key_request_0)
  HS_STREAM_PORT(key_block_0)
  HS_STREAM_PORT(key_request_1)
  HS_STREAM_PORT(key_block_1)
  HS_STREAM_PORT(compensated)
  HS_STARTED
  using F = TopFormats;
  static_assert(F::kHasMotion, "motion_compensate is of configurations with motion");
  constexpr int kSide = key_side(F::kFilter);
  static constexpr KeyWeights<F> kWeights = key_weights<F>();
  CompensationFrame<F> frame;
  frame.width = from_raw<F::X>(width);
  frame.height = from_raw<F::Y>(height);
  frame.weight = from_raw<F::KeyWeight>(weight);
  KeyCache<F, kSide> cache_0, cache_1;
  empty_cache(cache_0);
  empty_cache(cache_1);
  KeyStreams memory_0 = {View<KeyRequest>(key_request_0), View<TopKeyBlock>(key_block_0)};
  KeyStreams memory_1 = {View<KeyRequest>(key_request_1), View<TopKeyBlock>(key_block_1)};
  View<Motion> motion_words(motion);
  View<Compensated> compensated_words(compensated);
Words:
  while (!motion_compensate<F, kSide>(frame, kWeights, cache_0, cache_1, memory_0, memory_1, motion_words,
                                      compensated_words)) {}
}
