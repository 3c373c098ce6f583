// SPDX-License-Identifier: Apache-2.0
#include "hls/top/fields.hpp"

using namespace halfspace;

extern "C" void shade_setup_top(const std::int64_t attributes[kAttributesFields], std::int64_t planes[kPlanesFields]) {
  using F = TopFormats;
  Stream<Attributes<F>> in;
  Stream<Planes<F>> out;
  in.write(read_fields<Attributes<F>>(attributes));
  shade_setup(in, out);
  write_fields(out.read(), planes);
}
