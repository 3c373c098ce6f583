// SPDX-License-Identifier: Apache-2.0
#include "model/objects/merge.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "model/formats/runtime_formats.hpp"
#include "model/formats/stamps.hpp"
#include "model/objects/merge_impl.hpp"
#include "ref/error.hpp"

namespace halfspace::model {
namespace {

void check(const MergeInput& input, const Configuration& configuration) {
  const Config c = configuration.config();
  const auto refuse = [&](const std::string& why) {
    throw ref::Error(fmt::format("a merge in configuration {}: {}", configuration.name(), why));
  };
  if (input.width < 1 || input.width > c.width || input.height < 1 || input.height > c.height) {
    refuse(fmt::format("buffers of {}x{} pixels, and {}x{} is the largest: raise its width and height", input.width,
                       input.height, c.width, c.height));
  }
  const ref::Box cut = input.box.cut({0, 0, input.width, input.height});
  if (input.box.empty() || cut.x0 != input.box.x0 || cut.y0 != input.box.y0 || cut.x1 != input.box.x1 ||
      cut.y1 != input.box.y1) {
    refuse("its box is empty, or not inside the frame: cut it");
  }
  if (input.first >> c.object_bits != 0 || input.last >> c.object_bits != 0)
    refuse("an object of its range has no number: raise object_bits");
  const auto check_buffer = [&](const std::vector<RawEntry>& buffer) {
    if (buffer.size() != std::size_t(input.width) * input.height) refuse("a buffer is not of the size of the frame");
    const auto fits = [&](const RawEntry& e) {
      return e.depth <= ref::full_depth(c.depth_bits) && e.object >> c.object_bits == 0;
    };
    if (!std::all_of(buffer.begin(), buffer.end(), fits)) refuse("an entry has no room in its word: raise object_bits");
  };
  if (!input.stored) refuse("nothing is stored: give it an S-buffer");
  check_buffer(*input.stored);
  if (input.drawn) check_buffer(*input.drawn);
}

}  // namespace

Merger::Merger(const Configuration& configuration, int lanes)
    : Merger(configuration, format_table(configuration.config()), lanes) {}

Merger::Merger(const Configuration& configuration, const FormatTable& table, int lanes)
    : configuration_(configuration), table_(table), lanes_(lanes) {
  if (!has_objects(configuration.config())) {
    throw ref::Error(fmt::format("configuration {} knows no objects: take one with object_bits", configuration.name()));
  }
  stamp_size(lanes);  // refuses a number of lanes that there is not
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

MergeResult Merger::capture(const MergeInput& input, std::vector<StreamWords>& streams) const {
  return run(input, &streams);
}

std::vector<Layout> Merger::layouts() const {
  return with_stamp<std::vector<Layout>>(lanes_, [&](auto stamp) -> std::vector<Layout> {
    using F = RuntimeFormats<decltype(stamp)>;
    F::activate(configuration_.config(), table_);
    MergeStreams<F> streams;
    return stream_layouts(streams);
  });
}

}  // namespace halfspace::model
