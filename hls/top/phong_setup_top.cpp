// SPDX-License-Identifier: Apache-2.0
// Of a configuration with Phong shading: HALFSPACE_TOP_CONFIG names it. One word of normals, of the triangle of the
// attributes.
#include "hls/shade/phong_setup.hpp"
#include "hls/top/fields.hpp"

using namespace halfspace;

extern "C" void phong_setup_top(const std::int64_t attributes[kAttributesFields],
                                const std::int64_t normals[kNormalsFields],
                                std::int64_t normal_planes[kNormalPlanesFields]) {
  using F = TopFormats;
  static_assert(F::kPhong, "phong_setup is of configurations with Phong shading");
  Stream<Attributes<F>> in;
  Stream<Normals<F>> given;
  Stream<NormalPlanes<F>> out;
  in.write(read_fields<Attributes<F>>(attributes));
  given.write(read_fields<Normals<F>>(normals));
  phong_setup(in, given, out);
  write_fields(out.read(), normal_planes);
}
