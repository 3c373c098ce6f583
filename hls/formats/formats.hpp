// SPDX-License-Identifier: Apache-2.0
// The kernels' view of a configuration. Every width of every number is derived once, from the few numbers of a Config:
// the kernels, the SystemVerilog package, the manifests of the vectors and the documentation take it from here.
#ifndef HALFSPACE_HLS_FORMATS_FORMATS_HPP_
#define HALFSPACE_HLS_FORMATS_FORMATS_HPP_

#include <type_traits>

#include "hls/formats/lighting_formats.hpp"
#include "hls/formats/motion_formats.hpp"
#include "hls/formats/refusal.hpp"
#include "hls/formats/setup_formats.hpp"
#include "hls/formats/stamp.hpp"
#include "hls/formats/texture_formats.hpp"
#include "hls/numbers/fixed.hpp"
#include "hls/numbers/fixed_native.hpp"
#include "hls/numbers/pragmas.hpp"

namespace halfspace {

constexpr FormatTable format_table(const Config& c) {
  FormatTable t = setup_formats(c, FormatTable{});
  t = lighting_formats(c, t);
  t = texture_formats(c, t);
  t = motion_formats(c, t);
  t = object_formats(c, t);
  ChannelFormats formats{};
#define HS_CHANNEL(part, vertex, Vertex, channel, Channel, is_used, bits, fraction) \
  formats = channel_formats(c, bits, fraction);                                     \
  t.vertex = formats.value;                                                         \
  t.channel##_plane = formats.plane;                                                \
  t.channel##_gradient = formats.gradient;                                          \
  t.channel##_numerator = formats.numerator;                                        \
  t.channel##_start = formats.start;                                                \
  t.channel##_start_gradient = formats.start_gradient;
#include "hls/formats/lists/format_list.hpp"
  return t;
}

// What has the same width in every configuration.
template <template <int, int, bool> class Number>
struct FlagFormats {
  using Bit = Number<1, 1, false>;
  using VertexNumber = Number<2, 2, false>;  // 0 … 2
  using Keys = Number<2, 2, false>;          // bit k: key k contributed
};

// The kernels' view of configuration C (a type with config()) and of a stamp. A simulation may put another class in its
// place that has the same members, not constant: kernels use nothing of it as a template argument but the lanes.
template <class C, class S, template <int, int, bool> class Number = Fixed>
struct Formats : StampConstants<S>, FlagFormats<Number> {
  // The same on numbers that a constexpr can make.
  using Constexpr = Formats<C, S, native::Fixed>;
  static constexpr Config config() { return C::config(); }
  static constexpr FormatTable table() { return format_table(C::config()); }
  using Checked = AcceptedConfig<refusal(C::config())>;
  static_assert(sizeof(Checked) > 0, "the configuration is accepted");

#define HS_FLAG(Type, Name, function) static constexpr Type k##Name = function(config());
#define HS_CONSTANT(Name, field) static constexpr decltype(Config::field) k##Name = config().field;
#define HS_COMPILES(Unit, Name) using Compiles##Unit = std::integral_constant<bool, k##Name>;
#include "hls/formats/lists/constant_list.hpp"

  static constexpr int kStampsX = stamps_for(kWidth, S::kX);  // also the pitch of the buffers
  static constexpr int kStampsY = stamps_for(kHeight, S::kY);
  static constexpr int kStamps = kStampsX * kStampsY;

#define HS_FORMAT(part, member, Type, is_used, why) \
  using Type = Number<table().member.width, table().member.integer, table().member.is_signed>;
#include "hls/formats/lists/format_list.hpp"
#define HS_CHANNEL(part, vertex, Vertex, channel, Channel, is_used, bits, fraction) HS_CHANNEL_TYPES(Vertex, Channel)
#include "hls/formats/lists/format_list.hpp"
};

}  // namespace halfspace

#endif  // HALFSPACE_HLS_FORMATS_FORMATS_HPP_
