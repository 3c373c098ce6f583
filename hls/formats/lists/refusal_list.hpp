// SPDX-License-Identifier: Apache-2.0
// Why a configuration is refused, in the order of Refusal. Whoever wants something of each defines HS_LIMIT and
// HS_REFUSAL and includes this file, which undefines both.
//
// HS_LIMIT: fields outside the limits that config_list.hpp gives them; the sentence has these, and then `more`.
// HS_REFUSAL: with its sentence, which says the remedy.
#ifndef HS_LIMIT
#define HS_LIMIT(name, more)
#endif
#ifndef HS_REFUSAL
#define HS_REFUSAL(name, sentence)
#endif

HS_LIMIT(kFrameSize, " pixels")
HS_LIMIT(kTriangles, "")
HS_LIMIT(kSubpixelBits, "")  // without one, a pixel centre is no position
HS_LIMIT(kDepthBits, ", or 0 for no depth")
HS_LIMIT(kColourBits, "")
HS_LIMIT(kLanes, "")
HS_LIMIT(kFractionBits, "")
HS_LIMIT(kNormalBits, "")  // the square of a length fills the fields of a reciprocal root; all products are one word
HS_LIMIT(kLights, ", or 0 for no lighting")  // a normal takes a cycle a light
HS_LIMIT(kGloss, ", or 0 for no highlights")
HS_LIMIT(kMaterials, "")
HS_LIMIT(kCoordinateBits, "")  // the weights of texels take 8; a factor of a multiplier of 25 bits
HS_LIMIT(kTexels, "")          // the place of a texel, shifted for its texture, is one word
HS_LIMIT(kTextures, "")
HS_LIMIT(kVector, "")
HS_LIMIT(kWeightBits, "")
HS_LIMIT(kFaceBits, "")
HS_LIMIT(kRelight, "")
HS_LIMIT(kSamples, "")
HS_LIMIT(kObjectBits, ", or 0 for no objects")
HS_LIMIT(kFramesBetween, ", or 0 for none")
HS_LIMIT(kIndexWindow, ", or 0 where geometry gives the indices")  // a queue of as many results

// A number of what is not there.
HS_REFUSAL(
    kIdleBits,
    "numbers of what is not there are 0: depth_fraction where depth_bits is 0, colour_fraction where shading is "
    "not \"gouraud\" and nothing is relit, reciprocal_bits where there is no depth and no texture and shading is "
    "\"flat\"")
HS_REFUSAL(
    kIdleLighting,
    "normal_bits, gloss and materials are 0 where lights is 0, and normal_fraction where shading is not \"phong\"")
HS_REFUSAL(kIdleTexture,
           "texels and textures are 0 where texture is \"none\"; so are coordinate_bits and coordinate_fraction, and "
           "mapping is \"affine\", where shading is not \"motion\" and frames_between is 0")
HS_REFUSAL(kIdleMotion,
           "filter is \"none\", and vector_range, vector_fraction, weight_bits, face_bits, relight and samples are 0, "
           "where shading is not \"motion\" and frames_between is 0")

// Choices that contradict one another.
HS_REFUSAL(kUnlitPhong,
           "shading \"phong\" lights the pixels, and there are no lights: raise lights, or shade otherwise")
HS_REFUSAL(kIdleArchitecture,
           "architecture \"gamma\" computes a depth again, and there is none: raise depth_bits, or leave the "
           "architecture out")
HS_REFUSAL(kMotionShading,
           "shading \"motion\" takes no lights and no texture: frames in between have the colours of the key frames")
HS_REFUSAL(kFilter, "frames in between take a filter: \"nearest\", \"bilinear\", \"area\" or \"bicubic\"")
HS_REFUSAL(kFilmShading,
           "frames_between is the frames between two that are shaded, and shading \"motion\" shades none: take another "
           "shading, or leave frames_between out")
HS_REFUSAL(kFilmSamples,
           "samples is 1 where frames_between is not 0: key frames of more samples would have to be averaged, and no "
           "unit does that")
HS_REFUSAL(kFilmIndices,
           "index_window is 0 where frames_between is not: what is filled is asked for by the indices that "
           "geometry gave")
HS_REFUSAL(kObjectsNeedDepth,
           "object_bits is 0 without a Z-buffer, with architecture \"gamma\", with shading \"motion\" and where "
           "frames_between is not 0: a merge compares the depths of a Z-buffer")

HS_REFUSAL(kFrameOutsideRange,
           "the frame and 12 pixels around it do not lie within the range of positions: raise range_bits (20 at most) "
           "or make the frame smaller")

// A plane whose rounded values could leave those of the vertices, and wrap.
HS_REFUSAL(kDepthError, "the depth planes can be off by half an LSB or more: raise reciprocal_bits or depth_fraction")
HS_REFUSAL(kColourError,
           "the colour planes can be off by half an LSB or more: raise reciprocal_bits or colour_fraction")
HS_REFUSAL(kNormalError,
           "the planes of normals can be off by half a unit of 2^-normal_bits or more: raise reciprocal_bits or "
           "normal_fraction")
HS_REFUSAL(kCoordinateError,
           "the planes of texture coordinates can be off by half a unit or more: raise reciprocal_bits or "
           "coordinate_fraction, or lower coordinate_bits")
HS_REFUSAL(kReciprocalShort,
           "a gradient would keep more fraction bits than its reciprocal has: reciprocal_bits is subpixel_bits + the "
           "largest of depth_fraction, colour_fraction, normal_fraction and coordinate_fraction, or more")

// More than a machine word. An edge function, with the carry of its subtraction.
HS_REFUSAL(kEdgeWord, "an edge function is wider than 64 bits: lower range_bits or subpixel_bits")
HS_REFUSAL(kNumeratorWord,
           "the numerator of a gradient is wider than 64 bits: lower depth_bits, coordinate_bits, range_bits or "
           "subpixel_bits")
// The halves of the product with the reciprocal, and the half that rounds it.
HS_REFUSAL(kGradientWord,
           "half the product with the reciprocal is wider than 64 bits: lower reciprocal_bits, depth_bits, "
           "coordinate_bits or range_bits")
HS_REFUSAL(kStartWord,
           "the start of a plane is wider than 63 bits: lower depth_fraction, colour_fraction, normal_fraction, "
           "coordinate_fraction or subpixel_bits")
HS_REFUSAL(kShadeWord,
           "a gradient of colour, normals or texture coordinates times a coordinate is wider than 64 bits: lower its "
           "fraction")
HS_REFUSAL(kTestWord,
           "a depth gradient times a coordinate, which architecture \"gamma\" needs, is wider than 64 bits: lower "
           "depth_fraction")

#undef HS_LIMIT
#undef HS_REFUSAL
