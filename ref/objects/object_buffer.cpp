// SPDX-License-Identifier: Apache-2.0
#include "ref/objects/object_buffer.hpp"

namespace halfspace::ref {

ObjectBuffer::ObjectBuffer(int width, int height, std::uint32_t full_depth)
    : width_(width),
      height_(height),
      background_{object_key(full_depth, 0), 0, {}},
      pixels_(std::size_t(width) * height, background_) {}

void ObjectBuffer::clear(const Box& box) {
  for (int y = box.y0; y < box.y1; ++y) std::fill(&at(box.x0, y), &at(box.x0, y) + (box.x1 - box.x0), background_);
}

std::uint64_t ObjectBuffer::count(std::uint32_t object, const Box& box) const {
  std::uint64_t pixels = 0;
  for (int y = box.y0; y < box.y1; ++y) {
    for (int x = box.x0; x < box.x1; ++x) pixels += at(x, y).object() == object;
  }
  return pixels;
}

Box ObjectBuffer::erase(std::uint32_t object, const Box& box) {
  Box erased;
  for (int y = box.y0; y < box.y1; ++y) {
    for (int x = box.x0; x < box.x1; ++x) {
      if (at(x, y).object() != object) continue;
      at(x, y) = background_;
      erased.add(x, y);
    }
  }
  return erased;
}

}  // namespace halfspace::ref
