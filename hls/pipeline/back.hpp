// SPDX-License-Identifier: Apache-2.0
// From what is visible to pixels: which unit feeds which, from the I-buffer on.
//
//   attributes ─► triangle shaders ─planes─► TdbS
//                                              │
//   I-buffer ─► scan_index ─scan─► pixel shaders ─► pixel
//
// shade_setup and shade_gouraud, or others in their places; texture_setup and shade_texture beside them.
#ifndef HALFSPACE_HLS_PIPELINE_BACK_HPP_
#define HALFSPACE_HLS_PIPELINE_BACK_HPP_

#include "hls/formats/buffers.hpp"
#include "hls/motion/hole_scan.hpp"
#include "hls/motion/motion_field.hpp"
#include "hls/motion/motion_setup.hpp"
#include "hls/objects/scan_object.hpp"
#include "hls/pipeline/choose.hpp"
#include "hls/pipeline/pipeline_streams.hpp"
#include "hls/setup/shade_setup.hpp"
#include "hls/shade/light_vertex.hpp"
#include "hls/shade/phong_setup.hpp"
#include "hls/shade/scan_index.hpp"
#include "hls/shade/shade_gouraud.hpp"
#include "hls/shade/shade_phong.hpp"
#include "hls/texture/shade_texture.hpp"
#include "hls/texture/texture_setup.hpp"

namespace halfspace {

// What a triangle is shaded with into TdbS; with F::kDeferred, and if it is visible, after its words of s.normals,
// s.texture_coordinates and s.motion_vectors.
template <class F>
void pipeline_planes(Pass pass, Streams<F>& s, Buffers<F>& b) {
  Stream<Attributes<F>>& visible = F::kDeferred ? s.visible_attributes : s.attributes;
  if (visible.empty()) return;
  // A frame in between has motion and no more.
  when(typename F::CompilesMotion(), moves<F>(pass), s, b, [&](auto& s, auto& b) {
    motion_setup(visible, s.motion_vectors, s.motion_planes);
    store_planes(s.motion_planes, b.motion);
  });
  if (moves<F>(pass)) return;
  when(typename F::CompilesTexture(), F::kHasTexture, s, b, [&](auto& s, auto& b) {
    fork(visible, s.coloured_attributes, s.texed_attributes);
    texture_setup(s.texed_attributes, s.texture_coordinates, s.texture_planes);
    store_planes(s.texture_planes, b.coordinates);
  });
  Stream<Attributes<F>>& coloured = F::kHasTexture ? s.coloured_attributes : visible;
  when(typename F::CompilesPhong(), F::kPhong, s, b, [&](auto& s, auto& b) {
    phong_setup(coloured, s.normals, s.normal_planes);
    store_planes(s.normal_planes, b.normals);
  });
  if (F::kPhong) return;
  choose(
      typename F::CompilesLighting(), F::kHasLighting, s, b,
      [&](auto& s, auto& b) {
        if (!s.normals.empty()) light_vertex(s.normals, b.lights, b.materials, s.colours);
        shade_setup(coloured, s.colours, s.planes);
      },
      [&](auto& s, auto&) { shade_setup(coloured, s.planes); });
  store_planes(s.planes, b.shading);
}

template <class F>
void pipeline_planes(Streams<F>& s, Buffers<F>& b) {
  pipeline_planes(only_pass<F>(), s, b);
}

// Row `y` of the stamps of the finished frame from the I-buffer; rows are taken from the top.
template <class F>
void pipeline_scan(const Frame<F>& frame, int y, Streams<F>& s, Buffers<F>& b) {
  scan_index(frame, y, b.index, s.scan);
}

// Of films, one stamp of that on its way to the shaders of a pass, unless it shows no hole to fill.
template <class F>
void pipeline_mask(Pass pass, Streams<F>& s, Buffers<F>& b) {
  hole_scan(pass == Pass::kFill, s.scan, b.holes, s.masked);
}

// One of them into s.pixel; with F::kHasObjects into s.entry.
template <class F>
void pipeline_shade(const Frame<F>& frame, Streams<F>& s, Buffers<F>& b) {
  if (F::kHasObjects) {
    fork(s.scan, s.pixel_scan, s.object_scan);
    scan_object(s.object_scan, b.depth, b.objects, s.object_pixel);
  }
  if (F::kUpConverts) fork(s.masked, s.pixel_scan, s.stored_scan);
  Stream<Scan<F>>& scan = F::kHasObjects || F::kUpConverts ? s.pixel_scan : s.scan;
  if (F::kHasTexture) fork(scan, s.coloured_scan, s.texed_scan);
  Stream<Scan<F>>& coloured = F::kHasTexture ? s.coloured_scan : scan;
  Stream<Pixel<F>>& shown = F::kHasObjects ? s.shown_pixel : s.pixel;
  Stream<Pixel<F>>& lit = F::kHasTexture ? s.lit : shown;
  choose(
      typename F::CompilesPhong(), F::kPhong, s, b,
      [&](auto&, auto& b) { shade_phong(frame, coloured, b.normals, b.lights, b.materials, lit); },
      [&](auto&, auto& b) { shade_gouraud(frame, coloured, b.shading, lit); });
  when(typename F::CompilesTexture(), F::kHasTexture, s, b,
       [&](auto& s, auto& b) { shade_texture(s.texed_scan, s.lit, b.coordinates, b.textures, b.texels, shown); });
  if (F::kHasObjects) join_entry(shown, s.object_pixel, s.entry);
}

// In a pass that moves<F>() in the place of that: one stamp into s.motion.
template <class F>
void pipeline_motion(Streams<F>& s, Buffers<F>& b) {
  when(typename F::CompilesMotion(), F::kHasMotion, s, b,
       [](auto& s, auto& b) { motion_field(F::kUpConverts ? s.masked : s.scan, b.motion, s.motion); });
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_PIPELINE_BACK_HPP_
