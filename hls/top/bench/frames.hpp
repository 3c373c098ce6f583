// SPDX-License-Identifier: Apache-2.0
// A frame of a vector set through each top. Templates on the bench, so that a program has the tops that it calls, and
// no others.
#ifndef HALFSPACE_HLS_TOP_BENCH_FRAMES_HPP_
#define HALFSPACE_HLS_TOP_BENCH_FRAMES_HPP_

#include <memory>

#include "hls/top/bench/bench.hpp"
#include "hls/top/bench/memories.hpp"
#include "hls/top/tops.hpp"

namespace halfspace {

using F = TopFormats;

inline const char* shaded_attributes() { return F::kDeferred ? "visible_attributes" : "attributes"; }

// Results that it has not read stay in the channel for the next frame.
template <class B>
void frame_of_index_pool(B& bench) {
  static Port<Visible> visible;
  Port<UnnumberedTriangle> triangle;
  Port<Triangle> numbered;
  bench.template send<UnnumberedTriangle<F>>("triangle", triangle);
  bench.template send<Visible<F>>("visible", visible);
  index_pool_top(triangle, visible, numbered);
  bench.template expect<Triangle<F>>("numbered", numbered);
}

template <class B>
void frame_of_triangle_setup(B& bench) {
  Port<Triangle> triangle;
  Port<Setup> setup;
  Port<Attributes> attributes;
  bench.template send<Triangle<F>>(F::kGivesIndices ? "numbered" : "triangle", triangle);
  triangle_setup_top(bench.size().width, bench.size().height, triangle, setup, attributes);
  bench.template expect<Setup<F>>("setup", setup);
  bench.template expect<Attributes<F>>("attributes", attributes);
}

template <class B>
void frame_of_raster_pineda(B& bench) {
  Port<Setup> setup;
  Port<Stamp> stamp;
  bench.template send<Setup<F>>("setup", setup);
  raster_pineda_top(bench.size().width, bench.size().height, setup, stamp);
  bench.template expect<Stamp<F>>("stamp", stamp);
}

template <class B>
void frame_of_raster_pineda_plane(B& bench) {
  Port<Setup> setup;
  Port<Stamp> stamp;
  Port<TriangleDepth> triangle_depth;
  bench.template send<Setup<F>>("setup", setup);
  raster_pineda_plane_top(bench.size().width, bench.size().height, setup, stamp, triangle_depth);
  bench.template expect<Stamp<F>>("stamp", stamp);
  bench.template expect<TriangleDepth<F>>("triangle_depth", triangle_depth);
}

template <class B>
void frame_of_ztest_index(B& bench) {
  static Drawn drawn, expected;
  drawn.clear(), expected.clear();
  expected.draw(bench.template records<Update<F>>("update"));
  Port<Stamp> stamp;
  Port<Visible> visible;
  bench.template send<Stamp<F>>("stamp", stamp);
  ztest_index_top(drawn.index, drawn.depth, stamp, visible);
  bench.template expect<Visible<F>>("visible", visible);
  bench.expect("I-buffer", drawn.index, expected.index);
  if (F::kStoresDepth) bench.expect("Z-buffer", drawn.depth, expected.depth);
}

template <class B>
void frame_of_ztest_plane(B& bench) {
  static Drawn drawn, expected;
  static MemoryWord<DepthEntry> database[VisibilityDatabase<F>::kWords];
  drawn.clear(), expected.clear();
  expected.draw(bench.template records<Update<F>>("update"));
  Port<Stamp> stamp;
  Port<TriangleDepth> triangle_depth;
  Port<Visible> visible;
  bench.template send<Stamp<F>>("stamp", stamp);
  bench.template send<TriangleDepth<F>>("triangle_depth", triangle_depth);
  ztest_plane_top(drawn.index, database, stamp, triangle_depth, visible);
  bench.template expect<Visible<F>>("visible", visible);
  bench.expect("I-buffer", drawn.index, expected.index);
}

template <class B>
void frame_of_visible_select(B& bench) {
  Port<Attributes> attributes, visible_attributes;
  Port<Visible> tested, visible;
  bench.template send<Attributes<F>>("attributes", attributes);
  bench.template send<Visible<F>>("visible", tested);  // as it goes on
  visible_select_top(attributes, tested, visible, visible_attributes);
  bench.template expect<Visible<F>>("visible", visible);
  bench.template expect<Attributes<F>>("visible_attributes", visible_attributes);
}

template <class B>
void frame_of_shade_setup(B& bench) {
  Port<Attributes> attributes;
  Port<Planes> planes;
  bench.template send<Attributes<F>>(shaded_attributes(), attributes);
  shade_setup_top(attributes, planes);
  bench.template expect<Planes<F>>("planes", planes);
}

template <class B>
void frame_of_shade_setup_lit(B& bench) {
  Port<Attributes> attributes;
  Port<Colours> colours;
  Port<Planes> planes;
  bench.template send<Attributes<F>>(shaded_attributes(), attributes);
  bench.template send<Colours<F>>("colours", colours);
  shade_setup_lit_top(attributes, colours, planes);
  bench.template expect<Planes<F>>("planes", planes);
}

template <class B>
void frame_of_light_vertex(B& bench) {
  static Lights lights;
  lights.load(bench);
  Port<Normals> normals;
  Port<Colours> colours;
  bench.template send<Normals<F>>("normals", normals);
  const std::size_t count = bench.template records<Normals<F>>("normals").size();
  for (std::size_t n = 0; n < count; ++n) light_vertex_top(lights.light, lights.material, normals, colours);
  bench.template expect<Colours<F>>("colours", colours);
}

template <class B>
void frame_of_phong_setup(B& bench) {
  Port<Attributes> attributes;
  Port<Normals> normals;
  Port<NormalPlanes> planes;
  bench.template send<Attributes<F>>(shaded_attributes(), attributes);
  bench.template send<Normals<F>>("normals", normals);
  phong_setup_top(attributes, normals, planes);
  bench.template expect<NormalPlanes<F>>("planes", planes);
}

template <class B>
void frame_of_texture_setup(B& bench) {
  Port<Attributes> attributes;
  Port<TextureCoordinates> coordinates;
  Port<TexturePlanes> planes;
  bench.template send<Attributes<F>>(shaded_attributes(), attributes);
  bench.template send<TextureCoordinates<F>>("texture_coordinates", coordinates);
  texture_setup_top(attributes, coordinates, planes);
  bench.template expect<TexturePlanes<F>>("texture_planes", planes);
}

template <class B>
void frame_of_motion_setup(B& bench) {
  Port<Attributes> attributes;
  Port<MotionVectors> vectors;
  Port<MotionPlanes> planes;
  bench.template send<Attributes<F>>(shaded_attributes(), attributes);
  bench.template send<MotionVectors<F>>("motion_vectors", vectors);
  motion_setup_top(attributes, vectors, planes);
  bench.template expect<MotionPlanes<F>>("motion_planes", planes);
}

template <class B>
void frame_of_scan_index(B& bench) {
  static Drawn drawn, cleared;
  drawn.clear();
  drawn.draw(bench.template records<Update<F>>("update"));
  Port<Scan> scan;
  scan_index_top(bench.size().width, bench.size().height, drawn.index, scan);
  bench.template expect<Scan<F>>("scan", scan);
  bench.expect("I-buffer", drawn.index, cleared.index);
}

template <class B>
void frame_of_shade_gouraud(B& bench) {
  static MemoryWord<Planes> database[ShadingDatabase<F>::kWords];
  store_planes<Planes<F>>(bench, "planes", database);
  Port<Scan> scan;
  Port<Pixel> pixel;
  bench.template send<Scan<F>>("scan", scan);
  const int(&background)[3] = bench.size().background;
  shade_gouraud_top(background[0], background[1], background[2], database, scan, pixel);
  expect_shaded(bench, pixel);
}

template <class B>
void frame_of_shade_phong(B& bench) {
  static Lights lights;
  static MemoryWord<NormalPlanes> database[NormalDatabase<F>::kWords];
  lights.load(bench);
  store_planes<NormalPlanes<F>>(bench, "planes", database);
  Port<Scan> scan;
  Port<Pixel> pixel;
  bench.template send<Scan<F>>("scan", scan);
  const int(&background)[3] = bench.size().background;
  shade_phong_top(background[0], background[1], background[2], database, lights.light, lights.material, scan, pixel);
  expect_shaded(bench, pixel);
}

template <class B>
void frame_of_shade_texture(B& bench) {
  static Textures textures;
  static MemoryWord<TexturePlanes> database[TextureDatabase<F>::kWords];
  textures.load(bench);
  store_planes<TexturePlanes<F>>(bench, "texture_planes", database);
  Port<Scan> scan;
  Port<Pixel> lit, pixel;
  bench.template send<Scan<F>>("scan", scan);
  bench.template send<Pixel<F>>("lit", lit);
  shade_texture_top(database, textures.table, textures.texels, scan, lit, pixel);
  expect_shown(bench, pixel);
}

template <class B>
void frame_of_scan_object(B& bench) {
  static Drawn drawn;
  static MemoryWord<ObjectEntry> objects[ObjectTable<F>::kWords];
  drawn.clear();
  drawn.draw(bench.template records<Update<F>>("update"));
  store_objects(bench, objects);
  std::vector<ObjectPixel<F>> expected;
  for (const Entry<F>& entry : bench.template records<Entry<F>>("entry")) expected.push_back(objects_of(entry));
  Port<Scan> scan;
  Port<ObjectPixel> object_pixel;
  bench.template send<Scan<F>>("scan", scan);
  scan_object_top(drawn.depth, objects, scan, object_pixel);
  bench.template expect<ObjectPixel<F>>("entry, but for colours", object_pixel, expected);
}

template <class B>
void frame_of_motion_field(B& bench) {
  static MemoryWord<MotionPlanes> database[MotionDatabase<F>::kWords];
  store_planes<MotionPlanes<F>>(bench, "motion_planes", database);
  Port<Scan> scan;
  Port<Motion> motion;
  bench.template send<Scan<F>>("scan", scan);
  motion_field_top(database, scan, motion);
  bench.template expect<Motion<F>>("motion", motion);
}

// Requests are answered in the order of the set, as blocks stand in it.
template <class B>
void frame_of_motion_compensate(B& bench) {
  Port<Motion> motion;
  Port<KeyRequest> request_0, request_1;
  Port<TopKeyBlock> block_0, block_1;
  Port<Compensated> compensated;
  bench.template send<Motion<F>>("motion", motion);
  bench.template send<TopKeyBlock<F>>("key_block_0", block_0);
  bench.template send<TopKeyBlock<F>>("key_block_1", block_1);
  static int weight = 0;  // a set has a word where it changes
  for (const KeyWeightWord<F>& word : bench.template records<KeyWeightWord<F>>("key_weight")) {
    weight = int(raw(word.weight));
  }
  motion_compensate_top(bench.size().width, bench.size().height, weight, motion, request_0, block_0, request_1, block_1,
                        compensated);
  bench.template expect<Compensated<F>>("compensated", compensated);
  bench.template expect<KeyRequest<F>>("key_request_0", request_0);
  bench.template expect<KeyRequest<F>>("key_request_1", request_1);
}

// A frame of such a set is a run.
template <class B>
void frame_of_ztest_merge(B& bench) {
  Port<Merge> merge;
  Port<Entry> stored, entry, merged;
  Port<Found> found;
  bench.template send<Merge<F>>("merge", merge);
  bench.template send<Entry<F>>("stored", stored);
  bench.template send<Entry<F>>("entry", entry);
  ztest_merge_top(merge, stored, entry, merged, found);
  bench.template expect<Entry<F>>("merged", merged);
  bench.template expect<Found<F>>("found", found);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_TOP_BENCH_FRAMES_HPP_
