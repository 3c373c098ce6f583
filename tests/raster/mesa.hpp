// SPDX-License-Identifier: Apache-2.0
// Mesa's llvmpipe as an outside oracle and rival: screen-space triangles through OSMesa, one thread.
#ifndef HALFSPACE_TESTS_RASTER_MESA_HPP_
#define HALFSPACE_TESTS_RASTER_MESA_HPP_

#include <GL/osmesa.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "ref/geometry/snap.hpp"
#include "ref/scene/texture.hpp"

namespace halfspace::tests {

class Mesa {
 public:
  Mesa(int width, int height) : width_(width), height_(height), pixels_(std::size_t(width) * height) {
    setenv("GALLIUM_DRIVER", "llvmpipe", 1);
    setenv("LP_NUM_THREADS", "0", 1);
    const int attributes[] = {
        OSMESA_FORMAT, OSMESA_RGBA, OSMESA_DEPTH_BITS, 24, OSMESA_PROFILE, OSMESA_COMPAT_PROFILE, 0};
    context_ = OSMesaCreateContextAttribs(attributes, nullptr);
    if (!context_ || !OSMesaMakeCurrent(context_, pixels_.data(), GL_UNSIGNED_BYTE, width, height)) {
      throw std::runtime_error("OSMesa gives no context: is libosmesa6 installed?");
    }
    const std::string renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    if (renderer.find("llvmpipe") == std::string::npos) {
      throw std::runtime_error("OSMesa renders with " + renderer + ", and only llvmpipe covers exactly");
    }
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    // Mesa's row 0 is our top row: its tie rule is top-left in memory, and depth runs from 0 to 1.
    glOrtho(0, width, 0, height, 0, -1);
    glDisable(GL_CULL_FACE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
  }
  ~Mesa() { OSMesaDestroyContext(context_); }
  Mesa(const Mesa&) = delete;
  Mesa& operator=(const Mesa&) = delete;

  // What draw() takes: positions in pixels and depths, exact in float when the frame's sides are powers of two.
  struct Arrays {
    std::vector<float> positions;
    std::vector<std::uint8_t> colours;
  };
  static Arrays arrays(const ref::SnappedList& scene) {
    Arrays result;
    const float one = float(1 << scene.format.subpixel_bits);
    const double full = double((std::uint64_t(1) << scene.format.depth_bits) - 1);
    for (const ref::SnappedTriangle& t : scene.triangles) {
      for (int v = 0; v < 3; ++v) {
        result.positions.insert(result.positions.end(),
                                {float(t.x[v]) / one, float(t.y[v]) / one, float(t.depth[v] / full)});
        result.colours.insert(result.colours.end(), {t.rgb[v][0], t.rgb[v][1], t.rgb[v][2], 255});
      }
    }
    return result;
  }

  // A texture that repeats and multiplies the colours of what is drawn from now on.
  void texture(const ref::Texture& texture, ref::TextureFilter filter) {
    const GLint by = filter == ref::TextureFilter::kNearest ? GL_NEAREST : GL_LINEAR;
    glEnable(GL_TEXTURE_2D);
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, texture.width, texture.height, 0, GL_RGB, GL_UNSIGNED_BYTE,
                 texture.texels.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, by);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, by);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    glHint(GL_PERSPECTIVE_CORRECTION_HINT, GL_NICEST);
  }

  void clear(float r, float g, float b, float a = 1) {
    glClearColor(r, g, b, a);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  }

  // The finished picture, RGBA, row 0 on top. Triangles inside the frame only: Mesa clips the others in floating point.
  const std::vector<std::uint32_t>& draw(const Arrays& arrays) { return draw(arrays.positions, 3, arrays.colours); }

  // Of positions in homogeneous coordinates (x·w, y·w, z·w, w), and texture coordinates (u, v).
  struct Textured {
    std::vector<float> positions, coordinates;
    std::vector<std::uint8_t> colours;
  };
  const std::vector<std::uint32_t>& draw(const Textured& textured) {
    glTexCoordPointer(2, GL_FLOAT, 0, textured.coordinates.data());
    return draw(textured.positions, 4, textured.colours);
  }

 private:
  const std::vector<std::uint32_t>& draw(const std::vector<float>& positions, int components,
                                         const std::vector<std::uint8_t>& colours) {
    glVertexPointer(components, GL_FLOAT, 0, positions.data());
    glColorPointer(4, GL_UNSIGNED_BYTE, 0, colours.data());
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(colours.size() / 4));
    glFinish();
    return pixels_;
  }

  int width_, height_;
  std::vector<std::uint32_t> pixels_;
  OSMesaContext context_ = nullptr;
};

}  // namespace halfspace::tests

#endif  // HALFSPACE_TESTS_RASTER_MESA_HPP_
