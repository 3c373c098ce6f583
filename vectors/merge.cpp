// SPDX-License-Identifier: Apache-2.0
#include "vectors/merge.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hls/ztest_merge.hpp"
#include "ref/error.hpp"
#include "vectors/engine_impl.hpp"
#include "vectors/runtime_formats.hpp"

namespace halfspace::vectors {
namespace {

template <class F, class E>
E entry_record(const std::vector<RawEntry>& buffer, const MergeInput& input, int x, int y, bool last) {
  E out{};
  out.last = from_raw<Bit>(last);
  out.x = from_raw<typename F::X>(x);
  out.y = from_raw<typename F::Y>(y);
  const RawEntry beyond{(1u << (F::kDepthBits - 1)) * 2 - 1, 0, input.background};
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

template <class F, class E>
void put_entry(const E& in, const MergeInput& input, std::vector<RawEntry>& buffer) {
  for (int l = 0; l < F::kLanes; ++l) {
    const int x = int(raw(in.x)) * F::kLanesX + l % F::kLanesX, y = int(raw(in.y)) * F::kLanesY + l / F::kLanesX;
    if (x >= input.width || y >= input.height) continue;
    buffer[std::size_t(y) * input.width + x] = {std::uint32_t(raw(in.depth[l])), std::uint32_t(raw(in.object[l])),
                                                {std::uint8_t(raw(in.r[l])), std::uint8_t(raw(in.g[l])), std::uint8_t(raw(in.b[l]))}};
  }
}

void check(const MergeInput& input, const Configuration& configuration) {
  const Config c = configuration.config();
  const auto refuse = [&](const std::string& why) {
    throw ref::Error(fmt::format("a merge in configuration {}: {}", configuration.name(), why));
  };
  if (input.width < 1 || input.width > c.width || input.height < 1 || input.height > c.height) {
    refuse(fmt::format("buffers of {}x{} pixels, and {}x{} is the largest: raise its width and height", input.width, input.height, c.width, c.height));
  }
  const ref::Box cut = input.box.cut({0, 0, input.width, input.height});
  if (input.box.empty() || cut.x0 != input.box.x0 || cut.y0 != input.box.y0 || cut.x1 != input.box.x1 || cut.y1 != input.box.y1) {
    refuse("its box is empty, or not inside the frame: cut it");
  }
  if (input.first >> c.object_bits != 0 || input.last >> c.object_bits != 0) refuse("an object of its range has no number: raise object_bits");
  for (const auto* buffer : {input.stored, input.drawn}) {
    if (buffer == nullptr && buffer != input.stored) continue;
    if (buffer == nullptr || buffer->size() != std::size_t(input.width) * input.height) refuse("a buffer is not of the size of the frame");
    const auto fits = [&](const RawEntry& e) {
      return e.depth >> (c.depth_bits - 1) >> 1 == 0 && e.object >> c.object_bits == 0;
    };
    if (!std::all_of(buffer->begin(), buffer->end(), fits)) refuse("an entry has no room in its word: raise object_bits");
  }
}

template <class F>
MergeResult merge_run(const MergeInput& input, std::vector<StreamWords>* streams) {
  Stream<Merge<F>> run;
  Stream<StoredEntry<F>> stored;
  Stream<Entry<F>> entry;
  Stream<MergedEntry<F>> merged;
  Stream<Found<F>> found;
  std::vector<Merge<F>> run_words;
  std::vector<StoredEntry<F>> stored_words;
  std::vector<Entry<F>> entry_words;
  std::vector<MergedEntry<F>> merged_words;
  std::vector<Found<F>> found_words;
  if (streams) run.tap(&run_words), stored.tap(&stored_words), entry.tap(&entry_words), merged.tap(&merged_words), found.tap(&found_words);

  Merge<F> command;
  command.merges = from_raw<Bit>(input.drawn != nullptr);
  command.sends = from_raw<Bit>(input.sends);
  command.first = from_raw<typename F::Object>(input.first);
  command.last = from_raw<typename F::Object>(input.last);
  command.r = from_raw<typename F::Colour>(input.background[0]);
  command.g = from_raw<typename F::Colour>(input.background[1]);
  command.b = from_raw<typename F::Colour>(input.background[2]);
  run.write(command);
  const int x0 = input.box.x0 / F::kLanesX, x1 = (input.box.x1 - 1) / F::kLanesX;
  const int y0 = input.box.y0 / F::kLanesY, y1 = (input.box.y1 - 1) / F::kLanesY;
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      const bool last = x == x1 && y == y1;
      stored.write(entry_record<F, StoredEntry<F>>(*input.stored, input, x, y, last));
      if (input.drawn) entry.write(entry_record<F, Entry<F>>(*input.drawn, input, x, y, last));
    }
  }
  ztest_merge(run, stored, entry, merged, found);

  MergeResult result;
  if (input.sends) result.merged = *input.stored;
  while (!merged.empty()) put_entry<F>(merged.read(), input, result.merged);
  const Found<F> hits = found.read();
  result.count = std::uint64_t(raw(hits.count));
  if (result.count != 0) {
    result.box = ref::Box{int(raw(hits.x_first)) * F::kLanesX, int(raw(hits.y_first)) * F::kLanesY, (int(raw(hits.x_last)) + 1) * F::kLanesX,
                          (int(raw(hits.y_last)) + 1) * F::kLanesY}
                     .cut({0, 0, input.width, input.height});
  }
  result.cycles = std::uint64_t(x1 - x0 + 1) * std::uint64_t(y1 - y0 + 1) + 1;
  if (streams) {
    *streams = {stream_words(run_words, layout<Merge<F>>()), stream_words(stored_words, layout<StoredEntry<F>>()),
                stream_words(entry_words, layout<Entry<F>>()), stream_words(merged_words, layout<MergedEntry<F>>()),
                stream_words(found_words, layout<Found<F>>())};
  }
  return result;
}

}  // namespace

Merger::Merger(const Configuration& configuration, int lanes)
    : configuration_(configuration), table_(format_table(configuration.config())), lanes_(lanes) {
  if (!has_objects(configuration.config())) {
    throw ref::Error(fmt::format("configuration {} knows no objects: take one with object_bits", configuration.name()));
  }
  make_engine(configuration, lanes);  // refuses a number of lanes that there is not
}

MergeResult Merger::run(const MergeInput& input, std::vector<StreamWords>* streams) const {
  check(input, configuration_);
  return with_stamp<MergeResult>(lanes_, [&](auto stamp) {
    using F = RuntimeFormats<decltype(stamp)>;
    F::activate(configuration_.config(), table_);
    return merge_run<F>(input, streams);
  });
}

MergeResult Merger::run(const MergeInput& input) const { return run(input, nullptr); }

MergeResult Merger::capture(const MergeInput& input, std::vector<StreamWords>& streams) const { return run(input, &streams); }

std::vector<Layout> Merger::layouts() const {
  return with_stamp<std::vector<Layout>>(lanes_, [&](auto stamp) -> std::vector<Layout> {
    using F = RuntimeFormats<decltype(stamp)>;
    F::activate(configuration_.config(), table_);
    return {layout<Merge<F>>(), layout<StoredEntry<F>>(), layout<Entry<F>>(), layout<MergedEntry<F>>(), layout<Found<F>>()};
  });
}

}  // namespace halfspace::vectors
