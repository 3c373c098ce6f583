// SPDX-License-Identifier: Apache-2.0
// The memories of the pipeline: a word a stamp, the lanes side by side. In hardware, 1R1W RAMs.
#ifndef HALFSPACE_HLS_FORMATS_BUFFERS_HPP_
#define HALFSPACE_HLS_FORMATS_BUFFERS_HPP_

#include "hls/formats/records.hpp"

namespace halfspace {

// Of the word of a stamp.
template <class F>
int stamp_address(const typename F::X& x, const typename F::Y& y) {
  return int(raw(y)) * F::kStampsX + int(raw(x));
}

// Which triangle is nearest: 0, or its index.
template <class F>
struct IndexBuffer {
  typename F::Index index[F::kStamps][F::kLanes];
};

// Its depth; means nothing where the index is 0. Without F::kStoresDepth nothing reads or writes it.
template <class F>
struct DepthBuffer {
  typename F::Depth depth[F::kStoresDepth ? F::kStamps : 1][F::kLanes];
};

// The object of each triangle, with F::kHasObjects: entry index − 1.
template <class F>
struct ObjectTable {
  typename F::Object object[F::kHasObjects ? F::kTriangles : 1];
};

// TdbS, the triangle database for shading: entry index − 1.
template <class F>
struct ShadingDatabase {
  Planes<F> planes[F::kPhong || F::kHasMotion ? 1 : F::kTriangles];
};

// TdbS with F::kPhong.
template <class F>
struct NormalDatabase {
  NormalPlanes<F> planes[F::kPhong ? F::kTriangles : 1];
};

// TdbS beside either, with F::kHasTexture.
template <class F>
struct TextureDatabase {
  TexturePlanes<F> planes[F::kHasTexture ? F::kTriangles : 1];
};

// TdbS with F::kHasMotion.
template <class F>
struct MotionDatabase {
  MotionPlanes<F> planes[F::kHasMotion ? F::kTriangles : 1];
};

// The depth plane of a triangle from the centre of pixel (0, 0) of the frame on, ½ included, modulo 2^b.
template <class F>
struct DepthEntry {
  typename F::DepthPlane origin;
  typename F::DepthGradient dx, dy;
};

// TdbV, the triangle database for visibility: entry index − 1, of visible triangles alone. Without F::kTestsPlanes
// nothing reads or writes it.
template <class F>
struct VisibilityDatabase {
  DepthEntry<F> entry[F::kTestsPlanes ? F::kTriangles : 1];
};

constexpr int kMostLights = 4;

// Registers and a memory of lighting: stable while a normal is lit.
template <class F>
struct LightTable {
  Light<F> light[kMostLights];
};
template <class F>
struct MaterialTable {
  Material<F> entry[F::kMaterials < 1 ? 1 : F::kMaterials][kMostLights];
};

// Of textures: stable while a frame is scanned out. Entry 0, of no texture, means nothing.
template <class F>
struct TextureTable {
  TextureEntry<F> entry[F::kTextures + 1];
};
template <class F>
struct TexelColour {
  typename F::Colour r, g, b;
};
// A bank for each parity of a texel's column and row, for bilinear filtering; else one.
template <class F>
struct TextureMemory {
  static constexpr int kBanks = F::kBilinear ? 4 : 1;
  TexelColour<F> bank[kBanks][F::kTexels < kBanks ? 1 : F::kTexels / kBanks];
};

// I-buffer all 0 before the first frame; a frame leaves it so.
template <class F>
struct Buffers {
  IndexBuffer<F> index;
  DepthBuffer<F> depth;
  ObjectTable<F> objects;
  ShadingDatabase<F> shading;
  NormalDatabase<F> normals;
  VisibilityDatabase<F> visibility;
  LightTable<F> lights;
  MaterialTable<F> materials;
  TextureDatabase<F> coordinates;
  MotionDatabase<F> motion;
  TextureTable<F> textures;
  TextureMemory<F> texels;
};

}  // namespace halfspace

#endif  // HALFSPACE_HLS_FORMATS_BUFFERS_HPP_
