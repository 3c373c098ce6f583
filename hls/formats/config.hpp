// SPDX-License-Identifier: Apache-2.0
// What a configuration chooses. hls/formats/configs/ holds the named ones; refusal.hpp says which can be built.
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

// Which triangles the setup drops by the sign of their area, as if they had none: those seen from behind, whose
// vertices come clockwise on the screen, or those seen from the front.
enum class Cull { kNone, kBack, kFront };

// A configuration, as in its .toml file. Nothing here can be derived from the rest. What is not there has no numbers:
// they are 0.
struct Config {
  const char* name;
#define HS_NUMBER(part, field, is_there, allowed, refused, what) int field = 0;
#define HS_CHOICE(part, field, Type, what, ...) Type field = Type(0);
#include "hls/formats/lists/config_list.hpp"
};

constexpr bool always(const Config&) { return true; }
constexpr bool has_depth(const Config& c) { return c.depth_bits != 0; }
// Whether the Z-test reads a stored depth, or the plane of the stored triangle; neither without depth.
constexpr bool stores_depth(const Config& c) { return has_depth(c) && c.architecture == Architecture::kDelta; }
constexpr bool tests_planes(const Config& c) { return c.architecture == Architecture::kGamma; }
constexpr bool is_gouraud(const Config& c) { return c.shading == Shading::kGouraud; }
constexpr bool is_flat(const Config& c) { return c.shading == Shading::kFlat; }
constexpr bool is_phong(const Config& c) { return c.shading == Shading::kPhong; }
// Whether a triangle has planes of what it is shaded with.
constexpr bool shades_planes(const Config& c) { return is_gouraud(c) || is_phong(c); }
constexpr bool has_lighting(const Config& c) { return c.lights != 0; }
constexpr bool has_gloss(const Config& c) { return c.gloss != 0; }
constexpr bool has_texture(const Config& c) { return c.texture != TextureFilter::kNone; }
constexpr bool is_bilinear(const Config& c) { return c.texture == TextureFilter::kBilinear; }
constexpr bool has_perspective(const Config& c) { return c.mapping == TextureMapping::kPerspective; }
// Whether frames are shaded at all; of shading = motion they are none but frames in between.
constexpr bool shades(const Config& c) { return c.shading != Shading::kMotion; }
// Whether shaded key frames take turns with frames in between.
constexpr bool up_converts(const Config& c) { return c.frames_between != 0; }
constexpr bool has_motion(const Config& c) { return !shades(c) || up_converts(c); }
constexpr bool relights(const Config& c) { return c.relight != 0; }
constexpr bool has_objects(const Config& c) { return c.object_bits != 0; }
constexpr bool culls(const Config& c) { return c.cull != Cull::kNone; }
constexpr bool culls_back(const Config& c) { return c.cull == Cull::kBack; }
constexpr bool culls_front(const Config& c) { return c.cull == Cull::kFront; }
// Whether triangles come without an index, and index_pool gives each its own.
constexpr bool gives_indices(const Config& c) { return c.index_window != 0; }
// N: a key frame's pixels are kept in N × N banks, by column and row modulo N, of which a filter reads each at once.
constexpr int key_side(KeyFilter filter) { return filter == KeyFilter::kBicubic ? 4 : 2; }
// Whether there are planes of coordinates: of a texture, or of places in key frames.
constexpr bool has_coordinates(const Config& c) { return has_texture(c) || has_motion(c); }
// Whether normals, texture coordinates or motion of a triangle come after it has turned out visible (deferred shading).
constexpr bool is_deferred(const Config& c) { return has_lighting(c) || has_coordinates(c); }
// Whether triangles come with colours.
constexpr bool has_colours(const Config& c) { return !has_lighting(c) && shades(c); }
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

// The parts of a configuration. A file has the fields of those that it has.
enum class Part { kBase, kLighting, kTexture, kCoordinates, kMotion, kObjects, kFilm, kCulling, kIndices };
constexpr bool has_part(Part part, const Config& c) {
  return part == Part::kLighting      ? has_lighting(c)
         : part == Part::kTexture     ? has_texture(c)
         : part == Part::kCoordinates ? has_coordinates(c)
         : part == Part::kMotion      ? has_motion(c)
         : part == Part::kObjects     ? has_objects(c)
         : part == Part::kFilm        ? up_converts(c)
         : part == Part::kCulling     ? culls(c)
         : part == Part::kIndices     ? gives_indices(c)
                                      : true;
}

// Bits that hold 0 … n.
constexpr int bits_for(std::int64_t n) { return n < 2 ? 1 : 1 + bits_for(n / 2); }
// log2 of a power of two.
constexpr int exact_log2(int n) { return n < 2 ? 0 : 1 + exact_log2(n / 2); }

constexpr int max_of(int a, int b) { return a > b ? a : b; }

// How much key 0 weighs in field `field` of an interval, 1 … frames_between, in multiples of 2^−weight_bits: what is
// left of the way to key 1, rounded half up. Key 1 has the rest.
constexpr int field_weight(const Config& c, int field) {
  const int ways = c.frames_between + 1;
  return ((ways - field) * (2 << c.weight_bits) + ways) / (2 * ways);
}

// log2 of the largest exponent of a highlight, and of the pixels in between a pixel of a key frame each way.
constexpr int squarings(const Config& c) { return exact_log2(c.gloss); }
constexpr int log2_samples(const Config& c) { return exact_log2(c.samples); }

}  // namespace halfspace

#endif  // HALFSPACE_HLS_FORMATS_CONFIG_HPP_
