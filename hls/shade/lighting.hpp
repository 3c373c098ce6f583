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
  if (raw(dot) <= 0) return from_raw<typename F::Cosine>(0);
  const int u = F::Cosine::fraction(), p = F::Normal::fraction();
  // Of n·2^k, the length of which is 1 to 2, in units of 2^−u; half up.
  const std::uint64_t scaled = std::uint64_t(raw(dot)) << int(raw(inverse.shift));
  const std::uint64_t rounded = (scaled + (std::uint64_t(1) << p)) >> (p + 1);
  const std::uint64_t most = (std::uint64_t(2) << u) - 1;
  const auto projection = from_raw<typename F::Projection>(rounded < most ? rounded : most);
  const std::uint64_t product = std::uint64_t(raw(projection)) * std::uint64_t(raw(inverse.root));
  const std::uint64_t result = (product + (std::uint64_t(1) << (kRootFraction - 1))) >> kRootFraction;
  const std::uint64_t one = std::uint64_t(1) << u;
  return from_raw<typename F::Cosine>(result < one ? result : one);
}

// x^(2^k); k beyond what is built counts as the largest that is.
template <class F>
typename F::Cosine power(typename F::Cosine x, int k) {
  const int u = F::Cosine::fraction();
Square:
  for (int j = 0; j < kMostSquarings; ++j) {
    HS_UNROLL
    if (j < F::kSquarings && j < k) {
      const std::uint64_t square = std::uint64_t(raw(x)) * std::uint64_t(raw(x));
      x = from_raw<typename F::Cosine>((square + (std::uint64_t(1) << (u - 1))) >> u);
    }
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
LitSum<F> light_sum(const typename F::Normal (&n)[3], const typename F::MaterialNumber& material,
                    const LightTable<F>& lights, const MaterialTable<F>& materials) {
  using Sum = typename F::LightSum;
  const typename F::SquaredLength length = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
  const ReciprocalRoot<F> inverse = reciprocal_sqrt<F>(length);
  LitSum<F> sum{};
Lights:
  for (int i = 0; i < kMostLights; ++i) {
    HS_PIPELINE(1)
    if (i >= F::kLights) break;
    const Light<F>& light = lights.light[i];
    const Material<F>& entry = materials.entry[int(raw(material))][i];
    const typename F::Dot along = n[0] * light.to_light[0] + n[1] * light.to_light[1] + n[2] * light.to_light[2];
    const typename F::Cosine diffuse = cosine<F>(along, inverse);
    typename F::Cosine highlight = from_raw<typename F::Cosine>(0);
    if (F::kHasGloss && raw(along) > 0) {
      const typename F::Dot half = n[0] * light.half[0] + n[1] * light.half[1] + n[2] * light.half[2];
      highlight = power<F>(cosine<F>(half, inverse), int(raw(entry.gloss)));
    }
  Channels:
    for (int c = 0; c < 3; ++c) {
      HS_UNROLL
      const Sum base = sum.channel[c] + entry.base[c];
      const Sum lit = base + entry.diffuse[c] * diffuse;
      if (F::kHasGloss) sum.channel[c] = lit + entry.specular[c] * highlight;
      else sum.channel[c] = lit;
    }
  }
  return sum;
}

// Half up, and full scale at most.
template <class F>
typename F::Colour rounded_colour(const typename F::LightSum& sum) {
  const int fraction = F::LightSum::fraction();
  const std::uint64_t whole = (std::uint64_t(raw(sum)) + (std::uint64_t(1) << (fraction - 1))) >> fraction;
  const std::uint64_t full = (std::uint64_t(1) << F::kColourBits) - 1;
  return from_raw<typename F::Colour>(whole < full ? whole : full);
}

template <class F>
Rgb<F> light_normal(const typename F::Normal (&n)[3], const typename F::MaterialNumber& material,
                    const LightTable<F>& lights, const MaterialTable<F>& materials) {
  const LitSum<F> sum = light_sum<F>(n, material, lights, materials);
  Rgb<F> colour;
Round:
  for (int c = 0; c < 3; ++c) {
    HS_UNROLL
    colour.channel[c] = rounded_colour<F>(sum.channel[c]);
  }
  return colour;
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_SHADE_LIGHTING_HPP_
