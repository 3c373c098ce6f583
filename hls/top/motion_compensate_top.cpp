// SPDX-License-Identifier: Apache-2.0
// Of a configuration with motion: HALFSPACE_TOP_CONFIG names it. The caches last from word to word, and are empty at
// first.
#include "hls/motion/motion_compensate.hpp"
#include "hls/top/fields.hpp"

using namespace halfspace;

extern "C" void motion_compensate_top(int width, int height, int weight, const std::int64_t motion[kMotionFields],
                                      const KeyBlock<TopFormats, key_side(TopFormats::kFilter)>* memory_0,
                                      const KeyBlock<TopFormats, key_side(TopFormats::kFilter)>* memory_1,
                                      std::int64_t compensated[kCompensatedFields]) {
  using F = TopFormats;
  static_assert(F::kHasMotion, "motion_compensate is of configurations with motion");
  constexpr int kSide = key_side(F::kFilter);
  static constexpr KeyWeights<F> kWeights = key_weights<F>();
  static KeyCache<F, kSide> cache_0, cache_1;
  CompensationFrame<F> frame;
  frame.width = from_raw<F::X>(width);
  frame.height = from_raw<F::Y>(height);
  frame.weight = from_raw<F::KeyWeight>(weight);
  Probe<KeyRequest<F>> request_0, request_1;
  Probe<KeyBlock<F, kSide>> block_0, block_1;
  Stream<Motion<F>> in;
  Stream<Compensated<F>> out;
  in.write(read_fields<Motion<F>>(motion));
  motion_compensate<F, kSide>(frame, kWeights, cache_0, cache_1, memory_0, memory_1, in, request_0, block_0, request_1,
                              block_1, out);
  write_fields(out.read(), compensated);
}
