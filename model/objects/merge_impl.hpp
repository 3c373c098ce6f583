// SPDX-License-Identifier: Apache-2.0
// A run of ztest_merge for one configuration and one stamp.
#ifndef HALFSPACE_MODEL_OBJECTS_MERGE_IMPL_HPP_
#define HALFSPACE_MODEL_OBJECTS_MERGE_IMPL_HPP_

#include <optional>
#include <vector>

#include "hls/formats/streams.hpp"
#include "hls/objects/ztest_merge.hpp"
#include "model/formats/recorder.hpp"
#include "model/objects/merge.hpp"
#include "model/objects/object_records.hpp"
#include "ref/geometry/snap.hpp"

namespace halfspace::model {

// Of ztest_merge.
template <class F>
struct MergeStreams {
  HS_STREAM_MEMBERS(HS_MERGE_STREAMS)
};

template <class F>
Entry<F> entry_record(const std::vector<RawEntry>& buffer, const MergeInput& input, int x, int y, bool last) {
  Entry<F> out{};
  out.last = from_raw<Bit>(last);
  out.x = from_raw<typename F::X>(x);
  out.y = from_raw<typename F::Y>(y);
  const RawEntry beyond{ref::full_depth(F::kDepthBits), 0, input.background};
  for (int l = 0; l < F::kLanes; ++l) {
    const int column = x * F::kLanesX + l % F::kLanesX, row = y * F::kLanesY + l / F::kLanesX;
    const bool inside = column < input.width && row < input.height;
    const RawEntry& in = inside ? buffer[std::size_t(row) * input.width + column] : beyond;
    out.depth[l] = from_raw<typename F::Depth>(in.depth);
    out.object[l] = from_raw<typename F::Object>(in.object);
    out.r[l] = from_raw<typename F::Colour>(in.rgb[0]);
    out.g[l] = from_raw<typename F::Colour>(in.rgb[1]);
    out.b[l] = from_raw<typename F::Colour>(in.rgb[2]);
  }
  return out;
}

// Of an input that fits. `words` takes those of its streams, unless it is null.
template <class F>
MergeResult merge_run(const MergeInput& input, std::vector<StreamWords>* words) {
  MergeStreams<F> s;
  std::optional<Recorder> recorder;
  if (words) recorder.emplace(s);

  Merge<F> command;
  command.merges = from_raw<Bit>(input.drawn != nullptr);
  command.sends = from_raw<Bit>(input.sends);
  command.first = from_raw<typename F::Object>(input.first);
  command.last = from_raw<typename F::Object>(input.last);
  command.r = from_raw<typename F::Colour>(input.background[0]);
  command.g = from_raw<typename F::Colour>(input.background[1]);
  command.b = from_raw<typename F::Colour>(input.background[2]);
  s.merge.write(command);
  const int x0 = input.box.x0 / F::kLanesX, x1 = (input.box.x1 - 1) / F::kLanesX;
  const int y0 = input.box.y0 / F::kLanesY, y1 = (input.box.y1 - 1) / F::kLanesY;
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      const bool last = x == x1 && y == y1;
      s.stored.write(entry_record<F>(*input.stored, input, x, y, last));
      if (input.drawn) s.entry.write(entry_record<F>(*input.drawn, input, x, y, last));
    }
  }
  ztest_merge(s.merge, s.stored, s.entry, s.merged, s.found);

  MergeResult result;
  if (input.sends) result.merged = *input.stored;
  while (!s.merged.empty()) put_entry<F>(s.merged.read(), input.width, input.height, result.merged);
  const Found<F> hits = s.found.read();
  result.count = std::uint64_t(raw(hits.count));
  if (result.count != 0) {
    result.box = ref::Box{int(raw(hits.x_first)) * F::kLanesX, int(raw(hits.y_first)) * F::kLanesY,
                          (int(raw(hits.x_last)) + 1) * F::kLanesX, (int(raw(hits.y_last)) + 1) * F::kLanesY}
                     .cut({0, 0, input.width, input.height});
  }
  result.cycles = std::uint64_t(x1 - x0 + 1) * std::uint64_t(y1 - y0 + 1) + 1;
  if (words) *words = recorder->words();
  return result;
}

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_OBJECTS_MERGE_IMPL_HPP_
