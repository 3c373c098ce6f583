// SPDX-License-Identifier: Apache-2.0
// The kernels' view of a configuration that is chosen while the program runs: the members of Formats<C, S>, read from a
// format table instead of compiled. The kernels are the same source, and so are their bits.
//
// The table is the thread's: activate() before each use of a kernel.
#ifndef HALFSPACE_MODEL_FORMATS_RUNTIME_FORMATS_HPP_
#define HALFSPACE_MODEL_FORMATS_RUNTIME_FORMATS_HPP_

#include <type_traits>
#include <vector>

#include "hls/formats/buffers.hpp"
#include "hls/shade/lighting.hpp"
#include "model/formats/runtime_fixed.hpp"

namespace halfspace {

// No configuration changes which numbers have a sign.
constexpr FormatTable kRuntimeSigns = format_table(Config{});

template <class S>
struct RuntimeFormats : StampConstants<S>, FlagFormats<Fixed> {
#define HS_FLAG(Type, Name, function) static inline thread_local Type k##Name;
#define HS_CONSTANT(Name, field) static inline thread_local decltype(Config::field) k##Name;
#define HS_COMPILES(Unit, Name) using Compiles##Unit = std::true_type;
#include "hls/formats/lists/constant_list.hpp"
  static inline thread_local int kStampsX, kStampsY, kStamps;

  static void activate(const Config& c, const FormatTable& table) {
    runtime_table = table;
#define HS_FLAG(Type, Name, function) k##Name = function(c);
#define HS_CONSTANT(Name, field) k##Name = c.field;
#include "hls/formats/lists/constant_list.hpp"
    kStampsX = stamps_for(c.width, S::kX), kStampsY = stamps_for(c.height, S::kY);
    kStamps = kStampsX * kStampsY;
  }

#define HS_FORMAT(part, member, Type, is_used, why) \
  using Type = RuntimeFixed<&FormatTable::member, kRuntimeSigns.member.is_signed>;
#include "hls/formats/lists/format_list.hpp"
#define HS_CHANNEL(part, vertex, Vertex, channel, Channel, is_used, bits, fraction) HS_CHANNEL_TYPES(Vertex, Channel)
#include "hls/formats/lists/format_list.hpp"
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
struct FaceTable<RuntimeFormats<S>> {
  using F = RuntimeFormats<S>;
  RuntimeEntries<typename F::Face> face{F::kUpConverts ? F::kTriangles : 1};
};
template <class S>
struct HoleMarks<RuntimeFormats<S>> {
  using F = RuntimeFormats<S>;
  std::vector<RuntimeRow<Bit, F::kLanes>> hole = decltype(hole)(std::size_t(F::kUpConverts ? F::kStamps : 1));
};
template <class S>
struct ShadingDatabase<RuntimeFormats<S>> {
  using F = RuntimeFormats<S>;
  RuntimeEntries<Planes<F>> planes{F::kPhong || !F::kShades ? 1 : F::kTriangles};
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
