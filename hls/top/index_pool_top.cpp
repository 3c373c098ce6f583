// SPDX-License-Identifier: Apache-2.0
#include "hls/ztest/index_pool.hpp"

#include "hls/top/tops.hpp"

using namespace halfspace;

extern "C" void index_pool_top(Port<UnnumberedTriangle>& unnumbered, Port<Visible>& returned,
                               Port<Triangle>& numbered) {
  HS_STREAM_PORT(unnumbered)
  HS_STREAM_PORT(returned)
  HS_STREAM_PORT(numbered)
  HS_STARTED
  using F = TopFormats;
  static_assert(F::kGivesIndices, "the configuration has an index_window");
  static PoolRegisters<F> pool{};  // lasts from frame to frame
  View<UnnumberedTriangle> unnumbered_words(unnumbered);
  View<Visible> returned_words(returned);
  View<Triangle> numbered_words(numbered);
Words:
  while (!index_pool(unnumbered_words, returned_words, pool, numbered_words)) {
    HS_PIPELINE(1)
  }
}
