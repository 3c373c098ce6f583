// SPDX-License-Identifier: Apache-2.0
#include "tb/report/describe.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace halfspace::tb {
namespace {

constexpr int kFieldsTold = 4;

std::string value_text(const Field& field, std::uint64_t raw) {
  char text[80];
  if (!field.is_signed && field.fraction == 0) {
    std::snprintf(text, sizeof text, "0x%llx", static_cast<unsigned long long>(raw));
    return text;
  }
  const int unused = 64 - field.width;
  const double integer = field.is_signed ? double(std::int64_t(raw << unused) >> unused) : double(raw);
  std::snprintf(text, sizeof text, "0x%llx (%.10g)", static_cast<unsigned long long>(raw),
                std::ldexp(integer, -field.fraction));
  return text;
}

std::string field_name(const Field& field, int lane) {
  return field.count == 1 ? field.name : field.name + "[" + std::to_string(lane) + "]";
}

// An unsigned integer of which a word has one: a stamp's position, a triangle's index.
const Field* whole_number(const Stream& stream, const char* name) {
  const Field* const field = stream.find(name);
  return field && !field->is_signed && field->fraction == 0 ? field : nullptr;
}

std::string pixel_text(const WordPlace& place, int lane) {
  const Field* const x = whole_number(*place.stream, "x");
  const Field* const y = whole_number(*place.stream, "y");
  if (x == nullptr || y == nullptr || x->count != 1 || y->count != 1) return "";
  // Of a stamp a word has an index, or colours in lanes; others are of one pixel.
  const bool of_stamp = std::any_of(place.stream->fields.begin(), place.stream->fields.end(),
                                    [](const Field& field) { return field.count > 1 || field.name == "mask"; });
  const int lanes_x = of_stamp ? place.vectors->lanes_x : 1, lanes_y = of_stamp ? place.vectors->lanes_y : 1;
  const std::uint32_t* const word = place.stream->words[place.word];
  const std::uint64_t left = x->raw(word) * unsigned(lanes_x), top = y->raw(word) * unsigned(lanes_y);
  const auto point = [&](int dx, int dy) {
    return "(" + std::to_string(left + unsigned(dx)) + ", " + std::to_string(top + unsigned(dy)) + ")";
  };
  if (lane >= 0) return ", pixel " + point(lane % lanes_x, lane / lanes_x);
  if (lanes_x * lanes_y == 1) return ", pixel " + point(0, 0);
  return ", pixels " + point(0, 0) + "–" + point(lanes_x - 1, lanes_y - 1);
}

std::string cycle_text(const WordPlace& place) {
  return place.cycle < 0 ? "" : ", cycle " + std::to_string(place.cycle);
}

std::string triangle_text(const WordPlace& place, int lane) {
  const Stream* stream = place.stream;
  const Field* index = whole_number(*stream, "index");
  if (index == nullptr && !stream->context.empty()) {
    stream = place.vectors->find(stream->context);
    if (stream == nullptr || stream->words.size() <= place.word) return "";
    index = whole_number(*stream, "index");
  }
  if (index == nullptr || (index->count > 1 && (lane < 0 || lane >= index->count))) return "";
  const std::uint64_t triangle = index->raw(stream->words[place.word], index->count > 1 ? lane : 0);
  return triangle == 0 ? ", no triangle" : ", triangle " + std::to_string(triangle);
}

}  // namespace

std::string describe_stream(const Stream& stream) { return stream.name + " (" + stream.from + " → " + stream.to + ")"; }

std::string describe_fields(const Stream& stream, const std::uint32_t* word) {
  std::string text;
  for (const Field& field : stream.fields) {
    for (int lane = 0; lane < field.count; ++lane) {
      text += (text.empty() ? "" : ", ") + field_name(field, lane) + " " + value_text(field, field.raw(word, lane));
    }
  }
  return text;
}

std::string describe_mismatch(const WordPlace& place, const std::uint32_t* got) {
  const std::uint32_t* const expected = place.stream->words[place.word];
  int differences = 0, first_lane = -1;
  std::string fields;
  for (const Field& field : place.stream->fields) {
    for (int lane = 0; lane < field.count; ++lane) {
      const std::uint64_t want = field.raw(expected, lane), have = field.raw(got, lane);
      if (want == have) continue;
      if (differences == 0 && field.count > 1) first_lane = lane;
      if (differences++ >= kFieldsTold) continue;
      fields += (fields.empty() ? "" : ", ") + field_name(field, lane) + " expected " + value_text(field, want) +
                " got " + value_text(field, have);
    }
  }
  if (differences == 0) fields = "bits that no field of the manifest names differ";
  if (differences > kFieldsTold) fields += ", and " + std::to_string(differences - kFieldsTold) + " more fields";
  return place.stream->name + " word " + std::to_string(place.word) + " (" + place.stream->from + " → " +
         place.stream->to + "), frame " + std::to_string(place.frame) + place.note + triangle_text(place, first_lane) +
         pixel_text(place, first_lane) + cycle_text(place) + ": " + fields;
}

}  // namespace halfspace::tb
