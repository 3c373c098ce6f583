// SPDX-License-Identifier: Apache-2.0
#include "hls/objects/ztest_merge.hpp"

#include "hls/top/fields.hpp"

using namespace halfspace;

// A run of `count` stamps, the last one of which ends it.
extern "C" void ztest_merge_top(int count, const std::int64_t merge[kMergeFields],
                                const std::int64_t stored[TopFormats::kStamps * kEntryFields],
                                const std::int64_t entry[TopFormats::kStamps * kEntryFields],
                                std::int64_t merged[TopFormats::kStamps * kEntryFields],
                                std::int64_t found[kFoundFields]) {
  using F = TopFormats;
  Stream<Merge<F>> run;
  Stream<Entry<F>> in;
  Stream<Entry<F>> drawn;
  Stream<Entry<F>> out;
  Stream<Found<F>> result;
  const Merge<F> command = read_fields<Merge<F>>(merge);
  run.write(command);
Stamps:
  for (int n = 0; n < F::kStamps; ++n) {
    if (n == count) break;
    in.write(read_fields<Entry<F>>(stored + n * kEntryFields));
    if (raw(command.merges)) drawn.write(read_fields<Entry<F>>(entry + n * kEntryFields));
  }
  ztest_merge(run, in, drawn, out, result);
Merged:
  for (int n = 0; n < F::kStamps; ++n) {
    if (n == count || !raw(command.sends)) break;
    write_fields(out.read(), merged + n * kEntryFields);
  }
  write_fields(result.read(), found);
}
