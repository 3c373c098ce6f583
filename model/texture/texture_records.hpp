// SPDX-License-Identifier: Apache-2.0
// Textures and coordinates of a TextureFrame as records, and into the table and the memory of the kernels.
#ifndef HALFSPACE_MODEL_TEXTURE_TEXTURE_RECORDS_HPP_
#define HALFSPACE_MODEL_TEXTURE_TEXTURE_RECORDS_HPP_

#include "hls/texture/shade_texture.hpp"
#include "model/texture/texture.hpp"

namespace halfspace::model {

// The words that went into the table.
template <class F>
std::vector<TextureEntry<F>> load_textures(const TextureFrame& frame, TextureTable<F>& table) {
  std::vector<TextureEntry<F>> words;
  Stream<TextureEntry<F>> stream;
  stream.tap(&words);
  for (std::size_t n = 0; n < frame.textures.size(); ++n) {
    TextureEntry<F> entry{};
    entry.texture = from_raw<typename F::TextureNumber>(n + 1);
    entry.base = from_raw<typename F::TexelAddress>(frame.textures[n].base);
    entry.log2_width = from_raw<typename F::Side>(frame.textures[n].log2_width);
    entry.log2_height = from_raw<typename F::Side>(frame.textures[n].log2_height);
    stream.write(entry);
    store_texture(stream, table);
  }
  return words;
}

template <class F>
std::vector<Texel<F>> load_texels(const TextureFrame& frame, TextureMemory<F>& memory) {
  std::vector<Texel<F>> words;
  Stream<Texel<F>> stream;
  stream.tap(&words);
  for (std::size_t n = 0; n < frame.texels.size(); ++n) {
    Texel<F> texel{};
    texel.address = from_raw<typename F::TexelAddress>(frame.texels[n].address);
    texel.r = from_raw<typename F::Colour>(frame.texels[n].rgb[0]);
    texel.g = from_raw<typename F::Colour>(frame.texels[n].rgb[1]);
    texel.b = from_raw<typename F::Colour>(frame.texels[n].rgb[2]);
    stream.write(texel);
    store_texel(stream, memory);
  }
  return words;
}

template <class F>
TextureCoordinates<F> coordinates_record(const RawCoordinates& in, int index, bool last) {
  TextureCoordinates<F> out{};
  out.last = from_raw<Bit>(last);
  out.index = from_raw<typename F::Index>(index);
  out.texture = from_raw<typename F::TextureNumber>(in.texture);
  out.repeats = from_raw<typename F::Repeats>(in.repeats);
  for (int v = 0; v < 3; ++v) {
    out.s[v] = from_raw<typename F::Coordinate>(in.s[v]);
    out.t[v] = from_raw<typename F::Coordinate>(in.t[v]);
    out.q[v] = from_raw<typename F::Coordinate>(in.q[v]);
  }
  return out;
}

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_TEXTURE_TEXTURE_RECORDS_HPP_
