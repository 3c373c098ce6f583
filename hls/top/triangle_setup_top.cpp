// SPDX-License-Identifier: Apache-2.0
#include "hls/top/fields.hpp"

using namespace halfspace;

// One triangle. Returns whether `attributes` was sent.
extern "C" int triangle_setup_top(int width, int height, const std::int64_t triangle[kTriangleFields],
                                  std::int64_t setup[kSetupFields], std::int64_t attributes[kAttributesFields]) {
  using F = TopFormats;
  Stream<Triangle<F>> in;
  Stream<Setup<F>> out;
  Stream<Attributes<F>> shade;
  in.write(read_fields<Triangle<F>>(triangle));
  triangle_setup(top_frame(width, height, 0), in, out, shade);
  write_fields(out.read(), setup);
  const bool sent = !shade.empty();
  if (sent) write_fields(shade.read(), attributes);
  return sent;
}
