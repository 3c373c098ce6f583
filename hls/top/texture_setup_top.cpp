// SPDX-License-Identifier: Apache-2.0
#include "hls/texture/texture_setup.hpp"

#include "hls/top/tops.hpp"

using namespace halfspace;

extern "C" void texture_setup_top(Port<Attributes>& attributes, Port<TextureCoordinates>& coordinates,
                                  Port<TexturePlanes>& planes) {
  HS_STREAM_PORT(attributes)
  HS_STREAM_PORT(coordinates)
  HS_STREAM_PORT(planes)
  HS_STARTED
  using F = TopFormats;
  static_assert(F::kHasTexture, "texture_setup is of configurations with texture");
  View<Attributes> attributes_words(attributes);
  View<TextureCoordinates> coordinates_words(coordinates);
  View<TexturePlanes> planes_words(planes);
Words:
  while (!texture_setup(attributes_words, coordinates_words, planes_words)) {}
}
