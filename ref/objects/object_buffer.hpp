// SPDX-License-Identifier: Apache-2.0
// A buffer that knows which object each pixel shows.
//
// Objects are numbered from 1 on in the order in which they are drawn, triangles in that of their object. A fragment
// has a *key*, depth first, then the object's number; a pixel shows the least key, and of equal ones, which are of
// one object, the first drawn. That is the depth test less, first drawn wins, of a frame that draws all objects in
// order; and as a least element does not depend on the order, objects may come in any, come again, and be spread over
// buffers that are merged.
#ifndef HALFSPACE_REF_OBJECTS_OBJECT_BUFFER_HPP_
#define HALFSPACE_REF_OBJECTS_OBJECT_BUFFER_HPP_

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace halfspace::ref {

// Pixels from (x0, y0) up to, not including, (x1, y1).
struct Box {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  bool empty() const { return x0 >= x1 || y0 >= y1; }
  std::uint64_t pixels() const { return empty() ? 0 : std::uint64_t(x1 - x0) * std::uint64_t(y1 - y0); }
  bool holds(int x, int y) const { return x >= x0 && x < x1 && y >= y0 && y < y1; }
  bool meets(const Box& o) const {
    return std::max(x0, o.x0) < std::min(x1, o.x1) && std::max(y0, o.y0) < std::min(y1, o.y1);
  }
  void add(const Box& o) {
    if (o.empty()) return;
    *this = empty() ? o : Box{std::min(x0, o.x0), std::min(y0, o.y0), std::max(x1, o.x1), std::max(y1, o.y1)};
  }
  void add(int x, int y) { add(Box{x, y, x + 1, y + 1}); }
  Box cut(const Box& o) const {
    return {std::max(x0, o.x0), std::max(y0, o.y0), std::min(x1, o.x1), std::min(y1, o.y1)};
  }
};

struct ObjectPixel {
  std::uint64_t key;                   // depth << 32 | object; of background the largest depth, and no object
  std::uint32_t triangle;              // of the object
  std::array<std::uint8_t, 4> colour;  // r, g, b, 255; 0, 0, 0, 0 as long as nobody has shaded it

  std::uint32_t depth() const { return std::uint32_t(key >> 32); }
  std::uint32_t object() const { return std::uint32_t(key); }
};

constexpr std::uint64_t object_key(std::uint64_t depth, std::uint32_t object) { return depth << 32 | object; }

class ObjectBuffer {
 public:
  ObjectBuffer(int width, int height, std::uint32_t full_depth);

  int width() const { return width_; }
  int height() const { return height_; }
  Box frame() const { return {0, 0, width_, height_}; }
  const ObjectPixel& background() const { return background_; }
  ObjectPixel& at(int x, int y) { return pixels_[std::size_t(y) * width_ + x]; }
  const ObjectPixel& at(int x, int y) const { return pixels_[std::size_t(y) * width_ + x]; }

  void clear(const Box&);
  // The Z-test of a fragment.
  void test(int x, int y, std::uint64_t key, std::uint32_t triangle) {
    ObjectPixel& pixel = at(x, y);
    if (key < pixel.key) pixel = {key, triangle, {}};
  }
  // Pixels of the box that show the object: what the occlusion query asks.
  std::uint64_t count(std::uint32_t object, const Box&) const;
  // Makes them background. Returns the least box around them.
  Box erase(std::uint32_t object, const Box&);

 private:
  int width_, height_;
  ObjectPixel background_;
  std::vector<ObjectPixel> pixels_;
};

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_OBJECTS_OBJECT_BUFFER_HPP_
