// SPDX-License-Identifier: Apache-2.0
#include "tb/system/scene.hpp"

#include <string>

namespace halfspace::tb {
namespace {

// 0 where the record has no such field; a signed one with its sign.
std::int64_t value(const Stream& stream, const std::uint32_t* word, const std::string& name) {
  const Field* const field = stream.find(name);
  if (field == nullptr) return 0;
  const std::uint64_t raw = field->raw(word);
  if (!field->is_signed || (raw >> (field->width - 1)) == 0) return std::int64_t(raw);
  return std::int64_t(raw) - (std::int64_t(1) << field->width);
}

// A field of vertex `i`, or of all where there is one for them.
std::int64_t of_vertex(const Stream& stream, const std::uint32_t* word, const std::string& name, int i) {
  const std::string numbered = name + std::to_string(i);
  return value(stream, word, stream.find(numbered) ? numbered : name);
}

const Stream& triangle_of(const Vectors& vectors) { return *vectors.find("triangle"); }

}  // namespace

bool is_in_order(const Vectors& vectors, std::size_t frame) {
  const Stream& stream = triangle_of(vectors);
  if (stream.find("index") == nullptr || triangles_of(vectors, frame).empty()) return true;
  const Segment words = segment_of(stream, frame);
  for (std::size_t n = words.begin; n < words.end; ++n) {
    if (std::size_t(value(stream, stream.words[n], "index")) != n - words.begin + 1) return false;
  }
  return true;
}

std::vector<hs_triangle> triangles_of(const Vectors& vectors, std::size_t frame) {
  const Stream& stream = triangle_of(vectors);
  const Segment words = segment_of(stream, frame);
  std::vector<hs_triangle> triangles;
  for (std::size_t n = words.begin; n < words.end; ++n) {
    const std::uint32_t* const word = stream.words[n];
    hs_triangle triangle = {};
    bool any = false;
    for (int i = 0; i < 3; ++i) {
      hs_vertex& vertex = triangle.vertex[i];
      vertex.x = std::int32_t(of_vertex(stream, word, "x", i));
      vertex.y = std::int32_t(of_vertex(stream, word, "y", i));
      vertex.depth = std::uint32_t(of_vertex(stream, word, "depth", i));
      vertex.r = std::uint16_t(of_vertex(stream, word, "r", i));
      vertex.g = std::uint16_t(of_vertex(stream, word, "g", i));
      vertex.b = std::uint16_t(of_vertex(stream, word, "b", i));
      any = any || vertex.x != 0 || vertex.y != 0;
    }
    // The one that carries `last` alone.
    if (!any && words.end - words.begin == 1 && value(stream, word, "index") == 0) return {};
    triangles.push_back(triangle);
  }
  return triangles;
}

std::vector<hs_answer> answers_of(const Vectors& vectors, std::size_t frame) {
  std::vector<hs_answer> answers;
  const Stream& visible = *vectors.find("visible");
  const Stream* const normals = vectors.find("normals");
  const Stream* const coordinates = vectors.find("texture_coordinates");
  const Segment words = segment_of(visible, frame);
  std::size_t of_normals = normals ? segment_of(*normals, frame).begin : 0;
  std::size_t of_coordinates = coordinates ? segment_of(*coordinates, frame).begin : 0;
  for (std::size_t n = words.begin; n < words.end; ++n) {
    hs_answer answer = {};
    const bool shown = value(visible, visible.words[n], "visible") != 0;
    if (shown && normals) {
      const std::uint32_t* const word = normals->words[of_normals++];
      answer.material = std::uint32_t(value(*normals, word, "material"));
      for (int i = 0; i < 3; ++i) {
        answer.normal[i][0] = std::int32_t(of_vertex(*normals, word, "x", i));
        answer.normal[i][1] = std::int32_t(of_vertex(*normals, word, "y", i));
        answer.normal[i][2] = std::int32_t(of_vertex(*normals, word, "z", i));
      }
    }
    if (shown && coordinates) {
      const std::uint32_t* const word = coordinates->words[of_coordinates++];
      answer.texture = std::uint32_t(value(*coordinates, word, "texture"));
      answer.repeats = std::uint32_t(value(*coordinates, word, "repeats"));
      for (int i = 0; i < 3; ++i) {
        answer.coordinate[i][0] = std::uint32_t(of_vertex(*coordinates, word, "s", i));
        answer.coordinate[i][1] = std::uint32_t(of_vertex(*coordinates, word, "t", i));
        answer.coordinate[i][2] = std::uint32_t(of_vertex(*coordinates, word, "q", i));
      }
    }
    answers.push_back(answer);
  }
  return answers;
}

std::vector<std::uint64_t> values_of(const Stream& stream, std::size_t frame, std::vector<std::uint8_t>* widths) {
  std::vector<std::uint64_t> values;
  widths->clear();
  for (const Field& field : stream.fields) widths->push_back(std::uint8_t(field.width));
  const Segment words = segment_of(stream, frame);
  for (std::size_t n = words.begin; n < words.end; ++n) {
    for (const Field& field : stream.fields) values.push_back(field.raw(stream.words[n]));
  }
  return values;
}

Picture picture_of(const Vectors& vectors, std::size_t frame) {
  const Stream& stream = *vectors.find("pixel");
  const Field &x_field = stream.need("x", "a picture"), &y_field = stream.need("y", "a picture");
  const Field* const channels[3] = {&stream.need("r", "a picture"), &stream.need("g", "a picture"),
                                    &stream.need("b", "a picture")};
  const Frame& size = vectors.frames[frame];
  Picture picture{size.width, size.height, {}};
  picture.pixels.assign(std::size_t(size.width) * size.height, 0);
  const Segment words = segment_of(stream, frame);
  for (std::size_t n = words.begin; n < words.end; ++n) {
    const std::uint32_t* const word = stream.words[n];
    for (int lane = 0; lane < vectors.lanes(); ++lane) {
      const std::size_t x = x_field.raw(word) * unsigned(vectors.lanes_x) + unsigned(lane % vectors.lanes_x);
      const std::size_t y = y_field.raw(word) * unsigned(vectors.lanes_y) + unsigned(lane / vectors.lanes_x);
      if (x >= size.width || y >= size.height) continue;
      std::uint32_t rgb = 0;
      for (const Field* channel : channels) {
        const std::uint64_t full = (std::uint64_t(1) << channel->width) - 1;
        rgb = rgb << 8 | std::uint32_t((channel->raw(word, lane) * 255 + full / 2) / full);
      }
      picture.pixels[y * size.width + x] = rgb;
    }
  }
  return picture;
}

}  // namespace halfspace::tb
