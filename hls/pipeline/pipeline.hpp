// SPDX-License-Identifier: Apache-2.0
// The composition: which unit feeds which. Nothing else names two stages. In hardware each unit is a process that runs
// on its streams for ever (hls/top/ has their tops); natively a call takes one triangle, or one stamp, through all of
// them.
#ifndef HALFSPACE_HLS_PIPELINE_PIPELINE_HPP_
#define HALFSPACE_HLS_PIPELINE_PIPELINE_HPP_

#include "hls/motion/motion_field.hpp"
#include "hls/motion/motion_setup.hpp"
#include "hls/objects/scan_object.hpp"
#include "hls/raster/raster_pineda.hpp"
#include "hls/setup/shade_setup.hpp"
#include "hls/setup/triangle_setup.hpp"
#include "hls/shade/light_vertex.hpp"
#include "hls/shade/phong_setup.hpp"
#include "hls/shade/scan_index.hpp"
#include "hls/shade/shade_gouraud.hpp"
#include "hls/shade/shade_phong.hpp"
#include "hls/texture/shade_texture.hpp"
#include "hls/texture/texture_setup.hpp"
#include "hls/ztest/visible_select.hpp"
#include "hls/ztest/ztest_index.hpp"
#include "hls/ztest/ztest_plane.hpp"

namespace halfspace {

template <class F>
struct Streams {
  Stream<Triangle<F>> triangle, drawn_triangle, numbered_triangle;  // the last two with objects: copies
  Stream<Setup<F>> setup;
  Stream<Attributes<F>> attributes;
  Stream<Attributes<F>> visible_attributes, shade_attributes, texture_attributes;  // the last two with texture: copies
  Stream<Normals<F>> normals;
  Stream<Colours<F>> colours;
  Stream<Planes<F>> planes;
  Stream<NormalPlanes<F>> normal_planes;
  Stream<TextureCoordinates<F>> texture_coordinates;
  Stream<TexturePlanes<F>> texture_planes;
  Stream<MotionVectors<F>> motion_vectors;
  Stream<MotionPlanes<F>> motion_planes;
  Stream<Stamp<F>> stamp;
  Stream<TriangleDepth<F>> triangle_depth;
  Probe<int> visits;
  Probe<PlaneTests> tests;
  Probe<Update<F>> update;
  Stream<Visible<F>> tested, visible;             // before and after visible_select, if there is one
  Stream<Scan<F>> scan, pixel_scan, object_scan;  // the last two with objects: copies
  Stream<Scan<F>> shade_scan, texture_scan;       // with texture
  Stream<Pixel<F>> lit, pixel;                    // lit: with texture alone
  Stream<Motion<F>> motion;                       // in the place of pixel
  Stream<ObjectPixel<F>> object_pixel;
  Stream<Entry<F>> entry;  // with objects, in the place of pixel
};

template <class F>
Stream<Visible<F>>& tested_stream(Streams<F>& streams) {
  return F::kDeferred ? streams.tested : streams.visible;
}

// The stamps of one triangle into the I-buffer: through the Z-test of the architecture.
template <class F>
void pipeline_test(Streams<F>& streams, Buffers<F>& buffers, std::false_type) {
  ztest_index(streams.stamp, buffers.index, buffers.depth, streams.update, tested_stream(streams));
}
template <class F>
void pipeline_test(Streams<F>& streams, Buffers<F>& buffers, std::true_type) {
  if (!F::kTestsPlanes) return pipeline_test(streams, buffers, std::false_type());
  ztest_plane(streams.stamp, streams.triangle_depth, buffers.index, buffers.visibility, streams.update,
              tested_stream(streams), streams.tests);
}

// Where the attributes come from that a triangle is shaded by.
template <class F>
Stream<Attributes<F>>& attributes_stream(Streams<F>& streams) {
  return F::kHasTexture ? streams.shade_attributes : F::kDeferred ? streams.visible_attributes : streams.attributes;
}

// Colours into TdbS: they came with the triangle, or are made of its normals.
template <class F>
void pipeline_colours(Streams<F>& streams, Buffers<F>& buffers, std::false_type) {
  shade_setup(attributes_stream(streams), streams.planes);
  store_planes(streams.planes, buffers.shading);
}
template <class F>
void pipeline_colours(Streams<F>& streams, Buffers<F>& buffers, std::true_type) {
  if (!F::kHasLighting) return pipeline_colours(streams, buffers, std::false_type());
  if (!streams.normals.empty()) light_vertex(streams.normals, buffers.lights, buffers.materials, streams.colours);
  shade_setup(attributes_stream(streams), streams.colours, streams.planes);
  store_planes(streams.planes, buffers.shading);
}

template <class F>
void pipeline_planes(Streams<F>& streams, Buffers<F>& buffers, std::false_type) {
  pipeline_colours(streams, buffers, typename F::CompilesLighting());
}
template <class F>
void pipeline_planes(Streams<F>& streams, Buffers<F>& buffers, std::true_type) {
  if (!F::kPhong) return pipeline_planes(streams, buffers, std::false_type());
  phong_setup(attributes_stream(streams), streams.normals, streams.normal_planes);
  store_normal_planes(streams.normal_planes, buffers.normals);
}

template <class F>
void pipeline_coordinates(Streams<F>&, Buffers<F>&, std::false_type) {}
template <class F>
void pipeline_coordinates(Streams<F>& streams, Buffers<F>& buffers, std::true_type) {
  if (!F::kHasTexture) return;
  fork(streams.visible_attributes, streams.shade_attributes, streams.texture_attributes);
  texture_setup(streams.texture_attributes, streams.texture_coordinates, streams.texture_planes);
  store_texture_planes(streams.texture_planes, buffers.coordinates);
}

// All that a frame in between has of a triangle.
template <class F>
void pipeline_motion_planes(Streams<F>&, Buffers<F>&, std::false_type) {}
template <class F>
void pipeline_motion_planes(Streams<F>& streams, Buffers<F>& buffers, std::true_type) {
  motion_setup(streams.visible_attributes, streams.motion_vectors, streams.motion_planes);
  store_motion_planes(streams.motion_planes, buffers.motion);
}

// One triangle from streams.triangle into the I-buffer, and what geometry hears of it into streams.visible.
template <class F>
void pipeline_triangle(const Frame<F>& frame, Streams<F>& streams, Buffers<F>& buffers) {
  if (F::kHasObjects) {
    fork(streams.triangle, streams.drawn_triangle, streams.numbered_triangle);
    store_object(streams.numbered_triangle, buffers.objects);
  }
  triangle_setup(frame, F::kHasObjects ? streams.drawn_triangle : streams.triangle, streams.setup, streams.attributes);
  raster_pineda(frame, streams.setup, streams.stamp, streams.triangle_depth, streams.visits);
  pipeline_test(streams, buffers, typename F::CompilesPlaneTest());
  if (F::kDeferred) visible_select(streams.attributes, streams.tested, streams.visible, streams.visible_attributes);
}

// What it is shaded with into TdbS; with F::kDeferred, and if it is visible, after its words of streams.normals,
// streams.texture_coordinates and streams.motion_vectors.
template <class F>
void pipeline_planes(Streams<F>& streams, Buffers<F>& buffers) {
  const bool none = F::kDeferred ? streams.visible_attributes.empty() : streams.attributes.empty();
  if (none) return;
  if (F::kHasMotion) return pipeline_motion_planes(streams, buffers, typename F::CompilesMotion());
  pipeline_coordinates(streams, buffers, typename F::CompilesTexture());
  pipeline_planes(streams, buffers, typename F::CompilesPhong());
}

// Row `y` of the stamps of the finished frame from the I-buffer; rows are taken from the top.
template <class F>
void pipeline_scan(const Frame<F>& frame, int y, Streams<F>& streams, Buffers<F>& buffers) {
  scan_index(frame, y, buffers.index, streams.scan);
}

// A stamp, without texture.
template <class F>
void pipeline_light(const Frame<F>& frame, Stream<Scan<F>>& scan, Buffers<F>& buffers, Stream<Pixel<F>>& pixel,
                    std::false_type) {
  shade_gouraud(frame, scan, buffers.shading, pixel);
}
template <class F>
void pipeline_light(const Frame<F>& frame, Stream<Scan<F>>& scan, Buffers<F>& buffers, Stream<Pixel<F>>& pixel,
                    std::true_type) {
  if (!F::kPhong) return pipeline_light(frame, scan, buffers, pixel, std::false_type());
  shade_phong(frame, scan, buffers.normals, buffers.lights, buffers.materials, pixel);
}

// The stamps that a shader takes.
template <class F>
Stream<Scan<F>>& shaded_stream(Streams<F>& streams) {
  return F::kHasObjects ? streams.pixel_scan : streams.scan;
}

// One of them into streams.pixel.
template <class F>
void pipeline_shade(const Frame<F>& frame, Streams<F>& streams, Buffers<F>& buffers, std::false_type) {
  pipeline_light(frame, shaded_stream(streams), buffers, streams.pixel, typename F::CompilesPhong());
}
template <class F>
void pipeline_shade(const Frame<F>& frame, Streams<F>& streams, Buffers<F>& buffers, std::true_type) {
  if (!F::kHasTexture) return pipeline_shade(frame, streams, buffers, std::false_type());
  fork(shaded_stream(streams), streams.shade_scan, streams.texture_scan);
  pipeline_light(frame, streams.shade_scan, buffers, streams.lit, typename F::CompilesPhong());
  shade_texture(streams.texture_scan, streams.lit, buffers.coordinates, buffers.textures, buffers.texels,
                streams.pixel);
}
template <class F>
void pipeline_shade(const Frame<F>& frame, Streams<F>& streams, Buffers<F>& buffers) {
  if (F::kHasObjects) {
    fork(streams.scan, streams.pixel_scan, streams.object_scan);
    scan_object(streams.object_scan, buffers.depth, buffers.objects, streams.object_pixel);
  }
  pipeline_shade(frame, streams, buffers, typename F::CompilesTexture());
  if (F::kHasObjects) join_entry(streams.pixel, streams.object_pixel, streams.entry);
}

// With F::kHasMotion in the place of that: one stamp into streams.motion.
template <class F>
void pipeline_motion(Streams<F>&, Buffers<F>&, std::false_type) {}
template <class F>
void pipeline_motion(Streams<F>& streams, Buffers<F>& buffers, std::true_type) {
  motion_field(streams.scan, buffers.motion, streams.motion);
}
template <class F>
void pipeline_motion(Streams<F>& streams, Buffers<F>& buffers) {
  pipeline_motion(streams, buffers, typename F::CompilesMotion());
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_PIPELINE_PIPELINE_HPP_
