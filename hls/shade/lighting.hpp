// SPDX-License-Identifier: Apache-2.0
// The Phong model of index rendering for lights and a viewer at infinity:
//
//   I = Σ_i [ base_i + diffuse_i · max(0, N·L_i) + (N·L_i > 0) · specular_i · max(0, N·H_i)^(2^k) ],  N = n/|n|
//
// N is never made. n·L_i and n·H_i are exact, so that N·L_i > 0 is decided rightly, and each is then cut to a factor of
// a multiplier and scaled by the one reciprocal of |n|; a cosine is at most 1. With ρ = 2^−17 of reciprocal_sqrt:
//
//   cosine               |error| <= δ = ρ + 2^−u     n·L with 1 <= |n| < 2, and its product with y < 1, each rounded to
//   u bits after j squarings    |error| <= e_j = 2·e_(j−1) + 2^−(u+1) = 2^j·δ + (2^j − 1)·2^−(u+1) sum |error| <= Σ_i [
//   diffuse_i·δ + specular_i·e_k ]  LSB before rounding: products and sum are exact
//
// docs/numerics.md has the derivation. Multipliers: 9 for q, n·L, n·H, one in the root, 2 + 4 + 6 after it; without
// highlights 6, 1, 1 and 3.
#ifndef HALFSPACE_HLS_SHADE_LIGHTING_HPP_
#define HALFSPACE_HLS_SHADE_LIGHTING_HPP_

#include "hls/formats/buffers.hpp"
#include "hls/shade/reciprocal_sqrt.hpp"

namespace halfspace {

constexpr int kMostSquarings = 4;

template <class F>
void store_light(Stream<Light<F>>& lights, LightTable<F>& table) {
  const Light<F> in = lights.read();
  table.light[int(raw(in.light))] = in;
}
template <class F>
void store_material(Stream<Material<F>>& materials, MaterialTable<F>& table) {
  const Material<F> in = materials.read();
  table.entry[int(raw(in.material))][int(raw(in.light))] = in;
}

// max(0, n·a / |n|), at most 1.
template <class F>
typename F::Cosine cosine(const typename F::Dot& dot, const ReciprocalRoot<F>& inverse) {
  using Projection = typename F::Projection;
  using Cosine = typename F::Cosine;
  // Of n·2^k, the length of which is 1 to 2.
  const typename F::Dot::Unsigned scaled = shift_left(dot, int(raw(inverse.shift)));
  const auto rounded = round_to<Refined<typename F::Dot::Unsigned, Projection>>(scaled);
  const Projection most = from_raw<Projection>(-1);
  const Projection projection = select(rounded < most, Projection(rounded), most);
  const Cosine result = round_to<Cosine>(projection * inverse.root);
  // At most 1, by its bits: a comparison with 1 would hide from a tool how many there are.
  const int u = Cosine::fraction();
  const Cosine whole = shift_left(shift_right(result, u), u);
  const Cosine at_most_one = merged(whole, select(is_zero(whole), low_bits(result, u), from_raw<Cosine>(0)));
  return select(dot > typename F::Dot(), at_most_one, from_raw<Cosine>(0));
}

// x^(2^k); k beyond what is built counts as the largest that is.
template <class F>
typename F::Cosine power(typename F::Cosine x, int k) {
Square:
  for (int j = 0; j < kMostSquarings; ++j) {
    HS_UNROLL
    if (j < F::kSquarings) x = select(j < k, round_to<typename F::Cosine>(x * x), x);
  }
  return x;
}

template <class F>
struct Rgb {
  typename F::Colour channel[3];
};

// The sum before it is rounded.
template <class F>
struct LitSum {
  typename F::LightSum channel[3];
};

template <class F>
typename F::Dot dot_product(const typename F::Normal (&n)[3], const typename F::Direction (&a)[3]) {
  return n[0] * a[0] + n[1] * a[1] + n[2] * a[2];
}

// 1/|n|
template <class F>
ReciprocalRoot<F> reciprocal_length(const typename F::Normal (&n)[3]) {
  const typename F::Normal::Unsigned x = magnitude(n[0]), y = magnitude(n[1]), z = magnitude(n[2]);
  return reciprocal_sqrt<F>(x * x + y * y + z * z);
}

// `sum`, and what a light adds to it.
template <class F>
LitSum<F> add_light(const LitSum<F>& sum, const typename F::Normal (&n)[3], const ReciprocalRoot<F>& inverse,
                    const Light<F>& light, const Material<F>& entry) {
  using Cosine = typename F::Cosine;
  const typename F::Dot along = dot_product<F>(n, light.to_light);
  const Cosine diffuse = cosine<F>(along, inverse);
  Cosine highlight = from_raw<Cosine>(0);
  if (F::kHasGloss) {
    const Cosine half = power<F>(cosine<F>(dot_product<F>(n, light.half), inverse), int(raw(entry.gloss)));
    highlight = select(along > typename F::Dot(), half, highlight);
  }
  LitSum<F> lit;
LitChannels:
  for (int c = 0; c < 3; ++c) {
    HS_UNROLL
    const typename F::LightSum base = sum.channel[c] + entry.base[c];
    lit.channel[c] = base + entry.diffuse[c] * diffuse;
    if (F::kHasGloss) lit.channel[c] = lit.channel[c] + entry.specular[c] * highlight;
  }
  return lit;
}

template <class F>
LitSum<F> light_sum(const typename F::Normal (&n)[3], const typename F::MaterialNumber& material,
                    const LightTable<F>& lights, const MaterialTable<F>& materials) {
  const ReciprocalRoot<F> inverse = reciprocal_length<F>(n);
  LitSum<F> sum{};
Lights:
  HS_IN_TURN for (int i = 0; i < F::kLights; ++i) {
    HS_PIPELINE(1)
    sum = add_light(sum, n, inverse, lights.light[i], materials.entry[int(raw(material))][i]);
  }
  return sum;
}

// Half up, and full scale at most.
template <class F>
typename F::Colour rounded_colour(const typename F::LightSum& sum) {
  using Colour = typename F::Colour;
  const auto whole = round_to<Whole<Wider<typename F::LightSum, 1>>>(sum);
  const Colour full = from_raw<Colour>(-1);
  return select(whole < full, Colour(whole), full);
}

template <class F>
Rgb<F> rounded_colours(const LitSum<F>& sum) {
  Rgb<F> colour;
Round:
  for (int c = 0; c < 3; ++c) {
    HS_UNROLL
    colour.channel[c] = rounded_colour<F>(sum.channel[c]);
  }
  return colour;
}

template <class F>
Rgb<F> light_normal(const typename F::Normal (&n)[3], const typename F::MaterialNumber& material,
                    const LightTable<F>& lights, const MaterialTable<F>& materials) {
  return rounded_colours(light_sum<F>(n, material, lights, materials));
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_SHADE_LIGHTING_HPP_
