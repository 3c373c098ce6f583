// SPDX-License-Identifier: Apache-2.0
// Every number that the units have, each said once. Whoever wants something of each defines
//
//   HS_FORMAT(part, member, Type, is_used, why)
//   HS_CHANNEL(part, vertex, Vertex, channel, Channel, is_used, bits, fraction)
//
// and includes this file, which undefines both. From it come the members of FormatTable, the types of Formats and of
// its view at run time, the rows of `halfspace config` and the types of the SystemVerilog package. The widths
// themselves are derived in setup_formats.hpp, lighting_formats.hpp, texture_formats.hpp and motion_formats.hpp.
//
// member: of FormatTable, a file's name of it. Type: the kernels'. is_used(c): whether units of c have such a number;
// else the width is idle. why: of the width; c: bits of a position, f: sub-pixel bits, b: bits of the channel, g:
// fraction bits of its gradients.
//
// A channel is what plane_setup takes: values at three vertices, without a sign, become a plane. `vertex` is the format
// of these values, which has a row of its own; five others follow from its bits and the fraction bits of its gradients,
// both expressions of c.
#ifndef HS_FORMAT
#define HS_FORMAT(part, member, Type, is_used, why)
#endif
#ifndef HS_CHANNEL
#define HS_CHANNEL(part, vertex, Vertex, channel, Channel, is_used, bits, fraction)                             \
  HS_FORMAT(part, channel##_plane, Channel##Plane, is_used, "b + g: modulo 2^b, as the error is below ½")       \
  HS_FORMAT(part, channel##_gradient, Channel##Gradient, is_used, "b + g: steps of whole pixels, modulo 2^b")   \
  HS_FORMAT(part, channel##_numerator, Channel##Numerator, is_used, "b + c + 1: |dv1·dy2 − dv2·dy1| < 2^(b+c)") \
  HS_FORMAT(part, channel##_start, Channel##Start, is_used,                                                     \
            "b + g + f: products of g and f fraction bits, modulo 2^b")                                         \
  HS_FORMAT(part, channel##_start_gradient, Channel##StartGradient, is_used,                                    \
            "b + f + g: times a multiple of 2^−f, modulo 2^b")
#endif

HS_FORMAT(kBase, x, X, always, "frame widths and columns, 0 … width")
HS_FORMAT(kBase, y, Y, always, "frame heights and rows, 0 … height")
HS_FORMAT(kBase, index, Index, always, "0 is the background, 1 … triangles")
HS_FORMAT(kBase, coord, Coord, always, "c = range_bits + f")
HS_FORMAT(kBase, delta, Delta, always, "c + 1: a difference of positions")
HS_FORMAT(kBase, area, Area, always, "2c: twice the area of a triangle in a square is its area at most")
HS_FORMAT(kBase, signed_area, SignedArea, always, "2c + 1: before the winding is known")
HS_FORMAT(kBase, edge, Edge, always, "2c + 1: twice the area of (vertex, vertex, pixel centre), less one")
HS_FORMAT(kBase, edge_step, EdgeStep, always, "2c + 1 − f: the low f bits never change")
HS_FORMAT(kBase, reciprocal, Reciprocal, has_planes, "r + 1: 2^(r−1) <= R <= 2^r")
HS_FORMAT(kBase, shift, Shift, has_planes, "floor(log2 D), 0 … 2c − 1")
HS_FORMAT(kBase, depth, Depth, has_depth, "b of depth")
HS_CHANNEL(kBase, depth, Depth, depth, Depth, has_depth, depth_channel_bits(c), c.depth_fraction)
HS_FORMAT(kBase, colour, Colour, always, "b of a channel")
// Flat: the colour itself, though a relit film has fraction bits for its differences.
HS_CHANNEL(kBase, colour, Colour, colour, Colour, is_gouraud, c.colour_bits, is_flat(c) ? 0 : c.colour_fraction)

HS_FORMAT(kLighting, material, MaterialNumber, has_lighting, "0 … materials − 1")
HS_FORMAT(kLighting, light, LightNumber, has_lighting, "0 … lights − 1")
HS_FORMAT(kLighting, gloss, Gloss, has_gloss, "k, squarings: 0 … log2(gloss)")
HS_FORMAT(kLighting, normal, Normal, has_lighting, "p + 1: of any length, so that no component is 1")
HS_FORMAT(kLighting, direction, Direction, has_lighting, "u + 2, u = b + 8: of a unit vector")
HS_FORMAT(kLighting, squared_length, SquaredLength, has_lighting, "2p + 2: at most 3·2^2p units")
HS_FORMAT(kLighting, root, Root, has_lighting, "y of reciprocal_sqrt, ½ … 1")
HS_FORMAT(kLighting, root_shift, RootShift, has_lighting, "k of reciprocal_sqrt, 0 … p")
HS_FORMAT(kLighting, dot, Dot, has_lighting, "p + u + 4: at most 3·2^(p+u+1) units")
HS_FORMAT(kLighting, projection, Projection, has_lighting, "u + 1: n·L of 1 <= |n| < 2, above 0")
HS_FORMAT(kLighting, cosine, Cosine, has_lighting, "u + 1: 0 … 1; an exponent of 16 leaves 2^−4 LSB of its last place")
HS_FORMAT(kLighting, coefficient, Coefficient, has_lighting, "b + 2 + 6: four times full scale, 1/128 LSB of rounding")
HS_FORMAT(kLighting, light_sum, LightSum, has_lighting, "base, diffuse, specular of each light, times 1 at most")
HS_FORMAT(kLighting, normal_offset, NormalOffset, is_phong, "b = p + 1: a component plus 2^p units has no sign")
HS_CHANNEL(kLighting, normal_offset, NormalOffset, normal, Normal, is_phong, normal_channel_bits(c), c.normal_fraction)

HS_FORMAT(kTexture, texture, TextureNumber, has_texture, "0: none, 1 … textures")
HS_FORMAT(kTexture, repeats, Repeats, has_texture, "e: a triangle spans 2^15 repetitions at most")
HS_FORMAT(kTexture, side, Side, has_texture, "log2 of a side, 0 … log2(texels), bilinear one less")
HS_FORMAT(kTexture, texel_address, TexelAddress, has_texture, "0 … texels − 1")
HS_FORMAT(kCoordinates, coordinate, Coordinate, has_coordinates, "b of s, t, q")
HS_CHANNEL(kCoordinates, coordinate, Coordinate, coordinate, Coordinate, has_coordinates, coordinate_channel_bits(c),
           c.coordinate_fraction)
HS_FORMAT(kCoordinates, inverse, Inverse, has_perspective, "y of reciprocal_lookup, ½ … 1")
HS_FORMAT(kCoordinates, inverse_shift, InverseShift, has_perspective, "k of reciprocal_lookup, 0 … b − 1")
HS_FORMAT(kTexture, texel_place, TexelPlace, has_texture,
          "of the longest side + 8: modulo a side, and the weights of a bilinear filter")
HS_FORMAT(kTexture, filtered, Filtered, has_texture, "b of colour + 8: a texel, rounded once")

HS_FORMAT(kMotion, face, Face, has_motion, "0: background, 1 … 2^face_bits − 1")
HS_FORMAT(kMotion, origin, Origin, has_motion, "whole pixels of a position")
HS_FORMAT(kMotion, extent, Extent, has_motion, "e: places of a triangle lie within 2^e pixels of its origin")
HS_FORMAT(kMotion, vector, Vector, has_motion, "vector_range + 1 + vector_fraction")
HS_FORMAT(kMotion, key_weight, KeyWeight, has_motion, "0 … 1")
HS_FORMAT(kMotion, tile_x, TileX, has_motion, "a column of tiles of a key frame")
HS_FORMAT(kMotion, tile_y, TileY, has_motion, "a row of tiles of a key frame")
HS_FORMAT(kMotion, key_place, KeyPlace, has_motion, "side + 2^vector_range, in pixels of a key frame")
HS_FORMAT(kMotion, tap_weight, TapWeight, has_motion, "−½ … 1: of a column or a row")
HS_FORMAT(kMotion, key_sum, KeySum, has_motion, "weights·colours of a key, and a difference: exact")
HS_FORMAT(kMotion, key_blend, KeyBlend, has_motion, "of both keys: exact")
HS_FORMAT(kMotion, difference, Difference, relights, "b of colour + 1: a difference plus 2^b has no sign")
HS_CHANNEL(kMotion, difference, Difference, difference, Difference, relights, difference_bits(c), c.colour_fraction)

HS_FORMAT(kObjects, object, Object, has_objects, "0: background, 1 … 2^object_bits − 1")
HS_FORMAT(kObjects, object_count, ObjectCount, has_objects, "pixels of a frame")

HS_FORMAT(kIndices, flight, Flight, gives_indices, "0 … index_window: triangles whose results are not known")

#undef HS_FORMAT
#undef HS_CHANNEL
