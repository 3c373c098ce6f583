// SPDX-License-Identifier: Apache-2.0
// The tops, in the order of the pipeline. A configuration has those of its units; a source that it has no use for does
// not compile with it.
#ifndef HALFSPACE_HLS_TOP_TOPS_HPP_
#define HALFSPACE_HLS_TOP_TOPS_HPP_

#include "hls/motion/film_memories.hpp"
#include "hls/top/composed/frame_word.hpp"
#include "hls/top/composed/key_memory.hpp"
#include "hls/top/ports/ports.hpp"

namespace halfspace {

// The key frames of a film, all banks together.
struct TopFilmKeys {
  static constexpr int kSide = key_side(TopFormats::kFilter);
  static constexpr int kWords = kSide * kSide * FilmKeys<TopFormats, kSide>::kBankWords;
};
static_assert(complete_words<FaceEntry, HoleStamp, Motion, FoundPixel, KeyPixel>() > 0, "words of films");

}  // namespace halfspace

extern "C" {

// Indices for a frame of triangles. The results that it reads are those of `index_window` triangles before, also of
// frames before; what it knows of them stays from start to start. It is in no composed top.
void index_pool_top(halfspace::Port<halfspace::UnnumberedTriangle>& unnumbered,
                    halfspace::Port<halfspace::Visible>& returned, halfspace::Port<halfspace::Triangle>& numbered);

// A frame of triangles.
void triangle_setup_top(int width, int height, halfspace::Port<halfspace::Triangle>& triangle,
                        halfspace::Port<halfspace::Setup>& setup, halfspace::Port<halfspace::Attributes>& attributes);

// A frame of setups to stamps.
void raster_pineda_top(int width, int height, halfspace::Port<halfspace::Setup>& setup,
                       halfspace::Port<halfspace::Stamp>& stamp);

// The same for a Z-test that needs depth planes, of type γ.
void raster_pineda_plane_top(int width, int height, halfspace::Port<halfspace::Setup>& setup,
                             halfspace::Port<halfspace::Stamp>& stamp,
                             halfspace::Port<halfspace::TriangleDepth>& depth_plane);

// A frame of stamps into the I-buffer and the Z-buffer.
void ztest_index_top(
    halfspace::MemoryWord<halfspace::IndexStamp> index_buffer[halfspace::IndexBuffer<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::DepthStamp> depth_buffer[halfspace::DepthBuffer<halfspace::TopFormats>::kWords],
    halfspace::Port<halfspace::Stamp>& stamp, halfspace::Port<halfspace::Visible>& visible);

// A frame of stamps into the I-buffer and TdbV.
void ztest_plane_top(
    halfspace::MemoryWord<halfspace::IndexStamp> index_buffer[halfspace::IndexBuffer<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::DepthEntry> database[halfspace::VisibilityDatabase<halfspace::TopFormats>::kWords],
    halfspace::Port<halfspace::Stamp>& stamp, halfspace::Port<halfspace::TriangleDepth>& depth_plane,
    halfspace::Port<halfspace::Visible>& visible);

// The attributes of a frame, of which those of visible triangles go on.
void visible_select_top(halfspace::Port<halfspace::Attributes>& attributes, halfspace::Port<halfspace::Visible>& tested,
                        halfspace::Port<halfspace::Visible>& visible, halfspace::Port<halfspace::Attributes>& passed);

// A frame of attributes to planes of colour.
void shade_setup_top(halfspace::Port<halfspace::Attributes>& attributes, halfspace::Port<halfspace::Planes>& planes);

// The same of colours from light_vertex.
void shade_setup_lit_top(halfspace::Port<halfspace::Attributes>& attributes,
                         halfspace::Port<halfspace::Colours>& colours, halfspace::Port<halfspace::Planes>& planes);

// A triangle a start: normals come for visible triangles alone, so no word is known to be the last.
void light_vertex_top(
    halfspace::MemoryWord<halfspace::Light> lights[halfspace::LightTable<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::Material> materials[halfspace::MaterialTable<halfspace::TopFormats>::kWords],
    halfspace::Port<halfspace::Normals>& normals, halfspace::Port<halfspace::Colours>& colours);

// A frame of attributes and normals to planes of normals.
void phong_setup_top(halfspace::Port<halfspace::Attributes>& attributes, halfspace::Port<halfspace::Normals>& normals,
                     halfspace::Port<halfspace::NormalPlanes>& planes);

// A frame of attributes and coordinates to planes of coordinates.
void texture_setup_top(halfspace::Port<halfspace::Attributes>& attributes,
                       halfspace::Port<halfspace::TextureCoordinates>& coordinates,
                       halfspace::Port<halfspace::TexturePlanes>& planes);

// A frame of attributes and places to planes of places.
void motion_setup_top(halfspace::Port<halfspace::Attributes>& attributes,
                      halfspace::Port<halfspace::MotionVectors>& vectors,
                      halfspace::Port<halfspace::MotionPlanes>& planes);

// A frame from the I-buffer, which it clears.
void scan_index_top(
    int width, int height,
    halfspace::MemoryWord<halfspace::IndexStamp> index_buffer[halfspace::IndexBuffer<halfspace::TopFormats>::kWords],
    halfspace::Port<halfspace::Scan>& scan);

// A frame of stamps to colours.
void shade_gouraud_top(
    int red, int green, int blue,
    halfspace::MemoryWord<halfspace::Planes> database[halfspace::ShadingDatabase<halfspace::TopFormats>::kWords],
    halfspace::Port<halfspace::Scan>& scan, halfspace::Port<halfspace::Pixel>& pixel);

// A frame of stamps to colours, a pixel lit at a time.
void shade_phong_top(
    int red, int green, int blue,
    halfspace::MemoryWord<halfspace::NormalPlanes> database[halfspace::NormalDatabase<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::Light> lights[halfspace::LightTable<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::Material> materials[halfspace::MaterialTable<halfspace::TopFormats>::kWords],
    halfspace::Port<halfspace::Scan>& scan, halfspace::Port<halfspace::Pixel>& pixel);

// A frame of stamps and their colours to textured ones.
void shade_texture_top(
    halfspace::MemoryWord<halfspace::TexturePlanes> database[halfspace::TextureDatabase<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::TextureEntry> textures[halfspace::TextureTable<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::TexelColour> texels[halfspace::TextureMemory<halfspace::TopFormats>::kWords],
    halfspace::Port<halfspace::Scan>& scan, halfspace::Port<halfspace::Pixel>& lit,
    halfspace::Port<halfspace::Pixel>& pixel);

// A frame of stamps to depths and objects.
void scan_object_top(
    halfspace::MemoryWord<halfspace::DepthStamp> depth_buffer[halfspace::DepthBuffer<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::ObjectEntry> objects[halfspace::ObjectTable<halfspace::TopFormats>::kWords],
    halfspace::Port<halfspace::Scan>& scan, halfspace::Port<halfspace::ObjectPixel>& object_pixel);

// A frame of stamps to motion vectors.
void motion_field_top(
    halfspace::MemoryWord<halfspace::MotionPlanes> database[halfspace::MotionDatabase<halfspace::TopFormats>::kWords],
    halfspace::Port<halfspace::Scan>& scan, halfspace::Port<halfspace::Motion>& motion);

// A run: a word of `merge`, and stamps up to the last.
void ztest_merge_top(halfspace::Port<halfspace::Merge>& merge, halfspace::Port<halfspace::Entry>& stored,
                     halfspace::Port<halfspace::Entry>& entry, halfspace::Port<halfspace::Entry>& merged,
                     halfspace::Port<halfspace::Found>& found);

// A frame of motion vectors to colours, along them from the key frames, whose tiles it asks for.
void motion_compensate_top(int width, int height, int weight, halfspace::Port<halfspace::Motion>& motion,
                           halfspace::Port<halfspace::KeyRequest>& key_request_0,
                           halfspace::Port<halfspace::TopKeyBlock>& key_block_0,
                           halfspace::Port<halfspace::KeyRequest>& key_request_1,
                           halfspace::Port<halfspace::TopKeyBlock>& key_block_1,
                           halfspace::Port<halfspace::Compensated>& compensated);

// Of a film: a frame of stamps and their colours to pixels and their faces.
void pixel_store_top(
    int width, int height,
    halfspace::MemoryWord<halfspace::FaceEntry> faces[halfspace::FaceTable<halfspace::TopFormats>::kWords],
    halfspace::Port<halfspace::Scan>& scan, halfspace::Port<halfspace::Pixel>& pixel,
    halfspace::Port<halfspace::ShownPixel>& shown);

// A frame of motion vectors into the order of tiles; the buffer is empty before it, and after it.
void motion_order_top(int width, int height,
                      halfspace::MemoryWord<halfspace::Motion> buffer[halfspace::frame_words<halfspace::TopFormats>()],
                      halfspace::Port<halfspace::Motion>& motion, halfspace::Port<halfspace::Motion>& ordered);

// A frame of what key frames gave into the film buffer; holes are marked, and their faces asked for.
void hole_find_top(
    halfspace::MemoryWord<halfspace::FoundPixel> film[halfspace::frame_words<halfspace::TopFormats>()],
    halfspace::MemoryWord<halfspace::HoleStamp> holes[halfspace::HoleMarks<halfspace::TopFormats>::kWords],
    halfspace::Port<halfspace::Motion>& ordered, halfspace::Port<halfspace::Compensated>& compensated,
    halfspace::Port<halfspace::Asked>& asked);

// A frame of stamps, of which holes alone go on if `fills` is not 0; their marks are cleared.
void hole_scan_top(
    int fills, halfspace::MemoryWord<halfspace::HoleStamp> holes[halfspace::HoleMarks<halfspace::TopFormats>::kWords],
    halfspace::Port<halfspace::Scan>& scan, halfspace::Port<halfspace::Scan>& masked);

// A frame of the film: the key frame in `slot`, or what is found in between, which is cleared.
void film_scan_top(int width, int height, int red, int green, int blue, int of_key, int slot,
                   halfspace::MemoryWord<halfspace::KeyPixel> keys[halfspace::TopFilmKeys::kWords],
                   halfspace::MemoryWord<halfspace::FoundPixel> film[halfspace::frame_words<halfspace::TopFormats>()],
                   halfspace::Port<halfspace::FilmPixel>& shown);

// Composed, of processes that a word of `frame` starts. Triangles in, what is visible out; the I-buffer, the Z-buffer
// and TdbS are written, and once they are, the word comes out of `drawn`: it can start back_top.
void front_top(
    halfspace::MemoryWord<halfspace::IndexStamp> index_buffer[halfspace::IndexBuffer<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::DepthStamp> depth_buffer[halfspace::DepthBuffer<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::Planes> database[halfspace::ShadingDatabase<halfspace::TopFormats>::kWords],
    halfspace::Port<halfspace::FrameWord>& frame, halfspace::Port<halfspace::Triangle>& triangle,
    halfspace::Port<halfspace::Visible>& visible, halfspace::Port<halfspace::FrameWord>& drawn);

// From these memories to colours; the I-buffer is cleared.
void back_top(
    halfspace::MemoryWord<halfspace::IndexStamp> index_buffer[halfspace::IndexBuffer<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::Planes> database[halfspace::ShadingDatabase<halfspace::TopFormats>::kWords],
    halfspace::Port<halfspace::FrameWord>& frame, halfspace::Port<halfspace::Pixel>& pixel);

// Both, with the memories inside.
void pipeline_top(halfspace::Port<halfspace::FrameWord>& frame, halfspace::Port<halfspace::Triangle>& triangle,
                  halfspace::Port<halfspace::Visible>& visible, halfspace::Port<halfspace::Pixel>& pixel);

// front_top with vertices that are lit, deferred: normals come for triangles that `visible` says.
void front_lit_top(
    halfspace::MemoryWord<halfspace::IndexStamp> index_buffer[halfspace::IndexBuffer<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::DepthStamp> depth_buffer[halfspace::DepthBuffer<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::Planes> database[halfspace::ShadingDatabase<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::Light> lights[halfspace::LightTable<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::Material> materials[halfspace::MaterialTable<halfspace::TopFormats>::kWords],
    halfspace::Port<halfspace::FrameWord>& frame, halfspace::Port<halfspace::Triangle>& triangle,
    halfspace::Port<halfspace::Normals>& normals, halfspace::Port<halfspace::Visible>& visible,
    halfspace::Port<halfspace::FrameWord>& drawn);

// The same up to planes of normals.
void front_phong_top(
    halfspace::MemoryWord<halfspace::IndexStamp> index_buffer[halfspace::IndexBuffer<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::DepthStamp> depth_buffer[halfspace::DepthBuffer<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::NormalPlanes>
        normals_database[halfspace::NormalDatabase<halfspace::TopFormats>::kWords],
    halfspace::Port<halfspace::FrameWord>& frame, halfspace::Port<halfspace::Triangle>& triangle,
    halfspace::Port<halfspace::Normals>& normals, halfspace::Port<halfspace::Visible>& visible,
    halfspace::Port<halfspace::FrameWord>& drawn);

// With texture coordinates beside the colours.
void front_textured_top(
    halfspace::MemoryWord<halfspace::IndexStamp> index_buffer[halfspace::IndexBuffer<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::DepthStamp> depth_buffer[halfspace::DepthBuffer<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::Planes> database[halfspace::ShadingDatabase<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::TexturePlanes>
        texture_database[halfspace::TextureDatabase<halfspace::TopFormats>::kWords],
    halfspace::Port<halfspace::FrameWord>& frame, halfspace::Port<halfspace::Triangle>& triangle,
    halfspace::Port<halfspace::TextureCoordinates>& coordinates, halfspace::Port<halfspace::Visible>& visible,
    halfspace::Port<halfspace::FrameWord>& drawn);

// With motion in the place of colours.
void front_motion_top(
    halfspace::MemoryWord<halfspace::IndexStamp> index_buffer[halfspace::IndexBuffer<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::DepthStamp> depth_buffer[halfspace::DepthBuffer<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::MotionPlanes>
        motion_database[halfspace::MotionDatabase<halfspace::TopFormats>::kWords],
    halfspace::Port<halfspace::FrameWord>& frame, halfspace::Port<halfspace::Triangle>& triangle,
    halfspace::Port<halfspace::MotionVectors>& vectors, halfspace::Port<halfspace::Visible>& visible,
    halfspace::Port<halfspace::FrameWord>& drawn);

// back_top of each.
void back_phong_top(
    halfspace::MemoryWord<halfspace::IndexStamp> index_buffer[halfspace::IndexBuffer<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::NormalPlanes>
        normals_database[halfspace::NormalDatabase<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::Light> lights[halfspace::LightTable<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::Material> materials[halfspace::MaterialTable<halfspace::TopFormats>::kWords],
    halfspace::Port<halfspace::FrameWord>& frame, halfspace::Port<halfspace::Pixel>& pixel);
void back_textured_top(
    halfspace::MemoryWord<halfspace::IndexStamp> index_buffer[halfspace::IndexBuffer<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::Planes> database[halfspace::ShadingDatabase<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::TexturePlanes>
        texture_database[halfspace::TextureDatabase<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::TextureEntry> textures[halfspace::TextureTable<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::TexelColour> texels[halfspace::TextureMemory<halfspace::TopFormats>::kWords],
    halfspace::Port<halfspace::FrameWord>& frame, halfspace::Port<halfspace::Pixel>& pixel);
void back_motion_top(
    halfspace::MemoryWord<halfspace::IndexStamp> index_buffer[halfspace::IndexBuffer<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::MotionPlanes>
        motion_database[halfspace::MotionDatabase<halfspace::TopFormats>::kWords],
    halfspace::Port<halfspace::FrameWord>& frame, halfspace::Port<halfspace::Motion>& motion);

// The motion field and along it the colours, from key frames in memories.
void back_compensate_top(
    halfspace::MemoryWord<halfspace::IndexStamp> index_buffer[halfspace::IndexBuffer<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::MotionPlanes>
        motion_database[halfspace::MotionDatabase<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::TopKeyBlock> key_frame_0[halfspace::KeyMemory<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::TopKeyBlock> key_frame_1[halfspace::KeyMemory<halfspace::TopFormats>::kWords],
    halfspace::Port<halfspace::FrameWord>& frame, halfspace::Port<halfspace::KeyWeightWord>& key_weight,
    halfspace::Port<halfspace::Compensated>& compensated);

// With the depth and the object of each pixel, for ztest_merge_top.
void back_objects_top(
    halfspace::MemoryWord<halfspace::IndexStamp> index_buffer[halfspace::IndexBuffer<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::DepthStamp> depth_buffer[halfspace::DepthBuffer<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::Planes> database[halfspace::ShadingDatabase<halfspace::TopFormats>::kWords],
    halfspace::MemoryWord<halfspace::ObjectEntry> objects[halfspace::ObjectTable<halfspace::TopFormats>::kWords],
    halfspace::Port<halfspace::FrameWord>& frame, halfspace::Port<halfspace::Entry>& entry);

// A command: what it reads of the buffers through ztest_merge into a buffer or the frame.
void static_frames_top(halfspace::Port<halfspace::StaticCommand>& command, halfspace::Port<halfspace::Entry>& entry,
                       halfspace::Port<halfspace::BufferPlace>& stored_place,
                       halfspace::Port<halfspace::StampPixels>& stored_pixels,
                       halfspace::Port<halfspace::BufferPlace>& drawn_place,
                       halfspace::Port<halfspace::StampPixels>& drawn_pixels,
                       halfspace::Port<halfspace::KeptStamp>& kept, halfspace::Port<halfspace::Entry>& shown,
                       halfspace::Port<halfspace::Found>& found);

}  // extern "C"

#endif  // HALFSPACE_HLS_TOP_TOPS_HPP_
