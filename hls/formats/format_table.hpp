// SPDX-License-Identifier: Apache-2.0
// The table of formats, a width a number; format_list.hpp says which there are.
#ifndef HALFSPACE_HLS_FORMATS_FORMAT_TABLE_HPP_
#define HALFSPACE_HLS_FORMATS_FORMAT_TABLE_HPP_

#include "hls/formats/config.hpp"

namespace halfspace {

// W bits, I of them before the binary point.
struct NumberFormat {
  int width, integer;
  bool is_signed;
};

struct FormatTable {
#define HS_FORMAT(part, member, Type, is_used, why) NumberFormat member;
#include "hls/formats/lists/format_list.hpp"
};

// The types that plane_setup takes of a channel, for a view of the table that has its formats as types.
#define HS_CHANNEL_TYPES(Vertex, Name)         \
  struct Name##Channel {                       \
    using Value = Vertex;                      \
    using PlaneValue = Name##Plane;            \
    using Gradient = Name##Gradient;           \
    using Numerator = Name##Numerator;         \
    using Start = Name##Start;                 \
    using StartGradient = Name##StartGradient; \
  };

}  // namespace halfspace

#endif  // HALFSPACE_HLS_FORMATS_FORMAT_TABLE_HPP_
