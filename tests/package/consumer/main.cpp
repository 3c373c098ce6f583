// SPDX-License-Identifier: Apache-2.0
// A triangle of 64 by 64 pixels through the kernels of configuration `low`, four pixels a stamp.
#include <cstdio>
#include <hls/formats/configs/low.hpp>
#include <hls/pipeline/pipeline.hpp>

using namespace halfspace;
using F = Formats<Low, Stamp4>;

static Buffers<F> buffers;

int main() {
  const Frame<F> frame{from_raw<F::X>(80), from_raw<F::Y>(80), F::Colour(), F::Colour(), F::Colour()};
  Triangle<F> triangle{};
  triangle.last = from_raw<Bit>(1);
  triangle.index = from_raw<F::Index>(1);
  triangle.x[1] = triangle.y[2] = from_raw<F::Coord>(64 << F::kSubpixelBits);
  for (int vertex = 0; vertex < 3; ++vertex) triangle.g[vertex] = from_raw<F::Colour>(255);
  Streams<F> streams;
  streams.triangle.write(triangle);
  pipeline_triangle(frame, streams, buffers);
  pipeline_planes(streams, buffers);
  int green = 0;
  for (int y = 0; y * F::kLanesY < 80; ++y) {
    for (pipeline_scan(frame, y, streams, buffers); !streams.scan.empty();) {
      pipeline_shade(frame, streams, buffers);
      const Pixel<F> pixel = streams.pixel.read();
      for (int lane = 0; lane < F::kLanes; ++lane) green += raw(pixel.g[lane]) == 255;
    }
  }
  // Centres with x + y + 1 < 64: the lower right edge is its neighbour's.
  std::printf("%d green pixels\n", green);
  return green == 63 * 64 / 2 ? 0 : 1;
}
