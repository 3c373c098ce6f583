// SPDX-License-Identifier: Apache-2.0
// shade_setup of a configuration with lighting: HALFSPACE_TOP_CONFIG names it. One word of colours, of the triangle of
// the attributes.
#include "hls/setup/shade_setup.hpp"
#include "hls/top/fields.hpp"

using namespace halfspace;

extern "C" void shade_setup_lit_top(const std::int64_t attributes[kAttributesFields],
                                    const std::int64_t colours[kColoursFields], std::int64_t planes[kPlanesFields]) {
  using F = TopFormats;
  static_assert(F::kHasLighting, "colours come alone in configurations with lighting");
  Stream<Attributes<F>> in;
  Stream<Colours<F>> lit;
  Stream<Planes<F>> out;
  in.write(read_fields<Attributes<F>>(attributes));
  lit.write(read_fields<Colours<F>>(colours));
  shade_setup(in, lit, out);
  write_fields(out.read(), planes);
}
