// SPDX-License-Identifier: Apache-2.0
// The memories of the pipeline: a word a stamp, the lanes side by side; or a word an entry. In hardware, 1R1W RAMs.
// Natively they are arrays of records, beside a top views of arrays of packed words.
#ifndef HALFSPACE_HLS_FORMATS_BUFFERS_HPP_
#define HALFSPACE_HLS_FORMATS_BUFFERS_HPP_

#include "hls/formats/film_records.hpp"
#ifdef HS_WORDS
#include "hls/numbers/memory_words.hpp"
#define HS_MEMORY(Record, member, words) Words<Record> member
#define HS_MEMORY_OF(Record, Type, member, words, of_each) Words<Record> member
#define HS_MEMORY_ROWS(Record, member, rows, words) WordRows<Record, words> member
#else
#define HS_MEMORY(Record, member, words) Record member[words]
#define HS_MEMORY_OF(Record, Type, member, words, of_each) Type member[words] of_each
#define HS_MEMORY_ROWS(Record, member, rows, words) Record member[rows][words]
#endif

namespace halfspace {

// Of the word of a stamp.
template <class F>
int stamp_address(const typename F::X& x, const typename F::Y& y) {
  return int(raw(y)) * F::kStampsX + int(raw(x));
}

#ifndef HS_WORDS
// memory[address] = lanes.
template <class Memory, class T, std::size_t N>
HS_INLINE inline void store_lanes(Memory& memory, int address, const T (&lanes)[N]) {
Lanes:
  for (std::size_t l = 0; l < N; ++l) {
    HS_UNROLL
    memory[address][l] = lanes[l];
  }
}
#endif

// The words of memories that have no record of a stream.
template <class F>
struct IndexStamp {
  using Lane = typename F::Index;
  Lane lane[F::kLanes];

  Lane operator[](int l) const { return lane[l]; }
  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v.lanes("index", lane);
  }
};
template <class F>
struct DepthStamp {
  using Lane = typename F::Depth;
  Lane lane[F::kLanes];

  Lane operator[](int l) const { return lane[l]; }
  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v.lanes("depth", lane);
  }
};
template <class F>
struct ObjectEntry {
  typename F::Object object;

  operator typename F::Object() const { return object; }
  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("object", object);
  }
};
// The depth plane of a triangle from the centre of pixel (0, 0) of the frame on, ½ included, modulo 2^b.
template <class F>
struct DepthEntry {
  typename F::DepthPlane origin;
  typename F::DepthGradient dx, dy;

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("origin", origin), v("dx", dx), v("dy", dy);
  }
};
template <class F>
struct TexelColour {
  typename F::Colour r, g, b;

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("r", r), v("g", g), v("b", b);
  }
};

// Which triangle is nearest: 0, or its index.
template <class F>
struct IndexBuffer {
  static constexpr int kWords = F::kStamps;
  HS_MEMORY_OF(IndexStamp<F>, typename F::Index, index, kWords, [F::kLanes]);
};

// Its depth; means nothing where the index is 0. Without F::kStoresDepth nothing reads or writes it.
template <class F>
struct DepthBuffer {
  static constexpr int kWords = F::kStoresDepth ? F::kStamps : 1;
  HS_MEMORY_OF(DepthStamp<F>, typename F::Depth, depth, kWords, [F::kLanes]);
};

// The object of each triangle, with F::kHasObjects: entry index − 1.
template <class F>
struct ObjectTable {
  static constexpr int kWords = F::kHasObjects ? F::kTriangles : 1;
  HS_MEMORY_OF(ObjectEntry<F>, typename F::Object, object, kWords, );
};

// The face of each triangle, with F::kUpConverts: entry index − 1.
template <class F>
struct FaceEntry {
  typename F::Face face;

  operator typename F::Face() const { return face; }
  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("face", face);
  }
};
template <class F>
struct FaceTable {
  static constexpr int kWords = F::kUpConverts ? F::kTriangles : 1;
  HS_MEMORY_OF(FaceEntry<F>, typename F::Face, face, kWords, );
};

// Which pixels of a frame in between no key shows, a word a stamp: all 0 but between a frame in between that asks for
// faces and the pass that fills its holes.
template <class F>
struct HoleStamp {
  using Lane = typename F::Bit;
  Lane lane[F::kLanes];

  Lane operator[](int l) const { return lane[l]; }
  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v.lanes("hole", lane);
  }
};
template <class F>
struct HoleMarks {
  static constexpr int kWords = F::kUpConverts ? F::kStamps : 1;
  HS_MEMORY_OF(HoleStamp<F>, Bit, hole, kWords, [F::kLanes]);
};

// TdbS, the triangle database for shading: entry index − 1.
template <class F>
struct ShadingDatabase {
  static constexpr int kWords = F::kPhong || !F::kShades ? 1 : F::kTriangles;
  HS_MEMORY(Planes<F>, planes, kWords);
};

// TdbS with F::kPhong.
template <class F>
struct NormalDatabase {
  static constexpr int kWords = F::kPhong ? F::kTriangles : 1;
  HS_MEMORY(NormalPlanes<F>, planes, kWords);
};

// TdbS beside either, with F::kHasTexture.
template <class F>
struct TextureDatabase {
  static constexpr int kWords = F::kHasTexture ? F::kTriangles : 1;
  HS_MEMORY(TexturePlanes<F>, planes, kWords);
};

// TdbS with F::kHasMotion.
template <class F>
struct MotionDatabase {
  static constexpr int kWords = F::kHasMotion ? F::kTriangles : 1;
  HS_MEMORY(MotionPlanes<F>, planes, kWords);
};

// TdbV, the triangle database for visibility: entry index − 1, of visible triangles alone. Without F::kTestsPlanes
// nothing reads or writes it.
template <class F>
struct VisibilityDatabase {
  static constexpr int kWords = F::kTestsPlanes ? F::kTriangles : 1;
  HS_MEMORY(DepthEntry<F>, entry, kWords);
};

constexpr int kMostLights = 4;

// Registers and a memory of lighting: stable while a normal is lit.
template <class F>
struct LightTable {
  static constexpr int kWords = kMostLights;
  HS_MEMORY(Light<F>, light, kWords);
};
template <class F>
struct MaterialTable {
  static constexpr int kRows = F::kMaterials < 1 ? 1 : F::kMaterials;
  static constexpr int kWords = kRows * kMostLights;
  HS_MEMORY_ROWS(Material<F>, entry, kRows, kMostLights);
};

// Of textures: stable while a frame is scanned out. Entry 0, of no texture, means nothing.
template <class F>
struct TextureTable {
  static constexpr int kWords = F::kTextures + 1;
  HS_MEMORY(TextureEntry<F>, entry, kWords);
};
// A bank for each parity of a texel's column and row, for bilinear filtering; else one.
template <class F>
struct TextureMemory {
  static constexpr int kBanks = F::kBilinear ? 4 : 1;
  static constexpr int kBankWords = F::kTexels < kBanks ? 1 : F::kTexels / kBanks;
  static constexpr int kWords = kBanks * kBankWords;
  HS_MEMORY_ROWS(TexelColour<F>, bank, kBanks, kBankWords);
};

#undef HS_MEMORY
#undef HS_MEMORY_OF
#undef HS_MEMORY_ROWS

// The registers of index_pool, with F::kGivesIndices; all 0 before the first frame.
template <class F>
struct PoolRegisters {
  typename F::Index used;        // indices of this frame: 1 … used
  typename F::Flight in_flight;  // triangles whose results it has not read yet,
  typename F::Flight stale;      // and those among them that are of frames before
};

// I-buffer and marks of holes all 0 before the first frame; a frame leaves them so.
template <class F>
struct Buffers {
  IndexBuffer<F> index;
  DepthBuffer<F> depth;
  ObjectTable<F> objects;
  FaceTable<F> faces;
  HoleMarks<F> holes;
  PoolRegisters<F> pool{};
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
