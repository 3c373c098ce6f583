// SPDX-License-Identifier: Apache-2.0
// The format table: every width of every number is derived here, once, from the few numbers of a Config.
// The kernels, the SystemVerilog package, the manifests of the vectors and the documentation take it from here.
#ifndef HALFSPACE_HLS_FORMATS_FORMATS_HPP_
#define HALFSPACE_HLS_FORMATS_FORMATS_HPP_

#include <type_traits>

#include "hls/formats/config.hpp"
#include "hls/numbers/fixed.hpp"

namespace halfspace {

// W bits, I of them before the binary point.
struct NumberFormat {
  int width, integer;
  bool is_signed;
};

struct FormatTable {
  NumberFormat x, y, index;
  NumberFormat coord, delta, area, signed_area, edge, edge_step, reciprocal, shift;
  NumberFormat depth, depth_plane, depth_gradient, depth_numerator, depth_start, depth_start_gradient;
  NumberFormat colour, colour_plane, colour_gradient, colour_numerator, colour_start, colour_start_gradient;
  NumberFormat material, light, gloss, normal, direction, squared_length, root, root_shift, dot, projection, cosine;
  NumberFormat coefficient, light_sum;
  NumberFormat normal_offset, normal_plane, normal_gradient, normal_numerator, normal_start, normal_start_gradient;
  NumberFormat texture, repeats, side, texel_address;
  NumberFormat coordinate, coordinate_plane, coordinate_gradient, coordinate_numerator;
  NumberFormat coordinate_start, coordinate_start_gradient;
  NumberFormat inverse, inverse_shift, texel_place, filtered;
  NumberFormat face, origin, extent, vector, key_weight;
  NumberFormat tile_x, tile_y, key_place, tap_weight, key_sum, key_blend;
  NumberFormat difference, difference_plane, difference_gradient, difference_numerator;
  NumberFormat difference_start, difference_start_gradient;
  NumberFormat object, object_count;
};

// A coefficient of a material, in LSB of the colour: 2^kCoefficientHead times full scale, so that a light brighter than
// white is no more than clamped where it shines; kCoefficientFraction bits are 1/128 LSB of rounding at most.
constexpr int kCoefficientHead = 2, kCoefficientFraction = 6;
// y of reciprocal_sqrt, in (½, 1).
constexpr int kRootFraction = 18;
// y of reciprocal_lookup, in (½, 1).
constexpr int kInverseFraction = 20;
// A triangle spans 2^e repetitions of its texture at most, each way.
constexpr int kRepeatBits = 4;
// Fraction bits of the place of a pixel among texels: the weights of a bilinear filter. And those that the filtered
// texel keeps: half of its last place is 2^−9 LSB of the picture.
constexpr int kWeightBits = 8, kFilteredFraction = 8;

// Pixels of a tile of a key frame, each way: what its cache fetches at once.
constexpr int kKeyTile = 8;

// u: fraction bits of a cosine. An exponent of 16 makes 16 times its error, so that 2^−(b+8) becomes 2^−4 LSB.
constexpr int cosine_fraction(const Config& c) { return c.colour_bits + 8; }

// What plane_setup takes and gives.
struct ChannelFormats {
  NumberFormat value, plane, gradient, numerator, start, start_gradient;
};

// Of a channel of b bits whose gradients have g fraction bits.
constexpr ChannelFormats channel_formats(const Config& config, int b, int g) {
  const int f = config.subpixel_bits, c = config.range_bits + f;
  ChannelFormats t{};
  t.value = {b, b, false};
  // A plane is kept modulo 2^b: at a covered pixel centre its value, less the error, lies between values of the
  // vertices, and the error is below ½ (see refusal), so the rounded value is one of 0 … 2^b − 1.
  t.plane = {b + g, b, false};
  t.gradient = {b + g, b, true};
  // N = dv1·dy2 − dv2·dy1 = v1·dy2 − v2·dy1 + v0·(dy1 − dy2): each v is in [0, 2^b), and the three factors sum to zero,
  // so N is at most 2^b times their positive part, a distance between two vertices: |N| < 2^(b+c).
  t.numerator = {b + c + 1, b + config.range_bits + 1, true};
  // The start of a plane lies a multiple of 2^−f pixels from vertex 0: it is summed with f + g fraction bits, modulo
  // 2^b, and takes the gradients modulo 2^(b+f).
  t.start = {b + g + f, b, true};
  t.start_gradient = {b + g + f, b + f, true};
  return t;
}

// The numbers of lighting; without it no record carries one, and the types are idle.
constexpr FormatTable lighting_formats(const Config& c, FormatTable t) {
  const int p = has_lighting(c) ? c.normal_bits : 9, lights = has_lighting(c) ? c.lights : 1;
  const int u = cosine_fraction(c);
  t.material = {bits_for(c.materials - 1), bits_for(c.materials - 1), false};
  t.light = {bits_for(lights - 1), bits_for(lights - 1), false};
  // Squarings: 0 … log2 of the largest exponent.
  t.gloss = {bits_for(exact_log2(c.gloss)), bits_for(exact_log2(c.gloss)), false};
  // A normal has any length, so that a component never needs the value 1; nor, but for half a last place, has a unit
  // vector of p + 1 bits. Directions are unit vectors; u + 2 bits of them, 18, are a factor of an FPGA's multiplier.
  t.normal = {p + 1, 1, true};
  t.direction = {u + 2, 1, true};
  // At most 3·(2^p)² < 2^(2p+2) units, an even number of bits: its root is shifted by half as many places.
  t.squared_length = {2 * p + 2, 2, false};
  t.root = {kRootFraction, 0, false};
  t.root_shift = {bits_for(p), bits_for(p), false};  // 0 … p
  // n·L, exact: at most 3·2^p·2^(u+1) < 2^(p+u+3) units.
  t.dot = {p + u + 4, 3, true};
  // The part of n·L above 0, with n normalized to 1 <= |n| < 2, so that it is below 2 but for what a direction is too
  // long.
  t.projection = {u + 1, 1, false};
  t.cosine = {u + 1, 1, false};  // 0 … 1
  t.coefficient = {c.colour_bits + kCoefficientHead + kCoefficientFraction, c.colour_bits + kCoefficientHead, false};
  // Exact: base, diffuse and specular of each light, times 1 at most.
  const int head = t.coefficient.integer + bits_for((has_gloss(c) ? 3 : 2) * lights);
  t.light_sum = {head + kCoefficientFraction + u, head, false};

  // A component as a channel of a plane: plus 2^p units it is a whole number without a sign, as the other channels are,
  // and the top bit inverted is all that takes.
  const ChannelFormats normal = channel_formats(c, p + 1, c.normal_fraction);
  t.normal_offset = normal.value;
  t.normal_plane = normal.plane;
  t.normal_gradient = normal.gradient;
  t.normal_numerator = normal.numerator;
  t.normal_start = normal.start;
  t.normal_start_gradient = normal.start_gradient;
  return t;
}

// The numbers of frames between key frames; without them no record carries one, and the types are idle.
constexpr FormatTable motion_formats(const Config& c, FormatTable t) {
  const int faces = has_motion(c) ? c.face_bits : 1;
  t.face = {faces, faces, false};  // 0: background
  // Where the places of a triangle in a key frame begin, in whole pixels, and log2 of how far they go at most:
  // positions.
  t.origin = {c.range_bits, c.range_bits, true};
  t.extent = {bits_for(c.range_bits), bits_for(c.range_bits), false};
  t.vector = {c.vector_range + 1 + c.vector_fraction, c.vector_range + 1, true};
  t.key_weight = {c.weight_bits + 1, 1, false};  // 0 … 1
  const int samples = has_motion(c) ? c.samples : 1, point = exact_log2(samples), w = c.weight_bits;
  const int tiles_x = (c.width + kKeyTile * samples - 1) / (kKeyTile * samples);
  const int tiles_y = (c.height + kKeyTile * samples - 1) / (kKeyTile * samples);
  t.tile_x = {bits_for(tiles_x - 1), bits_for(tiles_x - 1), false};
  t.tile_y = {bits_for(tiles_y - 1), bits_for(tiles_y - 1), false};
  // A place in a key frame less half a pixel of that, in pixels in between: at least ½ − 2^r − 2, and less than side +
  // 2^r, which has r + 1 bits or more. The pixels of a key frame move the point.
  const int reach = 1 + bits_for(max_of(c.width, c.height) + (1 << c.vector_range));
  t.key_place = {reach + c.vector_fraction, reach - point, true};
  t.tap_weight = {w + 2, 2, true};  // −½ … 1
  // Σ weights·colours of one key, exact; a bicubic one lies in (−½, 3/2) of full scale, and a difference adds (−1, 1).
  const int head = c.colour_bits + int(c.filter == KeyFilter::kBicubic) + int(relights(c)) + 1;
  t.key_sum = {head + 2 * w, head, true};
  t.key_blend = {head + 3 * w, head, true};  // a mean of two of them
  // A difference of colours plus 2^c, in units of 2^−d, is a whole number without a sign, as the other channels are.
  const ChannelFormats difference = channel_formats(c, difference_bits(c), c.colour_fraction);
  t.difference = difference.value;
  t.difference_plane = difference.plane;
  t.difference_gradient = difference.gradient;
  t.difference_numerator = difference.numerator;
  t.difference_start = difference.start;
  t.difference_start_gradient = difference.start_gradient;
  return t;
}

// The numbers of texture; without it no record carries one, and the types are idle.
constexpr FormatTable texture_formats(const Config& c, FormatTable t) {
  const int b = has_coordinates(c) ? c.coordinate_bits : 10, memory = has_texture(c) ? exact_log2(c.texels) : 2;
  // log2 of the longest side: the other has one texel, or two in banks.
  const int side = is_bilinear(c) ? memory - 1 : memory;
  // 0: none; 1 … textures.
  t.texture = {bits_for(c.textures), bits_for(c.textures), false};
  t.repeats = {kRepeatBits, kRepeatBits, false};
  t.side = {bits_for(side), bits_for(side), false};
  t.texel_address = {memory, memory, false};
  const ChannelFormats coordinate = channel_formats(c, b, c.coordinate_fraction);
  t.coordinate = coordinate.value;
  t.coordinate_plane = coordinate.plane;
  t.coordinate_gradient = coordinate.gradient;
  t.coordinate_numerator = coordinate.numerator;
  t.coordinate_start = coordinate.start;
  t.coordinate_start_gradient = coordinate.start_gradient;
  t.inverse = {kInverseFraction, 0, false};
  t.inverse_shift = {bits_for(b - 1), bits_for(b - 1), false};  // leading zeros of q >= 1
  t.texel_place = {side + kWeightBits, side, false};            // in texels, modulo the side
  t.filtered = {c.colour_bits + kFilteredFraction, c.colour_bits, false};
  return t;
}

constexpr FormatTable format_table(const Config& c) {
  FormatTable t{};
  const int f = c.subpixel_bits;
  const int depth_bits = has_depth(c) ? c.depth_bits : 1;  // no record carries a depth then, and its types are idle

  // Frame sizes 1 … width, and pixel coordinates. The same width whatever the stamp.
  t.x = {bits_for(c.width), bits_for(c.width), false};
  t.y = {bits_for(c.height), bits_for(c.height), false};
  // 0 is the background, so N triangles need N + 1 values.
  t.index = {bits_for(c.triangles), bits_for(c.triangles), false};

  // A position: range_bits before the point, the sign among them; c bits in all.
  t.coord = {c.range_bits + f, c.range_bits, true};
  // |x1 − x0| < 2^c units: one bit more than a position.
  t.delta = {t.coord.width + 1, c.range_bits + 1, true};
  // Twice the area of a triangle within a square of side s is at most s²: |D| < 2^(2c).
  t.area = {2 * t.coord.width, 2 * c.range_bits, false};
  t.signed_area = {t.area.width + 1, t.area.integer + 1, true};
  // Twice the area of (vertex, vertex, pixel centre), less the tie bias of one: [−2^(2c), 2^(2c)).
  t.edge = {t.area.width + 1, t.area.integer + 1, true};
  // Steps are multiples of 2^f units, so the low f bits never change, and the sign of a number is the sign of its
  // floor: they are dropped once the bias is folded in.
  t.edge_step = {t.edge.width - f, t.edge.integer, true};
  // R = round(2^(r+s) / D) with 2^s <= D < 2^(s+1): 2^(r−1) <= R <= 2^r.
  t.reciprocal = {c.reciprocal_bits + 1, 1, false};
  // s = floor(log2 D): 0 … 2c − 1.
  t.shift = {bits_for(t.area.width - 1), bits_for(t.area.width - 1), false};

  const ChannelFormats depth = channel_formats(c, depth_bits, c.depth_fraction);
  t.depth = depth.value;
  t.depth_plane = depth.plane;
  t.depth_gradient = depth.gradient;
  t.depth_numerator = depth.numerator;
  t.depth_start = depth.start;
  t.depth_start_gradient = depth.start_gradient;
  // A flat colour is a plane without gradients and without fraction bits.
  const ChannelFormats colour = channel_formats(c, c.colour_bits, c.colour_fraction);
  t.colour = colour.value;
  t.colour_plane = colour.plane;
  t.colour_gradient = colour.gradient;
  t.colour_numerator = colour.numerator;
  t.colour_start = colour.start;
  t.colour_start_gradient = colour.start_gradient;
  // 0 is the background; and how many pixels of a frame show an object.
  const int object = has_objects(c) ? c.object_bits : 1;
  t.object = {object, object, false};
  t.object_count = {bits_for(c.width * c.height), bits_for(c.width * c.height), false};
  return motion_formats(c, texture_formats(c, lighting_formats(c, t)));
}

// Stamps that `pixels` pixels take, `lanes` a stamp.
constexpr int stamps_for(int pixels, int lanes) { return (pixels + lanes - 1) / lanes; }

// A stamp is the X × Y block of pixels that the units handle in one cycle, one lane a pixel. Lane l is the pixel
// (l mod X, l div X) of its stamp.
template <int X, int Y>
struct StampShape {
  static constexpr int kX = X, kY = Y;
};
using Stamp1 = StampShape<1, 1>;
using Stamp2 = StampShape<2, 1>;
using Stamp4 = StampShape<2, 2>;
using Stamp8 = StampShape<4, 2>;
using Stamp16 = StampShape<4, 4>;

// The kernels' view of configuration C (a type with config()) and of a stamp. A simulation may put another class in its
// place that has the same members, not constant: kernels use nothing of it as a template argument but the lanes.
template <class C, class S>
struct Formats {
  static constexpr Config config() { return C::config(); }
  static constexpr FormatTable table() { return format_table(C::config()); }
  using Checked = AcceptedConfig<refusal(C::config())>;
  static_assert(sizeof(Checked) > 0, "the configuration is accepted");

  static constexpr int kLanesX = S::kX, kLanesY = S::kY, kLanes = S::kX * S::kY;
  static constexpr int kLog2LanesX = exact_log2(kLanesX), kLog2LanesY = exact_log2(kLanesY);
  static_assert(kLanesX == 1 << kLog2LanesX && kLanesY == 1 << kLog2LanesY && kLanesX <= 4 && kLanesY <= 4,
                "a stamp is a power of two of pixels each way, and 4 at most");
  static constexpr int kWidth = config().width, kHeight = config().height;
  static constexpr int kStampsX = stamps_for(kWidth, kLanesX);  // also the pitch of the buffers
  static constexpr int kStampsY = stamps_for(kHeight, kLanesY);
  static constexpr int kStamps = kStampsX * kStampsY;
  static constexpr int kTriangles = config().triangles;
  static constexpr bool kHasDepth = has_depth(config()), kGouraud = is_gouraud(config());
  static constexpr bool kPhong = is_phong(config()), kShadesPlanes = shades_planes(config());
  static constexpr bool kHasLighting = has_lighting(config()), kHasGloss = has_gloss(config());
  static constexpr bool kDeferred = is_deferred(config());
  static constexpr bool kHasPlanes = has_planes(config());
  static constexpr bool kHasTexture = has_texture(config()), kBilinear = is_bilinear(config());
  static constexpr bool kPerspective = has_perspective(config());
  static constexpr bool kHasMotion = has_motion(config()), kRelights = relights(config());
  static constexpr bool kHasColours = has_colours(config());
  static constexpr bool kHasObjects = has_objects(config());
  static constexpr KeyFilter kFilter = config().filter;
  static constexpr bool kSendsShape = sends_shape(config()), kOrdersVertices = orders_vertices(config());
  static constexpr bool kStoresDepth = stores_depth(config()), kTestsPlanes = tests_planes(config());
  // Whether ztest_plane is compiled: refusal() holds the words of its products for type γ alone.
  using CompilesPlaneTest = std::integral_constant<bool, kTestsPlanes>;
  // So with phong_setup and shade_phong, and with light_vertex.
  using CompilesPhong = std::integral_constant<bool, kPhong>;
  using CompilesLighting = std::integral_constant<bool, kHasLighting>;
  // And with texture_setup and shade_texture.
  using CompilesTexture = std::integral_constant<bool, kHasTexture>;
  // And with motion_setup, motion_field and motion_compensate.
  using CompilesMotion = std::integral_constant<bool, kHasMotion>;
  static constexpr int kSubpixelBits = config().subpixel_bits;
  static constexpr int kReciprocalFraction = config().reciprocal_bits;
  static constexpr int kAreaBits = table().area.width;
  static constexpr int kDepthBits = config().depth_bits;
  static constexpr int kColourBits = config().colour_bits;
  static constexpr int kLights = config().lights, kMaterials = config().materials;
  static constexpr int kSquarings = exact_log2(config().gloss);
  static constexpr int kTexels = config().texels, kTextures = config().textures;
  static constexpr int kVectorRange = config().vector_range, kVectorFraction = config().vector_fraction;
  static constexpr int kWeightBits = config().weight_bits, kLog2Samples = exact_log2(config().samples);

#define HS_NUMBER(field) Fixed<table().field.width, table().field.integer, table().field.is_signed>
  using X = HS_NUMBER(x);  // pixels or stamps to the right, and frame widths
  using Y = HS_NUMBER(y);  // pixels or stamps downward, and frame heights
  using Index = HS_NUMBER(index);
  using Coord = HS_NUMBER(coord);
  using Delta = HS_NUMBER(delta);
  using Area = HS_NUMBER(area);
  using SignedArea = HS_NUMBER(signed_area);
  using Edge = HS_NUMBER(edge);
  using EdgeStep = HS_NUMBER(edge_step);
  using Reciprocal = HS_NUMBER(reciprocal);
  using Shift = HS_NUMBER(shift);
  using Depth = HS_NUMBER(depth);
  using DepthPlane = HS_NUMBER(depth_plane);
  using DepthGradient = HS_NUMBER(depth_gradient);
  using Colour = HS_NUMBER(colour);
  using ColourPlane = HS_NUMBER(colour_plane);
  using ColourGradient = HS_NUMBER(colour_gradient);
  // What plane_setup takes.
  struct DepthChannel {
    using Value = HS_NUMBER(depth);
    using PlaneValue = HS_NUMBER(depth_plane);
    using Gradient = HS_NUMBER(depth_gradient);
    using Numerator = HS_NUMBER(depth_numerator);
    using Start = HS_NUMBER(depth_start);
    using StartGradient = HS_NUMBER(depth_start_gradient);
  };
  struct ColourChannel {
    using Value = HS_NUMBER(colour);
    using PlaneValue = HS_NUMBER(colour_plane);
    using Gradient = HS_NUMBER(colour_gradient);
    using Numerator = HS_NUMBER(colour_numerator);
    using Start = HS_NUMBER(colour_start);
    using StartGradient = HS_NUMBER(colour_start_gradient);
  };
  using MaterialNumber = HS_NUMBER(material);
  using LightNumber = HS_NUMBER(light);
  using Gloss = HS_NUMBER(gloss);
  using Normal = HS_NUMBER(normal);
  using Direction = HS_NUMBER(direction);
  using SquaredLength = HS_NUMBER(squared_length);
  using Root = HS_NUMBER(root);
  using RootShift = HS_NUMBER(root_shift);
  using Dot = HS_NUMBER(dot);
  using Projection = HS_NUMBER(projection);
  using Cosine = HS_NUMBER(cosine);
  using Coefficient = HS_NUMBER(coefficient);
  using LightSum = HS_NUMBER(light_sum);
  using NormalPlane = HS_NUMBER(normal_plane);
  using NormalGradient = HS_NUMBER(normal_gradient);
  struct NormalChannel {
    using Value = HS_NUMBER(normal_offset);
    using PlaneValue = HS_NUMBER(normal_plane);
    using Gradient = HS_NUMBER(normal_gradient);
    using Numerator = HS_NUMBER(normal_numerator);
    using Start = HS_NUMBER(normal_start);
    using StartGradient = HS_NUMBER(normal_start_gradient);
  };
  using TextureNumber = HS_NUMBER(texture);
  using Repeats = HS_NUMBER(repeats);
  using Side = HS_NUMBER(side);
  using TexelAddress = HS_NUMBER(texel_address);
  using Coordinate = HS_NUMBER(coordinate);
  using CoordinatePlane = HS_NUMBER(coordinate_plane);
  using CoordinateGradient = HS_NUMBER(coordinate_gradient);
  struct CoordinateChannel {
    using Value = HS_NUMBER(coordinate);
    using PlaneValue = HS_NUMBER(coordinate_plane);
    using Gradient = HS_NUMBER(coordinate_gradient);
    using Numerator = HS_NUMBER(coordinate_numerator);
    using Start = HS_NUMBER(coordinate_start);
    using StartGradient = HS_NUMBER(coordinate_start_gradient);
  };
  using Inverse = HS_NUMBER(inverse);
  using InverseShift = HS_NUMBER(inverse_shift);
  using TexelPlace = HS_NUMBER(texel_place);
  using Filtered = HS_NUMBER(filtered);
  using Face = HS_NUMBER(face);
  using Origin = HS_NUMBER(origin);
  using Extent = HS_NUMBER(extent);
  using Vector = HS_NUMBER(vector);
  using KeyWeight = HS_NUMBER(key_weight);
  using TileX = HS_NUMBER(tile_x);
  using TileY = HS_NUMBER(tile_y);
  using KeySum = HS_NUMBER(key_sum);
  using KeyBlend = HS_NUMBER(key_blend);
  using Difference = HS_NUMBER(difference);
  using DifferencePlane = HS_NUMBER(difference_plane);
  using DifferenceGradient = HS_NUMBER(difference_gradient);
  struct DifferenceChannel {
    using Value = HS_NUMBER(difference);
    using PlaneValue = HS_NUMBER(difference_plane);
    using Gradient = HS_NUMBER(difference_gradient);
    using Numerator = HS_NUMBER(difference_numerator);
    using Start = HS_NUMBER(difference_start);
    using StartGradient = HS_NUMBER(difference_start_gradient);
  };
  using Object = HS_NUMBER(object);
  using ObjectCount = HS_NUMBER(object_count);
#undef HS_NUMBER
};

}  // namespace halfspace

#endif  // HALFSPACE_HLS_FORMATS_FORMATS_HPP_
