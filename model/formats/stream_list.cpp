// SPDX-License-Identifier: Apache-2.0
#include "model/formats/stream_list.hpp"

#include <algorithm>
#include <cstring>

namespace halfspace::model {
namespace {

// What the table asks of a configuration, one bit each.
struct Flags {
  static inline thread_local bool kHasLighting, kPhong, kHasTexture, kHasMotion, kHasObjects, kTestsPlanes, kDeferred,
      kShades, kUpConverts, kGivesIndices;

  // Whether there is such a configuration.
  static bool set(unsigned bits) {
    kTestsPlanes = bits & 1, kHasLighting = bits & 2, kPhong = bits & 4;
    kHasTexture = bits & 8, kShades = !(bits & 16), kHasObjects = bits & 32, kUpConverts = bits & 64;
    kHasMotion = !kShades || kUpConverts;
    kGivesIndices = bits & 128;
    kDeferred = kHasLighting || kHasTexture || kHasMotion;
    return !(kPhong && !kHasLighting) && !(!kShades && (kHasLighting || kHasTexture || kUpConverts)) &&
           !(kHasObjects && (kTestsPlanes || kHasMotion)) && !(kGivesIndices && kUpConverts);
  }
};

template <class F>
std::vector<StreamRow> rows() {
#define HS_ROW(...) HS_STREAM_ROW(__VA_ARGS__),
  return {HS_PIPELINE_STREAMS(HS_ROW) HS_COMPENSATE_STREAMS(HS_ROW) HS_FILM_STREAMS(HS_ROW) HS_MERGE_STREAMS(HS_ROW)
              HS_STATIC_STREAMS(HS_ROW)};
#undef HS_ROW
}

void add(std::vector<std::string>& names, const std::string& name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

}  // namespace

std::vector<ListedStream> all_streams() {
  std::vector<ListedStream> list;
  for (unsigned bits = 0; bits < 256; ++bits) {
    if (!Flags::set(bits)) continue;
    for (const StreamRow& row : rows<Flags>()) {
      const auto is_row = [&](const ListedStream& s) {
        return !std::strcmp(s.row.name, row.name) && !std::strcmp(s.row.record, row.record);
      };
      auto found = std::find_if(list.begin(), list.end(), is_row);
      if (found == list.end()) found = list.insert(list.end(), {row, {}, {}});
      if (row.is_there) add(found->from, row.from), add(found->to, row.to);
    }
  }
  return list;
}

const char* kind_name(StreamKind kind) {
  switch (kind) {
    case StreamKind::kStream: return "stream";
    case StreamKind::kStored: return "stored";
    case StreamKind::kLoaded: return "loaded";
    case StreamKind::kFetch: return "fetch";
    case StreamKind::kProbe: return "probe";
  }
  return "";
}

std::string record_name(const StreamRow& row) { return std::string(row.record, std::strcspn(row.record, "<")); }

bool is_port(const StreamRow& row) {
  static const char* const kOutside[] = {"host", "geometry", "motion_compensate", "ztest_merge", "frame"};
  return std::any_of(std::begin(kOutside), std::end(kOutside),
                     [&](const char* end) { return !std::strcmp(row.from, end) || !std::strcmp(row.to, end); });
}

}  // namespace halfspace::model
