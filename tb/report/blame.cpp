// SPDX-License-Identifier: Apache-2.0
#include "tb/report/blame.hpp"

#include <algorithm>
#include <set>

namespace halfspace::tb {
namespace {

using Names = std::set<std::string>;

// Whoever reads the memory `buffers` is scan_index, and `tdbs` the shaders behind it; what geometry answers comes from
// what it is told, but triangles do not.
Names readers_of(const Vectors& vectors, const std::string& memory) {
  Names readers;
  const Stream* const scan = vectors.find("scan");
  if (memory == "buffers" && scan) readers.insert(scan->from);
  if (memory == "tdbs" && scan) readers.insert({scan->to, vectors.find(vectors.shown())->from});
  for (const Stream& stream : vectors.streams) {
    if (memory == "geometry" && stream.from == memory && stream.name != "triangle") readers.insert(stream.to);
  }
  return readers;
}

// All that stands behind a unit, itself not.
Names behind(const Vectors& vectors, const std::string& unit) {
  Names found;
  std::vector<std::string> open{unit};
  while (!open.empty()) {
    const std::string at = open.back();
    open.pop_back();
    for (const Stream& stream : vectors.streams) {
      if (stream.from != at) continue;
      Names next = readers_of(vectors, stream.to);
      next.insert(stream.to);
      for (const std::string& name : next) {
        if (name != "geometry" && name != unit && found.insert(name).second) open.push_back(name);
      }
    }
  }
  return found;
}

// That it has its input, or had all of it, and what it sends lacks and is not offered.
bool stands_still(const Result& result, const Vectors& vectors, const std::string& unit) {
  for (const StreamResult& sent : result.streams) {
    if (sent.from == unit && sent.missing != 0 && result.ends.at(sent.name).valid) return false;
  }
  for (const Stream& stream : vectors.streams) {
    const auto end = result.ends.find(stream.name);
    if (stream.to != unit || end == result.ends.end()) continue;
    const auto seen = std::find_if(result.streams.begin(), result.streams.end(),
                                   [&](const StreamResult& r) { return r.name == stream.name; });
    const bool had_all = seen == result.streams.end() ? !end->second.valid : seen->missing == 0;
    if (!had_all && !end->second.valid) return false;
  }
  return true;
}

}  // namespace

void blame(const Vectors& vectors, Result* result) {
  std::vector<std::string> guilty;
  Names innocent;
  const auto accuse = [&](const std::string& unit) {
    if (innocent.count(unit) || std::find(guilty.begin(), guilty.end(), unit) != guilty.end()) return;
    guilty.push_back(unit);
    innocent.merge(behind(vectors, unit));
  };
  for (const StreamResult& stream : result->streams) {
    if (stream.mismatches != 0) accuse(stream.from);
  }
  const bool only_missing = guilty.empty();
  for (const StreamResult& stream : result->streams) {
    if (only_missing && guilty.empty() && stream.missing != 0 && stands_still(*result, vectors, stream.from))
      accuse(stream.from);
  }
  for (const StreamResult& stream : result->streams) {
    const bool own = guilty.empty() || std::find(guilty.begin(), guilty.end(), stream.from) != guilty.end();
    for (const std::string& failure : stream.failures) {
      const bool lacks = failure.rfind("missing: ", 0) == 0;
      const bool follows = !own || (lacks && !only_missing);
      (follows ? result->follows : result->failures).push_back(failure);
    }
  }
  if (!guilty.empty()) result->first_wrong = guilty.front();
}

}  // namespace halfspace::tb
