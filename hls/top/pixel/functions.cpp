// SPDX-License-Identifier: Apache-2.0
#include "hls/top/pixel/functions.hpp"

#include "hls/motion/motion_field.hpp"
#include "hls/objects/ztest_merge.hpp"
#include "hls/shade/shade_gouraud.hpp"
#include "hls/shade/shade_phong.hpp"
#include "hls/texture/shade_texture.hpp"
#include "hls/top/ports/ports.hpp"

using namespace halfspace;
using F = TopFormats;
static_assert(F::kLanes == 1, "a pixel a word");

namespace {

template <class R, std::size_t N>
HS_INLINE inline R record_of(const std::uint64_t (&elements)[N]) {
  static_assert(PackedBits<R>::kBits <= 64 * int(N), "all of its elements");
  Packed<R> word = zero_word<PackedBits<R>::kWordBits>();
  constexpr int kElements = (PackedBits<R>::kBits + 63) / 64;
Elements:
  for (int i = 0; i < kElements; ++i) {
    HS_UNROLL
    set_bits<64>(word, 64 * i, elements[i]);
  }
  return unpacked<R>(word);
}
template <class R>
HS_INLINE inline R record_of(std::uint64_t element) {
  const std::uint64_t elements[] = {element};
  return record_of<R>(elements);
}
template <class R>
HS_INLINE inline std::uint64_t word_of(const R& record) {
  return bits<PackedBits<R>::kBits>(packed(record), 0);
}

HS_INLINE inline Pixel<F> pixel_at(const Scan<F>& in) {
  Pixel<F> out{};
  out.x = in.x;
  out.y = in.y;
  return out;
}

}  // namespace

std::uint64_t gouraud_pixel(std::uint64_t scan, std::uint64_t p0, std::uint64_t p1, std::uint64_t p2,
                            std::uint64_t p3) {
  const std::uint64_t planes[] = {p0, p1, p2, p3};
  const Bit covered[] = {from_raw<Bit>(1)};
  const Scan<F> in = record_of<Scan<F>>(scan);
  Pixel<F> out = pixel_at(in);
  gouraud_lanes(record_of<Planes<F>>(planes), covered, int(raw(in.x)), int(raw(in.y)), out);
  return word_of(out);
}

std::uint64_t phong_pixel(std::uint64_t scan, std::uint64_t p0, std::uint64_t p1, std::uint64_t p2, std::uint64_t p3,
                          std::uint64_t l0, std::uint64_t l1, std::uint64_t m0, std::uint64_t m1, std::uint64_t m2) {
  const std::uint64_t planes[] = {p0, p1, p2, p3}, light[] = {l0, l1}, material[] = {m0, m1, m2};
  const Scan<F> in = record_of<Scan<F>>(scan);
  const Rgb<F> colour = phong_pixel<F>(record_of<NormalPlanes<F>>(planes), record_of<Light<F>>(light),
                                       record_of<Material<F>>(material), int(raw(in.x)), int(raw(in.y)));
  Pixel<F> out = pixel_at(in);
  out.r[0] = colour.channel[0];
  out.g[0] = colour.channel[1];
  out.b[0] = colour.channel[2];
  return word_of(out);
}

std::uint64_t texel_address(std::uint64_t scan, std::uint64_t p0, std::uint64_t p1, std::uint64_t p2, std::uint64_t p3,
                            std::uint64_t texture) {
  const std::uint64_t planes[] = {p0, p1, p2, p3};
  const Scan<F> in = record_of<Scan<F>>(scan);
  const TexelFetch<F> fetch = texel_fetch<F>(record_of<TexturePlanes<F>>(planes), record_of<TextureEntry<F>>(texture),
                                             int(raw(in.x)), int(raw(in.y)));
  return std::uint64_t(raw(fetch.address[0]));
}

std::uint64_t textured_pixel(std::uint64_t lit, std::uint64_t texel) {
  const TexelFetch<F> nearest{};
  const TexelColour<F> texels[TextureMemory<F>::kBanks] = {record_of<TexelColour<F>>(texel)};
  Pixel<F> out = record_of<Pixel<F>>(lit);
  TexelColour<F> colour;
  colour.r = out.r[0];
  colour.g = out.g[0];
  colour.b = out.b[0];
  colour = textured_pixel<F>(colour, nearest, texels);
  out.r[0] = colour.r;
  out.g[0] = colour.g;
  out.b[0] = colour.b;
  return word_of(out);
}

std::uint64_t motion_vector(std::uint64_t scan, std::uint64_t p0, std::uint64_t p1, std::uint64_t p2, std::uint64_t p3,
                            std::uint64_t p4, std::uint64_t p5, std::uint64_t p6) {
  const std::uint64_t planes[] = {p0, p1, p2, p3, p4, p5, p6};
  const Scan<F> in = record_of<Scan<F>>(scan);
  Motion<F> out{};
  out.key[1] = key_vector<F>(record_of<MotionPlanes<F>>(planes).key[1], int(raw(in.x)), int(raw(in.y)));
  return bits<1 + 2 * F::Vector::kWidth>(packed(out), 0);
}

std::uint64_t merged_stamp(std::uint64_t merge, std::uint64_t stored, std::uint64_t entry) {
  return word_of(
      merge_stamp(record_of<Merge<F>>(merge), record_of<Entry<F>>(stored), record_of<Entry<F>>(entry)).entry);
}
