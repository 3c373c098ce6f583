// SPDX-License-Identifier: Apache-2.0
// The rasterizer of whatever OpenGL the machine has, without a window: of a GPU where there is one, else of Mesa's
// llvmpipe. Triangles as they were snapped, on a grid of 8 sub-pixel bits that its own snapping does not move.
#ifndef HALFSPACE_TESTS_RASTER_OPENGL_HPP_
#define HALFSPACE_TESTS_RASTER_OPENGL_HPP_

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <cstdint>
#include <string>
#include <vector>

#include "ref/geometry/snap.hpp"

namespace halfspace::tests {

// Of fragment k of triangle i every pixel adds this: two sets of triangles with the same sum are the same set, but for
// one chance in 2^32.
inline std::uint32_t fragment_hash(std::uint32_t triangle) {
  std::uint32_t h = triangle * 2654435761u + 0x9e3779b9u;
  h ^= h >> 16, h *= 0x85ebca6bu, h ^= h >> 13;
  return h;
}

class OpenGl {
 public:
  // Of frames of that size. Throws std::runtime_error with a remedy where there is no OpenGL 4.5.
  OpenGl(int width, int height);
  ~OpenGl();
  OpenGl(const OpenGl&) = delete;
  OpenGl& operator=(const OpenGl&) = delete;

  const std::string& renderer() const { return renderer_; }
  int subpixel_bits() const { return subpixel_bits_; }

  // Without a depth test: the sum of fragment_hash over the triangles that cover each pixel, row 0 on top; and how many
  // fragments there were.
  struct Coverage {
    std::vector<std::uint32_t> sum;
    std::uint64_t fragments = 0;
  };
  Coverage coverage(const ref::SnappedList& scene);

  // With the depth test less on a buffer of 32 bits of float: the triangle that each pixel shows, 0: none, and its
  // depth, of 0 … 1.
  struct Visible {
    std::vector<std::uint32_t> index;
    std::vector<float> depth;
  };
  Visible visible(const ref::SnappedList& scene);

 private:
  void make_context();
  void calibrate();
  void draw(const ref::SnappedList& scene);
  void release();

  int width_, height_, subpixel_bits_ = 0;
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
  std::string renderer_;
  GLuint program_ = 0, framebuffer_ = 0, colour_ = 0, depth_ = 0, array_ = 0, vertices_ = 0, sums_ = 0;
};

}  // namespace halfspace::tests

#endif  // HALFSPACE_TESTS_RASTER_OPENGL_HPP_
