// SPDX-License-Identifier: Apache-2.0
// The table of streams (hls/formats/streams.hpp) for people and tools.
#ifndef HALFSPACE_MODEL_FORMATS_STREAM_LIST_HPP_
#define HALFSPACE_MODEL_FORMATS_STREAM_LIST_HPP_

#include <string>
#include <vector>

#include "hls/formats/streams.hpp"

namespace halfspace::model {

// A row, with all units that send or take the stream in one configuration or another.
struct ListedStream {
  StreamRow row;
  std::vector<std::string> from, to;
};
// Every row, in flow order.
std::vector<ListedStream> all_streams();

// "stream", "stored", "loaded", "fetch" or "probe".
const char* kind_name(StreamKind kind);
// The record's name alone.
std::string record_name(const StreamRow& row);
// Whether a stream of hs_pipeline comes or goes at one of its ports.
bool is_port(const StreamRow& row);

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_FORMATS_STREAM_LIST_HPP_
