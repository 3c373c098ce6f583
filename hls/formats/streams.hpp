// SPDX-License-Identifier: Apache-2.0
// The table of streams: each is said here, in flow order, and nowhere else. From it come the streams of the pipeline
// (hls/pipeline/pipeline_streams.hpp), what is tapped, the manifests of the vectors, the reports, and the table of
// docs/architecture.md, which `halfspace streams --markdown` prints.
//
//   X(member, name, kind, from, to, place, there, when, what, record)
//
//   member   in the struct of streams
//   name     in vectors, in reports and in the RTL
//   kind     Stream   a queue between two units
//            Stored   a queue into a memory that always takes: without ready in the RTL
//            Loaded   words that are in a memory, or a register, before the frame
//            Fetch    between a unit and a memory outside, which natively it reaches by itself
//            Probe    a place to watch from, not a queue
//   from, to units; else what is outside: geometry, host, driver, frame, a memory
//   place    the stream whose word of the same number says where in the frame the word is; "": none
//   there    whether a configuration has it, as an expression on its formats F
//   when     the same for people; "": always
//   what     a word of it is
//   record   its type, last as it may have a comma
#ifndef HALFSPACE_HLS_FORMATS_STREAMS_HPP_
#define HALFSPACE_HLS_FORMATS_STREAMS_HPP_

namespace halfspace {

// Units that stand in each other's place.
template <class F>
struct Units {
  static const char* triangle_shader() {
    return !F::kShades ? "motion_setup" : F::kPhong ? "phong_setup" : "shade_setup";
  }
  static const char* pixel_shader() {
    return !F::kShades ? "motion_field" : F::kPhong ? "shade_phong" : "shade_gouraud";
  }
  // What takes the motion of pixels, and what comes of them.
  static const char* motion_taker() { return F::kUpConverts ? "motion_order" : "motion_compensate"; }
  static const char* pixel_taker() { return F::kUpConverts ? "pixel_store" : "frame"; }
  // Where scan-out leads, and the stream that says where in the frame a stamp of colours is.
  static const char* scan_taker() { return F::kUpConverts ? "hole_scan" : pixel_shader(); }
  static const char* shaded_scan() { return F::kUpConverts ? "masked" : "scan"; }
  static const char* z_test() { return F::kTestsPlanes ? "ztest_plane" : "ztest_index"; }
  static const char* lighting() { return F::kPhong ? "shade_phong" : "light_vertex"; }
};

// clang-format off
#define HS_MOTION_STREAM(X)                                                                                      \
  X(motion, motion, Stream, "motion_field", Units<F>::motion_taker(), "",                                        \
    F::kHasMotion, "with motion",                                                                                \
    "a covered pixel in between: the face that it shows, and the way to the same point in each key frame", Motion<F>)

#define HS_ENTRY_STREAM(X)                                                                                       \
  X(entry, entry, Stream, "scan_object", "ztest_merge", "scan",                                                  \
    F::kHasObjects, "object_bits > 0",                                                                           \
    "in the place of pixel: a stamp of depths, objects and colours", Entry<F>)

// Of hs_pipeline.
#define HS_PIPELINE_STREAMS(X)                                                                                   \
  X(light, light, Loaded, "host", Units<F>::lighting(), "",                                                      \
    F::kHasLighting, "lights > 0",                                                                               \
    "a light: L and H", Light<F>)                                                                                \
  X(material, material, Loaded, "host", Units<F>::lighting(), "",                                                \
    F::kHasLighting, "lights > 0",                                                                               \
    "what a material makes of a light", Material<F>)                                                             \
  X(texture, texture, Loaded, "host", "shade_texture", "",                                                       \
    F::kHasTexture, "with texture",                                                                              \
    "where a texture lies, and its sides", TextureEntry<F>)                                                      \
  X(texel, texel, Loaded, "host", "shade_texture", "",                                                           \
    F::kHasTexture, "with texture",                                                                              \
    "a texel", Texel<F>)                                                                                         \
  X(triangle, triangle, Stream, "geometry", "triangle_setup", "",                                                \
    !F::kGivesIndices, "index_window = 0",                                                                       \
    "a triangle, snapped, with its index; `last` ends the frame", Triangle<F>)                                   \
  X(unnumbered, triangle, Stream, "geometry", "index_pool", "",                                                  \
    F::kGivesIndices, "index_window > 0",                                                                        \
    "the same without an index", UnnumberedTriangle<F>)                                                          \
  X(numbered, numbered, Stream, "index_pool", "triangle_setup", "",                                              \
    F::kGivesIndices, "index_window > 0",                                                                        \
    "the same with the index that it is given; 0, without an area: there is none", Triangle<F>)                  \
  X(setup, setup, Stream, "triangle_setup", "raster_pineda", "",                                                 \
    true, "",                                                                                                    \
    "edge functions, bounding box, depth plane", Setup<F>)                                                       \
  X(attributes, attributes, Stream, "triangle_setup",                                                            \
    F::kDeferred ? "visible_select" : Units<F>::triangle_shader(), "",                                           \
    true, "",                                                                                                    \
    "what planes need; none for an empty triangle, unless it is the last or shading is deferred", Attributes<F>) \
  X(visible_attributes, visible_attributes, Stream, "visible_select", Units<F>::triangle_shader(), "",           \
    F::kDeferred, "deferred",                                                                                    \
    "those of visible triangles, and of the last; `empty` is that it is not visible", Attributes<F>)             \
  X(normals, normals, Stream, "geometry", F::kPhong ? "phong_setup" : "light_vertex", "",                        \
    F::kHasLighting, "lights > 0",                                                                               \
    "in answer to a `visible` that says so: normals of the vertices, flat: one; and the material", Normals<F>)   \
  X(colours, colours, Stream, "light_vertex", "shade_setup", "",                                                 \
    F::kHasLighting && !F::kPhong, "lights > 0, not Phong",                                                      \
    "the colours that they come to", Colours<F>)                                                                 \
  X(normal_planes, planes, Stored, "phong_setup", "tdbs", "",                                                    \
    F::kPhong, "shading = phong",                                                                                \
    "three planes of a normal, and the material", NormalPlanes<F>)                                               \
  X(planes, planes, Stored, "shade_setup", "tdbs", "",                                                           \
    !F::kPhong && F::kShades, "shading = gouraud or flat",                                                       \
    "three colour planes, or one colour", Planes<F>)                                                             \
  X(texture_coordinates, texture_coordinates, Stream, "geometry", "texture_setup", "",                           \
    F::kHasTexture, "with texture",                                                                              \
    "likewise in answer: a texture, and s, t, q of the vertices", TextureCoordinates<F>)                         \
  X(texture_planes, texture_planes, Stored, "texture_setup", "tdbs", "",                                         \
    F::kHasTexture, "with texture",                                                                              \
    "planes of s, t and, with perspective, q", TexturePlanes<F>)                                                 \
  X(motion_vectors, motion_vectors, Stream, "geometry", "motion_setup", "",                                      \
    F::kHasMotion, "with motion",                                                                                \
    "likewise in answer: the face, and for each key frame where the vertices are there", MotionVectors<F>)       \
  X(motion_planes, motion_planes, Stored, "motion_setup", "tdbs", "",                                            \
    F::kHasMotion, "with motion",                                                                                \
    "planes of these places and, with `relight`, of differences of colours", MotionPlanes<F>)                    \
  X(triangle_depth, triangle_depth, Stream, "raster_pineda", "ztest_plane", "",                                  \
    F::kTestsPlanes, "architecture = gamma",                                                                     \
    "the depth plane of each triangle, before its stamps", TriangleDepth<F>)                                     \
  X(stamp, stamp, Stream, "raster_pineda", Units<F>::z_test(), "",                                               \
    true, "",                                                                                                    \
    "coverage and depth of a stamp of pixels", Stamp<F>)                                                         \
  X(update, update, Probe, Units<F>::z_test(), "buffers", "",                                                    \
    true, "",                                                                                                    \
    "a write to the I-buffer, and of type δ to the Z-buffer", Update<F>)                                         \
  X(visible, visible, Stream, F::kDeferred ? "visible_select" : Units<F>::z_test(), "geometry", "",              \
    true, "",                                                                                                    \
    "a triangle is done: has a fragment passed?", Visible<F>)                                                    \
  X(scan, scan, Stream, "scan_index", Units<F>::scan_taker(), "",                                                \
    true, "",                                                                                                    \
    "a stamp of the finished I-buffer", Scan<F>)                                                                 \
  X(masked, masked, Stream, "hole_scan", Units<F>::pixel_shader(), "",                                           \
    F::kUpConverts, "frames_between > 0",                                                                        \
    "in its place: the same, and where holes are filled the holes alone", Scan<F>)                               \
  X(lit, lit, Stream, Units<F>::pixel_shader(), "shade_texture", Units<F>::shaded_scan(),                        \
    F::kHasTexture, "with texture",                                                                              \
    "a stamp of colours before texture", Pixel<F>)                                                               \
  HS_MOTION_STREAM(X)                                                                                            \
  HS_ENTRY_STREAM(X)                                                                                             \
  X(pixel, pixel, Stream, F::kHasTexture ? "shade_texture" : Units<F>::pixel_shader(), Units<F>::pixel_taker(),  \
    Units<F>::shaded_scan(),                                                                                     \
    F::kShades && !F::kHasObjects, "shading other than motion, without objects",                                 \
    "a stamp of colours", Pixel<F>)                                                                              \
  X(shown, shown, Stored, "pixel_store", "key_memory", "",                                                       \
    F::kUpConverts, "frames_between > 0",                                                                        \
    "a pixel of a key frame, or one that is shaded for a hole", ShownPixel<F>)

// Of both; of the memory of key k, N × N pixels a block.
#define HS_KEY_STREAMS(X)                                                                                        \
  X(key_request_0, key_request_0, Fetch, "motion_compensate", "key_memory", "",                                  \
    F::kHasMotion, "with motion",                                                                                \
    "a tile that the cache of key 0 lacks", KeyRequest<F>)                                                       \
  X(key_request_1, key_request_1, Fetch, "motion_compensate", "key_memory", "",                                  \
    F::kHasMotion, "with motion",                                                                                \
    "one that the cache of key 1 lacks", KeyRequest<F>)                                                          \
  X(key_block_0, key_block_0, Fetch, "key_memory", "motion_compensate", "",                                      \
    F::kHasMotion, "with motion",                                                                                \
    "a block of a tile of key 0", KeyBlock<F, N>)                                                                \
  X(key_block_1, key_block_1, Fetch, "key_memory", "motion_compensate", "",                                      \
    F::kHasMotion, "with motion",                                                                                \
    "one of key 1", KeyBlock<F, N>)                                                                              \
  X(compensated, compensated, Stream, "motion_compensate", F::kUpConverts ? "hole_find" : "frame", "",           \
    F::kHasMotion, "with motion",                                                                                \
    "the colour of a pixel in between, and the keys that it is from", Compensated<F>)

// Of hs_motion_compensate.
#define HS_COMPENSATE_STREAMS(X)                                                                                 \
  X(key_weight, key_weight, Loaded, "host", "motion_compensate", "",                                             \
    F::kHasMotion, "with motion",                                                                                \
    "how much key 0 weighs", KeyWeightWord<F>)                                                                   \
  HS_MOTION_STREAM(X)                                                                                            \
  HS_KEY_STREAMS(X)

// Of hs_up_convert besides those of hs_pipeline.
#define HS_FILM_STREAMS(X)                                                                                       \
  X(ordered, ordered, Stream, "motion_order", "motion_compensate", "",                                           \
    F::kUpConverts, "frames_between > 0",                                                                        \
    "the words of motion, tile after tile of the key frames", Motion<F>)                                         \
  HS_KEY_STREAMS(X)                                                                                              \
  X(asked, asked, Stream, "hole_find", "geometry", "",                                                           \
    F::kUpConverts, "frames_between > 0",                                                                        \
    "a face that has holes; of face 0 alone: a frame in between has none", Asked<F>)                             \
  X(film, film, Stream, "film_scan", "frame", "",                                                                \
    F::kUpConverts, "frames_between > 0",                                                                        \
    "a pixel of the film, row by row", FilmPixel<F>)

// Of hs_ztest_merge.
#define HS_MERGE_STREAMS(X)                                                                                      \
  X(merge, merge, Stream, "driver", "ztest_merge", "",                                                           \
    F::kHasObjects, "object_bits > 0",                                                                           \
    "what a run is to do", Merge<F>)                                                                             \
  X(stored, stored, Stream, "s_buffer", "ztest_merge", "",                                                       \
    F::kHasObjects, "object_bits > 0",                                                                           \
    "a stamp of an S-buffer", Entry<F>)                                                                          \
  HS_ENTRY_STREAM(X)                                                                                             \
  X(merged, merged, Stream, "ztest_merge", "frame", "",                                                          \
    F::kHasObjects, "object_bits > 0",                                                                           \
    "a stamp of the frame, or of what becomes of the S-buffer", Entry<F>)                                        \
  X(found, found, Stream, "ztest_merge", "driver", "",                                                           \
    F::kHasObjects, "object_bits > 0",                                                                           \
    "how many pixels show an object that is looked for, and their box", Found<F>)

// Of hs_static_frames besides: there static_run is before ztest_merge and after it.
#define HS_STATIC_STREAMS(X)                                                                                     \
  X(command, command, Stream, "driver", "static_run", "",                                                        \
    F::kHasObjects, "object_bits > 0",                                                                           \
    "a run, and where its stamps come from and go to", StaticCommand<F>)                                         \
  X(stored_place, stored_place, Fetch, "static_run", "memory", "",                                               \
    F::kHasObjects, "object_bits > 0",                                                                           \
    "a stamp that is stored", BufferPlace<F>)                                                                     \
  X(stored_pixels, stored_pixels, Fetch, "memory", "static_run", "",                                             \
    F::kHasObjects, "object_bits > 0",                                                                           \
    "in answer, its pixels", StampPixels<F>)                                                                     \
  X(drawn_place, drawn_place, Fetch, "static_run", "memory", "",                                                 \
    F::kHasObjects, "object_bits > 0",                                                                           \
    "a stamp that is merged with it, and is no pass", BufferPlace<F>)                                             \
  X(drawn_pixels, drawn_pixels, Fetch, "memory", "static_run", "",                                               \
    F::kHasObjects, "object_bits > 0",                                                                           \
    "in answer, its pixels", StampPixels<F>)                                                                     \
  X(drawn, drawn, Stream, "static_run", "ztest_merge", "",                                                       \
    F::kHasObjects, "object_bits > 0",                                                                           \
    "in the place of entry: a stamp of a pass, or of a buffer", Entry<F>)                                        \
  X(kept, kept, Fetch, "static_run", "memory", "",                                                               \
    F::kHasObjects, "object_bits > 0",                                                                           \
    "a stamp of what is merged, into a buffer", KeptStamp<F>)                                                    \
  X(shown, shown, Stream, "static_run", "frame", "",                                                             \
    F::kHasObjects, "object_bits > 0",                                                                           \
    "a stamp of what is merged, which is the frame's", Entry<F>)
// clang-format on

enum class StreamKind { kStream, kStored, kLoaded, kFetch, kProbe };

// A row.
struct StreamRow {
  const char* name;
  StreamKind kind;
  const char *from, *to, *place;
  bool is_there;
  const char *when, *what;
  const char* record;  // with its arguments
};

#define HS_STREAM_ROW(member, name, kind, from, to, place, there, when, what, ...) \
  ::halfspace::StreamRow { #name, ::halfspace::StreamKind::k##kind, from, to, place, there, when, what, #__VA_ARGS__ }

// Of a struct of streams: its members, and visit(v), which calls v(member, row) for each, in flow order.
#define HS_STREAM_MEMBER(member, name, kind, from, to, place, there, when, what, ...) kind<__VA_ARGS__> member;
#define HS_VISIT_STREAM(member, name, kind, from, to, place, there, when, what, ...) \
  v(member, HS_STREAM_ROW(member, name, kind, from, to, place, there, when, what, __VA_ARGS__));
#define HS_STREAM_MEMBERS(STREAMS) \
  STREAMS(HS_STREAM_MEMBER)        \
  template <class V>               \
  void visit(V&& v) {              \
    STREAMS(HS_VISIT_STREAM)       \
  }

}  // namespace halfspace

#endif  // HALFSPACE_HLS_FORMATS_STREAMS_HPP_
