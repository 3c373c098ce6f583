// SPDX-License-Identifier: Apache-2.0
// What kernels ask of their configuration, each said once: a constant k<Name> of Formats and of its view at run time.
// Whoever wants something of each defines
//
//   HS_FLAG(Type, Name, function)  // function(c)
//   HS_CONSTANT(Name, field)       // c.field
//   HS_COMPILES(Unit, Name)        // a type Compiles<Unit>: whether kernels for which k<Name> is false are left out
//
// and includes this file, which undefines all three. Flags are constants of the SystemVerilog package too.
#ifndef HS_FLAG
#define HS_FLAG(Type, Name, function)
#endif
#ifndef HS_CONSTANT
#define HS_CONSTANT(Name, field)
#endif
#ifndef HS_COMPILES
#define HS_COMPILES(Unit, Name)
#endif

HS_FLAG(bool, HasDepth, has_depth)
HS_FLAG(bool, StoresDepth, stores_depth)
HS_FLAG(bool, TestsPlanes, tests_planes)
HS_FLAG(bool, Gouraud, is_gouraud)
HS_FLAG(bool, Phong, is_phong)
HS_FLAG(bool, ShadesPlanes, shades_planes)
HS_FLAG(bool, HasPlanes, has_planes)
HS_FLAG(bool, HasColours, has_colours)
HS_FLAG(bool, HasLighting, has_lighting)
HS_FLAG(bool, HasGloss, has_gloss)
HS_FLAG(bool, HasTexture, has_texture)
HS_FLAG(bool, Bilinear, is_bilinear)
HS_FLAG(bool, Perspective, has_perspective)
HS_FLAG(bool, Shades, shades)
HS_FLAG(bool, UpConverts, up_converts)
HS_FLAG(bool, HasMotion, has_motion)
HS_FLAG(bool, Relights, relights)
HS_FLAG(bool, HasObjects, has_objects)
HS_FLAG(bool, CullsBack, culls_back)
HS_FLAG(bool, CullsFront, culls_front)
HS_FLAG(bool, GivesIndices, gives_indices)
HS_FLAG(bool, Deferred, is_deferred)
HS_FLAG(bool, SendsShape, sends_shape)
HS_FLAG(bool, OrdersVertices, orders_vertices)
HS_FLAG(int, Squarings, squarings)
HS_FLAG(int, Log2Samples, log2_samples)

HS_CONSTANT(Width, width)
HS_CONSTANT(Height, height)
HS_CONSTANT(Triangles, triangles)
HS_CONSTANT(SubpixelBits, subpixel_bits)
HS_CONSTANT(DepthBits, depth_bits)
HS_CONSTANT(ColourBits, colour_bits)
HS_CONSTANT(ReciprocalFraction, reciprocal_bits)
HS_CONSTANT(Lights, lights)
HS_CONSTANT(Materials, materials)
HS_CONSTANT(Texels, texels)
HS_CONSTANT(Textures, textures)
HS_CONSTANT(Filter, filter)
HS_CONSTANT(VectorRange, vector_range)
HS_CONSTANT(VectorFraction, vector_fraction)
HS_CONSTANT(WeightBits, weight_bits)
HS_CONSTANT(FramesBetween, frames_between)
HS_CONSTANT(IndexWindow, index_window)

// A view at run time compiles all. refusal() holds the words of the products of ztest_plane for type γ alone.
HS_COMPILES(PlaneTest, TestsPlanes)
HS_COMPILES(Phong, Phong)
HS_COMPILES(Lighting, HasLighting)
HS_COMPILES(Texture, HasTexture)
HS_COMPILES(Motion, HasMotion)
HS_COMPILES(Shading, Shades)

#undef HS_FLAG
#undef HS_CONSTANT
#undef HS_COMPILES
