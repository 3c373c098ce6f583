// SPDX-License-Identifier: Apache-2.0
// What a configuration chooses, and why one is refused. hls/formats/configs/ holds the named ones.
#ifndef HALFSPACE_HLS_FORMATS_CONFIG_HPP_
#define HALFSPACE_HLS_FORMATS_CONFIG_HPP_

#include <cstdint>

namespace halfspace {

// Gouraud: colours are planes over a triangle. Flat: a triangle has one colour, that of its first vertex as given.
// Phong: normals are planes, and each visible pixel is lit. Motion: a frame between two key frames; places in these are
// planes, and a visible pixel comes to vectors to them, which motion_compensate fetches its colour along.
enum class Shading { kGouraud, kFlat, kPhong, kMotion };

// Index rendering, where the depth of a pixel comes from that a fragment is tested against. Type δ: a Z-buffer keeps
// it. Type γ: there is none; the plane of the triangle whose index is stored is fetched from TdbV and evaluated again.
enum class Architecture { kDelta, kGamma };

// Texture at scan-out: none, the texel that a pixel's centre lies in, or four of them weighted.
enum class TextureFilter { kNone, kNearest, kBilinear };

// How texture coordinates, or places in a key frame, vary over a triangle on the screen: by planes of u and v, or by
// planes of u/w, v/w and 1/w and a division a pixel.
enum class TextureMapping { kAffine, kPerspective };

// What motion_compensate takes of a key frame: the pixel that a place lies in; two by two, weighted by distance along
// each axis, or by area and distance; or four by four, with the weights of Catmull and Rom.
enum class KeyFilter { kNone, kNearest, kBilinear, kArea, kBicubic };

// A configuration, as in its .toml file. Nothing here can be derived from the rest. What is not there has no numbers:
// they are 0.
struct Config {
  const char* name;
  int width, height;    // largest frame, pixels
  int triangles;        // triangles a frame; indices 1 … triangles, 0 is the background
  int range_bits;       // vertices lie in [−2^(range_bits−1), 2^(range_bits−1)) pixels: the guard band
  int subpixel_bits;    // f: fraction bits of a vertex position
  int depth_bits;       // b of depth: bits of a depth that is compared; 0: no depth, the first drawn wins each pixel
  int colour_bits;      // b of a colour channel
  int reciprocal_bits;  // r: the reciprocal of the area has r fraction bits after its leading one; 0 without planes
  int depth_fraction;   // g of the depth plane: fraction bits of its gradients; 0 without depth
  int colour_fraction;  // g of the colour planes; 0 without Gouraud shading
  int lanes;            // pixels a stamp, 1, 2, 4, 8 or 16: what the units handle in a cycle
  Shading shading = Shading::kGouraud;
  Architecture architecture = Architecture::kDelta;
  // Lighting in hardware; all 0 without it.
  int normal_bits = 0;      // p: fraction bits of a component of a normal
  int lights = 0;           // lights that are built; 0: no lighting
  int gloss = 0;            // largest exponent of a highlight: 1, 2, 4, 8, 16; 0: no highlights
  int materials = 0;        // materials a frame
  int normal_fraction = 0;  // g of the planes of normals; 0 without Phong shading
  // Texture; all 0, and the mapping affine, without it.
  TextureFilter texture = TextureFilter::kNone;
  TextureMapping mapping = TextureMapping::kAffine;
  int texels = 0;               // of the texture memory, a power of two
  int textures = 0;             // a frame
  int coordinate_bits = 0;      // b of a texture coordinate
  int coordinate_fraction = 0;  // g of the planes of texture coordinates
  // Frames between key frames; all 0 unless shading is kMotion, whose places have the mapping, b and g of texture
  // coordinates.
  KeyFilter filter = KeyFilter::kNone;
  int vector_range = 0;     // a component of a vector lies in [−2^vector_range, 2^vector_range) pixels
  int vector_fraction = 0;  // and is a multiple of 2^−vector_fraction
  int weight_bits = 0;      // weights, of key frames and of their pixels, are multiples of 2^−weight_bits
  int face_bits = 0;        // of the number of a face, 1 … 2^face_bits − 1
  int relight = 0;          // 1: planes of what the colour in between differs by from a key's
  int samples = 0;          // pixels of the frame in between a pixel of a key frame, each way: 1, 2, 4
  // Static objects buffers: of the number of an object, 1 … 2^object_bits − 1; 0: pixels know no object, and nothing is
  // merged.
  int object_bits = 0;
};

constexpr bool has_depth(const Config& c) { return c.depth_bits != 0; }
// Whether the Z-test reads a stored depth, or the plane of the stored triangle; neither without depth.
constexpr bool stores_depth(const Config& c) { return has_depth(c) && c.architecture == Architecture::kDelta; }
constexpr bool tests_planes(const Config& c) { return c.architecture == Architecture::kGamma; }
constexpr bool is_gouraud(const Config& c) { return c.shading == Shading::kGouraud; }
constexpr bool is_phong(const Config& c) { return c.shading == Shading::kPhong; }
// Whether a triangle has planes of what it is shaded with.
constexpr bool shades_planes(const Config& c) { return is_gouraud(c) || is_phong(c); }
constexpr bool has_lighting(const Config& c) { return c.lights != 0; }
constexpr bool has_gloss(const Config& c) { return c.gloss != 0; }
constexpr bool has_texture(const Config& c) { return c.texture != TextureFilter::kNone; }
constexpr bool is_bilinear(const Config& c) { return c.texture == TextureFilter::kBilinear; }
constexpr bool has_perspective(const Config& c) { return c.mapping == TextureMapping::kPerspective; }
constexpr bool has_motion(const Config& c) { return c.shading == Shading::kMotion; }
constexpr bool relights(const Config& c) { return c.relight != 0; }
constexpr bool has_objects(const Config& c) { return c.object_bits != 0; }
// N: a key frame's pixels are kept in N × N banks, by column and row modulo N, of which a filter reads each at once.
constexpr int key_side(KeyFilter filter) { return filter == KeyFilter::kBicubic ? 4 : 2; }
// Whether there are planes of coordinates: of a texture, or of places in key frames.
constexpr bool has_coordinates(const Config& c) { return has_texture(c) || has_motion(c); }
// Whether normals, texture coordinates or motion of a triangle come after it has turned out visible (deferred shading).
constexpr bool is_deferred(const Config& c) { return has_lighting(c) || has_coordinates(c); }
// Whether triangles come with colours.
constexpr bool has_colours(const Config& c) { return !has_lighting(c) && !has_motion(c); }
// Whether what comes after the setup of triangles needs their shape, for planes.
constexpr bool sends_shape(const Config& c) { return shades_planes(c) || has_coordinates(c); }
// Whether values come for the vertices in the order given, after the setup has put these in its own.
constexpr bool orders_vertices(const Config& c) { return (has_lighting(c) && shades_planes(c)) || has_coordinates(c); }
// Whether a triangle has a plane at all, and needs the reciprocal of its area.
constexpr bool has_planes(const Config& c) { return has_depth(c) || sends_shape(c); }
// Bits of a component of a normal, with its sign, as a plane has it; 0 without Phong shading.
constexpr int normal_plane_bits(const Config& c) { return is_phong(c) ? c.normal_bits + 1 : 0; }
// Whether there are planes of colours, or of their differences; and bits of a channel of them.
constexpr bool has_colour_planes(const Config& c) { return is_gouraud(c) || relights(c); }
// A difference of colours has a sign, and fraction bits: half of its last place is 1/32 LSB. A filter has 2·weight_bits
// of them or more.
constexpr int kDifferenceFraction = 4;
constexpr int difference_bits(const Config& c) { return c.colour_bits + kDifferenceFraction + 1; }
constexpr int colour_plane_bits(const Config& c) { return relights(c) ? difference_bits(c) : c.colour_bits; }

// Bits that hold 0 … n.
constexpr int bits_for(std::int64_t n) { return n < 2 ? 1 : 1 + bits_for(n / 2); }
// log2 of a power of two.
constexpr int exact_log2(int n) { return n < 2 ? 0 : 1 + exact_log2(n / 2); }

constexpr int max_of(int a, int b) { return a > b ? a : b; }

// Cycles that hs_plane_setup takes for the depth plane of a triangle, from its record to the plane: eight products on
// one multiplier, each by a distance or by the reciprocal in chunks of 17 bits, and three cycles from a product to its
// sum.
constexpr int depth_plane_latency(const Config& c) {
  const int chunk = 17, to_sum = 3;
  const int by_distance = 2 * ((c.range_bits + c.subpixel_bits + chunk - 1) / chunk);
  const int by_reciprocal = (c.reciprocal_bits + 1 + chunk - 1) / chunk;
  const int gradient_x = max_of(2 * by_distance, by_distance + to_sum);  // N_A is known, and N_B issued
  const int gradient_y = max_of(gradient_x + by_reciprocal, 2 * by_distance + to_sum);
  return gradient_y + by_reciprocal + to_sum + by_distance + to_sum;
}

// Cycles at least that the RTL's triangle setup takes for a triangle that is not empty: those of the slowest of three
// units that work on three triangles at once. The edges take 14, one of them to hand D to the divider, and one more
// where the vertices come with D < 0; the division a quotient bit a cycle, and one to load it; a depth plane leaves
// before the next one is begun.
constexpr int setup_interval(const Config& c) {
  const int edges = has_planes(c) ? 14 : 13;
  const int division = has_planes(c) ? c.reciprocal_bits + 3 : 0;
  const int depth = has_depth(c) ? depth_plane_latency(c) + 1 : 0;
  return max_of(max_of(edges, division), depth);
}

// Why a configuration is refused; the first reason that holds. refusal_text() in vectors/ has them as sentences.
enum class Refusal {
  kNone,
  kFrameSize,          // 1 … 8192 pixels each way
  kTriangles,          // 1 … 2^22
  kSubpixelBits,       // 1 … 12: without one, a pixel centre is no position
  kDepthBits,          // 2 … 32, or 0
  kColourBits,         // 1 … 8
  kLanes,              // 1, 2, 4, 8, 16
  kFractionBits,       // 1 … 40 for g, 2 … 40 for r
  kIdleBits,           // a number of what is not there
  kUnlitPhong,         // Phong shading without lights
  kIdleArchitecture,   // type γ without depth: there is no plane to evaluate
  kFrameOutsideRange,  // the centres of all stamps, and of the stamps around the frame, are positions
  kDepthError,         // the depth plane is off by half an LSB or more
  kColourError,        // the colour planes are off by half an LSB or more
  kNormalError,        // the planes of normals are off by half a unit of 2^−p or more
  kCoordinateError,    // the planes of texture coordinates are off by half a unit or more
  kReciprocalShort,    // a gradient keeps no more fraction bits than its reciprocal has
  kEdgeWord,           // an edge function, with the carry of its subtraction, is one machine word
  kNumeratorWord,      // so is the numerator of a gradient
  kGradientWord,       // so are the halves of the product with the reciprocal, and the half that rounds it
  kStartWord,          // so is the start of a plane
  kShadeWord,          // so is a gradient of a colour, a normal or a texture coordinate times a pixel coordinate
  kTestWord,           // and for type γ a depth gradient times a pixel coordinate
  kNormalBits,      // 9 … 16: the square of a length fills the fields of a reciprocal root; all products are one word
  kLights,          // 0 … 4: a normal takes a cycle a light
  kGloss,           // 0, 1, 2, 4, 8, 16
  kMaterials,       // 1 … 4096
  kIdleLighting,    // a number of lighting where there is none
  kCoordinateBits,  // 10 … 24: the weights of texels take 8; a factor of a multiplier of 25 bits
  kTexels,          // 4 … 2^20, a power of two: the place of a texel, shifted for its texture, is one word
  kTextures,        // 1 … 256
  kIdleTexture,     // a number of texture where there is none
  kMotionShading,   // a frame in between is neither lit nor textured
  kFilter,          // there is one
  kVector,          // range 1 … 13, fraction 1 … 8
  kWeightBits,      // 2 … 8
  kFaceBits,        // 1 … 22
  kRelight,         // 0, 1
  kSamples,         // 1, 2, 4
  kIdleMotion,      // a number of motion where there is none
  kObjectBits,      // 0 … 22
  kObjectsNeedDepth,  // a merge compares depths that a Z-buffer holds: not without it, and not of a frame in between
};

// |error| <= 2^(b−r) + (|dx| + |dy|)·2^−(g+1) < ½ LSB, for the farthest vertex that a pixel of the frame can be
// measured from; both sides times 2^(g+1).
constexpr bool plane_error_ok(const Config& c, int b, int g) {
  const std::int64_t reach = (std::int64_t(1) << c.range_bits) + c.width + c.height;
  const int n = b + g + 1 - c.reciprocal_bits;
  return b < c.reciprocal_bits && reach < (std::int64_t(1) << g) - (n < 0 ? 0 : std::int64_t(1) << n);
}

constexpr bool within(int value, int low, int high) { return value >= low && value <= high; }

constexpr Refusal refusal(const Config& c) {
  if (!within(c.width, 1, 8192) || !within(c.height, 1, 8192)) return Refusal::kFrameSize;
  if (!within(c.triangles, 1, 1 << 22)) return Refusal::kTriangles;
  if (!within(c.subpixel_bits, 1, 12)) return Refusal::kSubpixelBits;
  if (has_depth(c) && !within(c.depth_bits, 2, 32)) return Refusal::kDepthBits;
  if (!within(c.colour_bits, 1, 8)) return Refusal::kColourBits;
  if (!within(c.lanes, 1, 16) || c.lanes != 1 << exact_log2(c.lanes)) return Refusal::kLanes;
  if (is_phong(c) && !has_lighting(c)) return Refusal::kUnlitPhong;
  if ((has_planes(c) && !within(c.reciprocal_bits, 2, 40)) || (has_depth(c) && !within(c.depth_fraction, 1, 40)) ||
      (has_colour_planes(c) && !within(c.colour_fraction, 1, 40)) ||
      (is_phong(c) && !within(c.normal_fraction, 1, 40)) ||
      (has_coordinates(c) && !within(c.coordinate_fraction, 1, 40))) {
    return Refusal::kFractionBits;
  }
  if ((!has_planes(c) && c.reciprocal_bits != 0) || (!has_depth(c) && c.depth_fraction != 0) ||
      (!has_colour_planes(c) && c.colour_fraction != 0) || (!is_phong(c) && c.normal_fraction != 0)) {
    return Refusal::kIdleBits;
  }
  if (tests_planes(c) && !has_depth(c)) return Refusal::kIdleArchitecture;
  if (is_phong(c) && !within(c.normal_bits, 9, 16)) return Refusal::kNormalBits;
  if (has_motion(c) && (has_lighting(c) || has_texture(c))) return Refusal::kMotionShading;
  if (has_coordinates(c) && !within(c.coordinate_bits, 10, 24)) return Refusal::kCoordinateBits;
  if (has_texture(c)) {
    if (!within(c.texels, 4, 1 << 20) || c.texels != 1 << exact_log2(c.texels)) return Refusal::kTexels;
    if (!within(c.textures, 1, 256)) return Refusal::kTextures;
  } else if (c.texels != 0 || c.textures != 0) {
    return Refusal::kIdleTexture;
  }
  if (!has_coordinates(c) && (has_perspective(c) || c.coordinate_bits != 0 || c.coordinate_fraction != 0)) {
    return Refusal::kIdleTexture;
  }
  if (has_motion(c)) {
    if (c.filter == KeyFilter::kNone) return Refusal::kFilter;
    if (!within(c.vector_range, 1, 13) || !within(c.vector_fraction, 1, 8)) return Refusal::kVector;
    if (!within(c.weight_bits, 2, 8)) return Refusal::kWeightBits;
    if (!within(c.face_bits, 1, 22)) return Refusal::kFaceBits;
    if (!within(c.relight, 0, 1)) return Refusal::kRelight;
    if (!within(c.samples, 1, 4) || c.samples == 3) return Refusal::kSamples;
  } else if (c.filter != KeyFilter::kNone || c.vector_range != 0 || c.vector_fraction != 0 || c.weight_bits != 0 ||
             c.face_bits != 0 || c.relight != 0 || c.samples != 0) {
    return Refusal::kIdleMotion;
  }
  if (!within(c.object_bits, 0, 22)) return Refusal::kObjectBits;
  if (has_objects(c) && (!stores_depth(c) || has_motion(c))) return Refusal::kObjectsNeedDepth;
  const int longer_side = c.width > c.height ? c.width : c.height;
  const int margin = 3 * 4;  // pixels of the stamps around the frame, 4 at most each way
  if (!within(c.range_bits, 1, 20) || longer_side + margin > 1 << (c.range_bits - 1))
    return Refusal::kFrameOutsideRange;
  if (has_depth(c) && !plane_error_ok(c, c.depth_bits, c.depth_fraction)) return Refusal::kDepthError;
  const int colour = colour_plane_bits(c);
  if (has_colour_planes(c) && !plane_error_ok(c, colour, c.colour_fraction)) return Refusal::kColourError;
  const int normal = normal_plane_bits(c);
  if (is_phong(c) && !plane_error_ok(c, normal, c.normal_fraction)) return Refusal::kNormalError;
  const int coordinate = c.coordinate_bits;
  if (has_coordinates(c) && !plane_error_ok(c, coordinate, c.coordinate_fraction)) return Refusal::kCoordinateError;
  const int fraction =
      max_of(max_of(c.depth_fraction, c.colour_fraction), max_of(c.normal_fraction, c.coordinate_fraction));
  if (has_planes(c) && c.reciprocal_bits < c.subpixel_bits + fraction) return Refusal::kReciprocalShort;
  const int position = c.range_bits + c.subpixel_bits;
  const int value = max_of(max_of(c.depth_bits, colour), max_of(normal, coordinate));
  const int numerator = value + position + 1;
  if (2 * position + 3 > 64) return Refusal::kEdgeWord;
  if (numerator + 2 > 64) return Refusal::kNumeratorWord;  // the sum of its two products, as types grow
  if (numerator - 24 + c.reciprocal_bits + 1 > 63 || 24 + c.reciprocal_bits + 1 > 63) return Refusal::kGradientWord;
  // n of gradient_product, where D is largest: the half that is added is 2^(n−1).
  const int n = 2 * position - 1 + c.reciprocal_bits - c.subpixel_bits;
  if ((has_depth(c) && n - c.depth_fraction > 63) || (has_colour_planes(c) && n - c.colour_fraction > 63) ||
      (is_phong(c) && n - c.normal_fraction > 63) || (has_coordinates(c) && n - c.coordinate_fraction > 63)) {
    return Refusal::kGradientWord;
  }
  if (c.depth_bits + c.depth_fraction + c.subpixel_bits > 63 || colour + c.colour_fraction + c.subpixel_bits > 63 ||
      normal + c.normal_fraction + c.subpixel_bits > 63 || coordinate + c.coordinate_fraction + c.subpixel_bits > 63) {
    return Refusal::kStartWord;
  }
  const int plane =
      max_of(max_of(colour + c.colour_fraction, normal + c.normal_fraction), coordinate + c.coordinate_fraction);
  if (plane + bits_for(longer_side) > 64) return Refusal::kShadeWord;
  if (tests_planes(c) && c.depth_bits + c.depth_fraction + bits_for(longer_side) > 64) return Refusal::kTestWord;
  if (!has_lighting(c)) {
    return c.normal_bits == 0 && c.gloss == 0 && c.materials == 0 ? Refusal::kNone : Refusal::kIdleLighting;
  }
  if (!within(c.normal_bits, 9, 16)) return Refusal::kNormalBits;
  if (!within(c.lights, 1, 4)) return Refusal::kLights;
  if (!within(c.gloss, 0, 16) || (has_gloss(c) && c.gloss != 1 << exact_log2(c.gloss))) return Refusal::kGloss;
  if (!within(c.materials, 1, 4096)) return Refusal::kMaterials;
  return Refusal::kNone;
}

// Compiles for an accepted configuration alone: a compiler that refuses prints the reason as the argument.
template <Refusal R>
struct AcceptedConfig {
  static_assert(R == Refusal::kNone, "this configuration is refused: the argument R of AcceptedConfig says why");
};

}  // namespace halfspace

#endif  // HALFSPACE_HLS_FORMATS_CONFIG_HPP_
