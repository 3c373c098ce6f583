// SPDX-License-Identifier: Apache-2.0
// The fields of a configuration, in the order of Config, each said once. Whoever wants something of each defines
//
//   HS_NUMBER(part, field, is_there, allowed, refused, what)
//   HS_CHOICE(part, field, Type, what, "word", …)
//
// and includes this file, which undefines both.
//
// part: the files that have the field (has_part). is_there(c): whether c has such a number; else it is 0. allowed: the
// Limits of a number that is there, and refused: the Refusal of one outside. what: the text beside it in a file, a
// table. A choice is an enumeration with a word a value, the first of which is the default and that of a file without
// the field.
#ifndef HS_NUMBER
#define HS_NUMBER(part, field, is_there, allowed, refused, what)
#endif
#ifndef HS_CHOICE
#define HS_CHOICE(part, field, Type, what, ...)
#endif

HS_NUMBER(kBase, width, always, range(1, 8192), kFrameSize, "largest frame, pixels")
HS_NUMBER(kBase, height, always, range(1, 8192), kFrameSize, "")
HS_NUMBER(kBase, triangles, always, range(2, 1 << 22), kTriangles, "a frame")
HS_NUMBER(kBase, range_bits, always, range(1, 20), kFrameOutsideRange,
          "vertices lie within ±2^(range_bits−1) pixels: the guard band")
HS_NUMBER(kBase, subpixel_bits, always, range(1, 12), kSubpixelBits, "f: fraction bits of a vertex position")
HS_NUMBER(kBase, depth_bits, always, or_none(range(2, 32)), kDepthBits,
          "of a depth that is compared; 0: no depth, the first drawn wins each pixel")
HS_NUMBER(kBase, colour_bits, always, range(1, 8), kColourBits, "of a channel")
HS_NUMBER(kBase, reciprocal_bits, has_planes, range(2, 40), kFractionBits,
          "r: fraction bits of the reciprocal of the area; 0 without depth and flat")
HS_NUMBER(kBase, depth_fraction, has_depth, range(1, 40), kFractionBits,
          "g: fraction bits of the gradients of depth; 0 without depth")
HS_NUMBER(kBase, colour_fraction, has_colour_planes, range(1, 40), kFractionBits,
          "g: fraction bits of the gradients of colour; 0 if flat")
HS_NUMBER(kBase, lanes, always, power(1, 16), kLanes, "pixels a cycle, where the command line says nothing")
HS_CHOICE(kBase, shading, Shading,
          "\"gouraud\", \"flat\": a triangle has the colour of its first vertex, \"phong\": each visible pixel is lit, "
          "or \"motion\": a frame between two key frames",
          "gouraud", "flat", "phong", "motion")
HS_CHOICE(kBase, architecture, Architecture,
          "\"delta\": a Z-buffer, or \"gamma\": none, depth is computed again from TdbV", "delta", "gamma")

HS_NUMBER(kLighting, normal_bits, has_lighting, range(9, 16), kNormalBits,
          "p: fraction bits of a component of a normal")
HS_NUMBER(kLighting, lights, always, or_none(range(1, 4)), kLights, "that are built, 1 to 4")
HS_NUMBER(kLighting, gloss, has_lighting, or_none(power(1, 16)), kGloss,
          "largest exponent of a highlight: 1, 2, 4, 8, 16; 0: no highlights")
HS_NUMBER(kLighting, materials, has_lighting, range(1, 4096), kMaterials, "a frame")
HS_NUMBER(kLighting, normal_fraction, is_phong, range(1, 40), kFractionBits,
          "g: fraction bits of the gradients of normals; 0 but for \"phong\"")

HS_CHOICE(kTexture, texture, TextureFilter,
          "\"none\", \"nearest\": the texel at a pixel's centre, or \"bilinear\": four of them, weighted",  //
          "none", "nearest", "bilinear")
HS_CHOICE(kCoordinates, mapping, TextureMapping,
          "\"affine\": planes of u and v, or \"perspective\": planes of u/w, v/w, 1/w and a division a pixel",  //
          "affine", "perspective")
HS_NUMBER(kTexture, texels, has_texture, power(4, 1 << 20), kTexels, "of the texture memory, a power of two")
HS_NUMBER(kTexture, textures, has_texture, range(1, 256), kTextures, "a frame")
HS_NUMBER(kCoordinates, coordinate_bits, has_coordinates, range(10, 24), kCoordinateBits,
          "b: of a texture coordinate, or of a place in a key frame")
HS_NUMBER(kCoordinates, coordinate_fraction, has_coordinates, range(1, 40), kFractionBits,
          "g: fraction bits of the gradients of texture coordinates, or of places")

HS_CHOICE(kMotion, filter, KeyFilter,
          "of key frames: \"nearest\", \"bilinear\", \"area\": weighted by area and distance, or \"bicubic\"", "none",
          "nearest", "bilinear", "area", "bicubic")
HS_NUMBER(kMotion, vector_range, has_motion, range(1, 13), kVector,
          "components of a vector lie in [−2^vector_range, 2^vector_range) pixels")
HS_NUMBER(kMotion, vector_fraction, has_motion, range(1, 8), kVector, "and are multiples of 2^−vector_fraction")
HS_NUMBER(kMotion, weight_bits, has_motion, range(2, 8), kWeightBits,
          "weights of key frames and of their pixels are multiples of 2^−weight_bits")
HS_NUMBER(kMotion, face_bits, has_motion, range(1, 22), kFaceBits, "of the number of a face, 1 … 2^face_bits − 1")
HS_NUMBER(kMotion, relight, has_motion, range(0, 1), kRelight, "1: planes of what a colour differs by from a key's")
HS_NUMBER(kMotion, samples, has_motion, power(1, 4), kSamples,
          "pixels in between a pixel of a key frame, each way: 1, 2, 4")

HS_NUMBER(kObjects, object_bits, always, or_none(range(1, 22)), kObjectBits,
          "of the number of an object in a pixel, for static objects buffers; 0: none")

HS_NUMBER(kFilm, frames_between, always, or_none(range(1, 9)), kFramesBetween,
          "frames that are made between two key frames, which are shaded; 0: none")

HS_CHOICE(kCulling, cull, Cull,
          "triangles that the setup drops: \"none\", \"back\": those seen from behind, or \"front\"",  //
          "none", "back", "front")

HS_NUMBER(
    kIndices, index_window, always, or_none(range(1, 4096)), kIndexWindow,
    "W: index_pool gives triangles their indices, and those of invisible ones again W triangles later; 0: geometry "
    "does")

#undef HS_NUMBER
#undef HS_CHOICE
