// SPDX-License-Identifier: Apache-2.0
#include "hls/shade/phong_setup.hpp"

#include "hls/top/tops.hpp"

using namespace halfspace;

extern "C" void phong_setup_top(Port<Attributes>& attributes, Port<Normals>& normals, Port<NormalPlanes>& planes) {
  HS_STREAM_PORT(attributes)
  HS_STREAM_PORT(normals)
  HS_STREAM_PORT(planes)
  HS_STARTED
  using F = TopFormats;
  static_assert(F::kPhong, "phong_setup is of Phong shading");
  View<Attributes> attributes_words(attributes);
  View<Normals> normals_words(normals);
  View<NormalPlanes> planes_words(planes);
Words:
  while (!phong_setup(attributes_words, normals_words, planes_words)) {}
}
