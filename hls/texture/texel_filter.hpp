// SPDX-License-Identifier: Apache-2.0
// What a pixel makes of its texels: the filter, and the product with its colour. Of fetched words alone: a tool may
// pipeline textured_pixel() as it is.
#ifndef HALFSPACE_HLS_TEXTURE_TEXEL_FILTER_HPP_
#define HALFSPACE_HLS_TEXTURE_TEXEL_FILTER_HPP_

#include "hls/texture/texel_fetch.hpp"

namespace halfspace {

// From the even columns and rows of four texels to the odd ones: exact, then rounded once, half up.
template <class F>
typename F::Filtered bilinear(const typename F::Colour& even_even, const typename F::Colour& odd_even,
                              const typename F::Colour& even_odd, const typename F::Colour& odd_odd,
                              const TexelWeight& odd_column, const TexelWeight& odd_row) {
  static_assert(kFilteredFraction == kWeightBits, "a mean of two texels is exact");
  using Filtered = typename F::Filtered;
  const Filtered even = even_even + (odd_even - even_even) * odd_column;
  const Filtered odd = even_odd + (odd_odd - even_odd) * odd_column;
  const auto half = from_raw<ufix<kFilteredFraction + 1, 0>>(1);
  return even + (odd - even) * odd_row + half;
}

// lit · texel / (2^c − 1). With 1/(2^c − 1) = 2^−c·(1 + 2^−c + …) cut after its second term the quotient P·2^−c is too
// small by 0 to 2^−c LSB, half of which is added with the ½: of a texel without fraction it is rounded right, as no
// quotient is nearer to a half than ½/(2^c − 1); any other is off by 2^−(c+1) + 2^−(c+8) before rounding.
template <class F>
typename F::Colour textured(const typename F::Colour& lit, const typename F::Filtered& texel) {
  using Filtered = typename F::Filtered;
  const int c = F::kColourBits, places = c + kFilteredFraction;
  const auto product = lit * texel;
  const Filtered half = from_raw<Filtered>((1 << (places - 1)) + (1 << (kFilteredFraction - 1)));
  return slice<typename F::Colour>(product + shift_right(product, c) + half, places);
}

// The colour of a pixel: of what is fetched for it alone.
template <class F>
TexelColour<F> textured_pixel(const TexelColour<F>& lit, const TexelFetch<F>& fetch,
                              const TexelColour<F> (&texel)[TextureMemory<F>::kBanks]) {
  TexelColour<F> out;
  if (F::kBilinear) {
    constexpr int kLast = TextureMemory<F>::kBanks - 1;  // without a filter there is bank 0 alone
    const TexelColour<F>&t0 = texel[0], &t1 = texel[1 & kLast], &t2 = texel[2 & kLast], &t3 = texel[kLast];
    const TexelWeight &column = fetch.odd_column, &row = fetch.odd_row;
    out.r = textured<F>(lit.r, bilinear<F>(t0.r, t1.r, t2.r, t3.r, column, row));
    out.g = textured<F>(lit.g, bilinear<F>(t0.g, t1.g, t2.g, t3.g, column, row));
    out.b = textured<F>(lit.b, bilinear<F>(t0.b, t1.b, t2.b, t3.b, column, row));
  } else {
    out.r = textured<F>(lit.r, texel[0].r);
    out.g = textured<F>(lit.g, texel[0].g);
    out.b = textured<F>(lit.b, texel[0].b);
  }
  return out;
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_TEXTURE_TEXEL_FILTER_HPP_
