// SPDX-License-Identifier: Apache-2.0
#include "hls/objects/ztest_merge.hpp"

#include "hls/top/tops.hpp"

using namespace halfspace;

extern "C" void ztest_merge_top(Port<Merge>& merge, Port<Entry>& stored, Port<Entry>& entry, Port<Entry>& merged,
                                Port<Found>& found) {
  HS_STREAM_PORT(merge)
  HS_STREAM_PORT(stored)
  HS_STREAM_PORT(entry)
  HS_STREAM_PORT(merged)
  HS_STREAM_PORT(found)
  HS_STARTED
  using F = TopFormats;
  static_assert(F::kHasObjects, "ztest_merge is of configurations with objects");
  View<Merge> merge_words(merge);
  View<Entry> stored_words(stored);
  View<Entry> entry_words(entry);
  View<Entry> merged_words(merged);
  View<Found> found_words(found);
  ztest_merge(merge_words, stored_words, entry_words, merged_words, found_words);
}
