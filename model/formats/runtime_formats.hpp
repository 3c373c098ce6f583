// SPDX-License-Identifier: Apache-2.0
// The kernels' view of a configuration that is chosen while the program runs: the members of Formats<C, S>, read from a
// format table instead of compiled. The kernels are the same source, and so are their bits.
//
// The table is the thread's: activate() before each use of a kernel. Values do not know their width; an operation
// gives an exact integer with its binary point, and a conversion wraps to what the table says of the target.
#ifndef HALFSPACE_MODEL_FORMATS_RUNTIME_FORMATS_HPP_
#define HALFSPACE_MODEL_FORMATS_RUNTIME_FORMATS_HPP_

#include <cstdint>
#include <type_traits>
#include <vector>

#include "hls/formats/buffers.hpp"
#include "hls/shade/lighting.hpp"

namespace halfspace {

inline thread_local FormatTable runtime_table{};

// What an operation gives: bits · 2^−fraction_bits, no wider than 64 bits (refusal() sees to it).
struct RuntimeResult {
  std::int64_t bits;
  int fraction_bits;

  int fraction() const { return fraction_bits; }
};

constexpr std::int64_t runtime_scale(std::int64_t bits, int by) {
  return by >= 0 ? std::int64_t(std::uint64_t(bits) << by) : bits >> -by;
}

template <NumberFormat FormatTable::*Entry, bool Signed>
struct RuntimeFixed {
  static constexpr bool kSigned = Signed;
  using Carrier = std::conditional_t<Signed, std::int64_t, std::uint64_t>;

  static int width() { return (runtime_table.*Entry).width; }
  static int fraction() { return (runtime_table.*Entry).width - (runtime_table.*Entry).integer; }

  Carrier bits;

  RuntimeFixed() = default;
  template <class Other, class = decltype(std::declval<const Other&>().fraction())>
  RuntimeFixed(const Other& other)
      : bits(wrap(std::uint64_t(runtime_scale(std::int64_t(other.bits), fraction() - other.fraction())))) {}

  template <class Int>
  static RuntimeFixed from_bits(Int bits) {
    RuntimeFixed x;
    x.bits = wrap(std::uint64_t(bits));
    return x;
  }

 private:
  static Carrier wrap(std::uint64_t v) {
    const int spare = 64 - width();
    return Carrier(v << spare) >> spare;
  }
};

template <class T>
struct IsRuntimeNumber : std::false_type {};
template <NumberFormat FormatTable::*E, bool S>
struct IsRuntimeNumber<RuntimeFixed<E, S>> : std::true_type {};
template <>
struct IsRuntimeNumber<RuntimeResult> : std::true_type {};
template <class A, class B, class R>
using IfRuntime = std::enable_if_t<IsRuntimeNumber<A>::value && IsRuntimeNumber<B>::value, R>;

template <NumberFormat FormatTable::*E, bool S>
typename RuntimeFixed<E, S>::Carrier raw(const RuntimeFixed<E, S>& x) {
  return x.bits;
}

// Both operands on the finer grid of the two.
struct RuntimePair {
  std::int64_t a, b;
  int fraction;

  template <class A, class B>
  RuntimePair(const A& x, const B& y) : fraction(x.fraction() > y.fraction() ? x.fraction() : y.fraction()) {
    a = runtime_scale(std::int64_t(x.bits), fraction - x.fraction());
    b = runtime_scale(std::int64_t(y.bits), fraction - y.fraction());
  }
};

template <class A, class B>
IfRuntime<A, B, RuntimeResult> operator+(const A& x, const B& y) {
  const RuntimePair p(x, y);
  return {p.a + p.b, p.fraction};
}
template <class A, class B>
IfRuntime<A, B, RuntimeResult> operator-(const A& x, const B& y) {
  const RuntimePair p(x, y);
  return {p.a - p.b, p.fraction};
}
template <class A, class B>
IfRuntime<A, B, RuntimeResult> operator*(const A& x, const B& y) {
  return {std::int64_t(x.bits) * std::int64_t(y.bits), x.fraction() + y.fraction()};
}
template <class A>
IfRuntime<A, A, RuntimeResult> operator-(const A& x) {
  return {-std::int64_t(x.bits), x.fraction()};
}
#define HS_RUNTIME_COMPARE(op)                                \
  template <class A, class B>                                 \
  IfRuntime<A, B, bool> operator op(const A& x, const B& y) { \
    const RuntimePair p(x, y);                                \
    return p.a op p.b;                                        \
  }
HS_RUNTIME_COMPARE(<)
HS_RUNTIME_COMPARE(<=)
HS_RUNTIME_COMPARE(>)
HS_RUNTIME_COMPARE(>=)
HS_RUNTIME_COMPARE(==)
HS_RUNTIME_COMPARE(!=)
#undef HS_RUNTIME_COMPARE

template <class S>
struct RuntimeFormats {
  static constexpr int kLanesX = S::kX, kLanesY = S::kY, kLanes = S::kX * S::kY;
  static constexpr int kLog2LanesX = exact_log2(kLanesX), kLog2LanesY = exact_log2(kLanesY);
  static inline thread_local int kWidth, kHeight, kStampsX, kStampsY, kStamps, kTriangles, kSubpixelBits,
      kReciprocalFraction, kAreaBits, kDepthBits, kColourBits, kLights, kMaterials, kSquarings, kTexels, kTextures,
      kVectorRange, kVectorFraction, kWeightBits, kLog2Samples;
  static inline thread_local KeyFilter kFilter;
  using CompilesPlaneTest = std::true_type;
  using CompilesPhong = std::true_type;
  using CompilesLighting = std::true_type;
  using CompilesTexture = std::true_type;
  using CompilesMotion = std::true_type;
  static inline thread_local bool kHasDepth, kGouraud, kPhong, kShadesPlanes, kHasPlanes, kStoresDepth, kTestsPlanes;
  static inline thread_local bool kHasLighting, kHasGloss, kDeferred, kHasTexture, kBilinear, kPerspective, kSendsShape,
      kOrdersVertices;
  static inline thread_local bool kHasMotion, kRelights, kHasColours, kHasObjects;

  static void activate(const Config& c, const FormatTable& table) {
    runtime_table = table;
    kWidth = c.width, kHeight = c.height;
    kStampsX = stamps_for(c.width, kLanesX), kStampsY = stamps_for(c.height, kLanesY);
    kStamps = kStampsX * kStampsY;
    kTriangles = c.triangles;
    kSubpixelBits = c.subpixel_bits;
    kReciprocalFraction = c.reciprocal_bits;
    kAreaBits = table.area.width;
    kDepthBits = c.depth_bits, kColourBits = c.colour_bits;
    kHasDepth = has_depth(c), kGouraud = is_gouraud(c), kHasPlanes = has_planes(c);
    kPhong = is_phong(c), kShadesPlanes = shades_planes(c);
    kStoresDepth = stores_depth(c), kTestsPlanes = tests_planes(c);
    kHasLighting = has_lighting(c), kHasGloss = has_gloss(c), kDeferred = is_deferred(c);
    kLights = c.lights, kMaterials = c.materials, kSquarings = exact_log2(c.gloss);
    kHasTexture = has_texture(c), kBilinear = is_bilinear(c), kPerspective = has_perspective(c);
    kSendsShape = sends_shape(c), kOrdersVertices = orders_vertices(c);
    kTexels = c.texels, kTextures = c.textures;
    kHasMotion = has_motion(c), kRelights = relights(c), kHasColours = has_colours(c), kFilter = c.filter;
    kVectorRange = c.vector_range, kVectorFraction = c.vector_fraction, kWeightBits = c.weight_bits;
    kLog2Samples = exact_log2(c.samples);
    kHasObjects = has_objects(c);
  }

  using X = RuntimeFixed<&FormatTable::x, false>;
  using Y = RuntimeFixed<&FormatTable::y, false>;
  using Index = RuntimeFixed<&FormatTable::index, false>;
  using Coord = RuntimeFixed<&FormatTable::coord, true>;
  using Delta = RuntimeFixed<&FormatTable::delta, true>;
  using Area = RuntimeFixed<&FormatTable::area, false>;
  using SignedArea = RuntimeFixed<&FormatTable::signed_area, true>;
  using Edge = RuntimeFixed<&FormatTable::edge, true>;
  using EdgeStep = RuntimeFixed<&FormatTable::edge_step, true>;
  using Reciprocal = RuntimeFixed<&FormatTable::reciprocal, false>;
  using Shift = RuntimeFixed<&FormatTable::shift, false>;
  using Depth = RuntimeFixed<&FormatTable::depth, false>;
  using DepthPlane = RuntimeFixed<&FormatTable::depth_plane, false>;
  using DepthGradient = RuntimeFixed<&FormatTable::depth_gradient, true>;
  using Colour = RuntimeFixed<&FormatTable::colour, false>;
  using ColourPlane = RuntimeFixed<&FormatTable::colour_plane, false>;
  using ColourGradient = RuntimeFixed<&FormatTable::colour_gradient, true>;
  using MaterialNumber = RuntimeFixed<&FormatTable::material, false>;
  using LightNumber = RuntimeFixed<&FormatTable::light, false>;
  using Gloss = RuntimeFixed<&FormatTable::gloss, false>;
  using Normal = RuntimeFixed<&FormatTable::normal, true>;
  using Direction = RuntimeFixed<&FormatTable::direction, true>;
  using SquaredLength = RuntimeFixed<&FormatTable::squared_length, false>;
  using Root = RuntimeFixed<&FormatTable::root, false>;
  using RootShift = RuntimeFixed<&FormatTable::root_shift, false>;
  using Dot = RuntimeFixed<&FormatTable::dot, true>;
  using Projection = RuntimeFixed<&FormatTable::projection, false>;
  using Cosine = RuntimeFixed<&FormatTable::cosine, false>;
  using Coefficient = RuntimeFixed<&FormatTable::coefficient, false>;
  using LightSum = RuntimeFixed<&FormatTable::light_sum, false>;
  using NormalPlane = RuntimeFixed<&FormatTable::normal_plane, false>;
  using NormalGradient = RuntimeFixed<&FormatTable::normal_gradient, true>;
  struct NormalChannel {
    using Value = RuntimeFixed<&FormatTable::normal_offset, false>;
    using PlaneValue = RuntimeFormats::NormalPlane;
    using Gradient = RuntimeFormats::NormalGradient;
    using Numerator = RuntimeFixed<&FormatTable::normal_numerator, true>;
    using Start = RuntimeFixed<&FormatTable::normal_start, true>;
    using StartGradient = RuntimeFixed<&FormatTable::normal_start_gradient, true>;
  };
  using TextureNumber = RuntimeFixed<&FormatTable::texture, false>;
  using Repeats = RuntimeFixed<&FormatTable::repeats, false>;
  using Side = RuntimeFixed<&FormatTable::side, false>;
  using TexelAddress = RuntimeFixed<&FormatTable::texel_address, false>;
  using Coordinate = RuntimeFixed<&FormatTable::coordinate, false>;
  using CoordinatePlane = RuntimeFixed<&FormatTable::coordinate_plane, false>;
  using CoordinateGradient = RuntimeFixed<&FormatTable::coordinate_gradient, true>;
  using Inverse = RuntimeFixed<&FormatTable::inverse, false>;
  using Object = RuntimeFixed<&FormatTable::object, false>;
  using ObjectCount = RuntimeFixed<&FormatTable::object_count, false>;
  using InverseShift = RuntimeFixed<&FormatTable::inverse_shift, false>;
  using TexelPlace = RuntimeFixed<&FormatTable::texel_place, false>;
  using Filtered = RuntimeFixed<&FormatTable::filtered, false>;
  using Face = RuntimeFixed<&FormatTable::face, false>;
  using Origin = RuntimeFixed<&FormatTable::origin, true>;
  using Extent = RuntimeFixed<&FormatTable::extent, false>;
  using Vector = RuntimeFixed<&FormatTable::vector, true>;
  using KeyWeight = RuntimeFixed<&FormatTable::key_weight, false>;
  using TileX = RuntimeFixed<&FormatTable::tile_x, false>;
  using TileY = RuntimeFixed<&FormatTable::tile_y, false>;
  using KeySum = RuntimeFixed<&FormatTable::key_sum, true>;
  using KeyBlend = RuntimeFixed<&FormatTable::key_blend, true>;
  using Difference = RuntimeFixed<&FormatTable::difference, false>;
  using DifferencePlane = RuntimeFixed<&FormatTable::difference_plane, false>;
  using DifferenceGradient = RuntimeFixed<&FormatTable::difference_gradient, true>;
  struct DifferenceChannel {
    using Value = RuntimeFormats::Difference;
    using PlaneValue = RuntimeFormats::DifferencePlane;
    using Gradient = RuntimeFormats::DifferenceGradient;
    using Numerator = RuntimeFixed<&FormatTable::difference_numerator, true>;
    using Start = RuntimeFixed<&FormatTable::difference_start, true>;
    using StartGradient = RuntimeFixed<&FormatTable::difference_start_gradient, true>;
  };
  struct CoordinateChannel {
    using Value = RuntimeFormats::Coordinate;
    using PlaneValue = RuntimeFormats::CoordinatePlane;
    using Gradient = RuntimeFormats::CoordinateGradient;
    using Numerator = RuntimeFixed<&FormatTable::coordinate_numerator, true>;
    using Start = RuntimeFixed<&FormatTable::coordinate_start, true>;
    using StartGradient = RuntimeFixed<&FormatTable::coordinate_start_gradient, true>;
  };
  struct DepthChannel {
    using Value = RuntimeFormats::Depth;
    using PlaneValue = RuntimeFormats::DepthPlane;
    using Gradient = RuntimeFormats::DepthGradient;
    using Numerator = RuntimeFixed<&FormatTable::depth_numerator, true>;
    using Start = RuntimeFixed<&FormatTable::depth_start, true>;
    using StartGradient = RuntimeFixed<&FormatTable::depth_start_gradient, true>;
  };
  struct ColourChannel {
    using Value = RuntimeFormats::Colour;
    using PlaneValue = RuntimeFormats::ColourPlane;
    using Gradient = RuntimeFormats::ColourGradient;
    using Numerator = RuntimeFixed<&FormatTable::colour_numerator, true>;
    using Start = RuntimeFixed<&FormatTable::colour_start, true>;
    using StartGradient = RuntimeFixed<&FormatTable::colour_start_gradient, true>;
  };
};

// Buffers of the size that was active when they were made.
template <class T, int N>
class RuntimeRow {
 public:
  operator T*() { return lanes_; }
  operator const T*() const { return lanes_; }

 private:
  T lanes_[N] = {};
};

template <class S>
struct IndexBuffer<RuntimeFormats<S>> {
  using F = RuntimeFormats<S>;
  std::vector<RuntimeRow<typename F::Index, F::kLanes>> index = decltype(index)(std::size_t(F::kStamps));
};
template <class S>
struct DepthBuffer<RuntimeFormats<S>> {
  using F = RuntimeFormats<S>;
  std::vector<RuntimeRow<typename F::Depth, F::kLanes>> depth =
      decltype(depth)(std::size_t(F::kStoresDepth ? F::kStamps : 1));
};
// An address beyond the memory, from an index that was cut, wraps as in a RAM.
template <class T>
class RuntimeEntries {
 public:
  explicit RuntimeEntries(int count) : entries_(std::size_t(count)) {}
  T& operator[](int address) { return entries_[std::size_t(address) % entries_.size()]; }
  const T& operator[](int address) const { return entries_[std::size_t(address) % entries_.size()]; }

 private:
  std::vector<T> entries_;
};
template <class S>
struct ObjectTable<RuntimeFormats<S>> {
  using F = RuntimeFormats<S>;
  RuntimeEntries<typename F::Object> object{F::kHasObjects ? F::kTriangles : 1};
};
template <class S>
struct ShadingDatabase<RuntimeFormats<S>> {
  using F = RuntimeFormats<S>;
  RuntimeEntries<Planes<F>> planes{F::kPhong || F::kHasMotion ? 1 : F::kTriangles};
};
template <class S>
struct NormalDatabase<RuntimeFormats<S>> {
  using F = RuntimeFormats<S>;
  RuntimeEntries<NormalPlanes<F>> planes{F::kPhong ? F::kTriangles : 1};
};
template <class S>
struct VisibilityDatabase<RuntimeFormats<S>> {
  using F = RuntimeFormats<S>;
  RuntimeEntries<DepthEntry<F>> entry{F::kTestsPlanes ? F::kTriangles : 1};
};

template <class S>
struct TextureDatabase<RuntimeFormats<S>> {
  using F = RuntimeFormats<S>;
  RuntimeEntries<TexturePlanes<F>> planes{F::kHasTexture ? F::kTriangles : 1};
};
template <class S>
struct MotionDatabase<RuntimeFormats<S>> {
  using F = RuntimeFormats<S>;
  RuntimeEntries<MotionPlanes<F>> planes{F::kHasMotion ? F::kTriangles : 1};
};
template <class S>
struct TextureTable<RuntimeFormats<S>> {
  using F = RuntimeFormats<S>;
  RuntimeEntries<TextureEntry<F>> entry{F::kTextures + 1};
};
template <class S>
struct TextureMemory<RuntimeFormats<S>> {
  using F = RuntimeFormats<S>;
  static constexpr int kBanks = 4;
  std::vector<RuntimeEntries<TexelColour<F>>> bank =
      decltype(bank)(4, RuntimeEntries<TexelColour<F>>(F::kTexels < 4 ? 1
                                                       : F::kBilinear ? F::kTexels / 4
                                                                      : F::kTexels));
};
template <class S>
struct MaterialTable<RuntimeFormats<S>> {
  using F = RuntimeFormats<S>;
  std::vector<RuntimeRow<Material<F>, kMostLights>> entry = decltype(entry)(std::size_t(F::kMaterials));
};

}  // namespace halfspace

#endif  // HALFSPACE_MODEL_FORMATS_RUNTIME_FORMATS_HPP_
