// SPDX-License-Identifier: Apache-2.0
#include "hls/shade/light_vertex.hpp"
#include "hls/top/composed/draw_processes.hpp"
#include "hls/top/composed/gouraud_processes.hpp"
#include "hls/top/tops.hpp"

using namespace halfspace;

namespace {

// Colours for the attributes, which go on as they are.
void light_process(MemoryWord<Light> lights[LightTable<TopFormats>::kWords],
                   MemoryWord<Material> materials[MaterialTable<TopFormats>::kWords], Port<Attributes>& attributes,
                   Port<Normals>& normals, Port<Attributes>& lit, Port<Colours>& colours) {
  using F = TopFormats;
  static_assert(F::kHasLighting && !F::kPhong, "light_vertex is of configurations that light vertices");
  LightTable<F> lights_view = {Words<Light<F>>(lights)};
  MaterialTable<F> materials_view = {WordRows<Material<F>, kMostLights>(materials)};
  View<Attributes> attributes_words(attributes), lit_words(lit);
  View<Normals> normals_words(normals);
  View<Colours> colours_words(colours);
  bool done = false;
Words:
  while (!done) {
    const Attributes<F> word = attributes_words.read();
    lit_words.write(word);
    if (!is_set(word.empty)) light_vertex(normals_words, lights_view, materials_view, colours_words);
    done = is_set(word.last);
  }
}

void lit_planes_process(Port<Attributes>& attributes, Port<Colours>& colours, Port<Planes>& planes) {
  View<Attributes> attributes_words(attributes);
  View<Colours> colours_words(colours);
  View<Planes> planes_words(planes);
Words:
  while (!shade_setup(attributes_words, colours_words, planes_words)) {}
}

class FrontLit {
 public:
  void run(MemoryWord<IndexStamp> index_buffer[IndexBuffer<TopFormats>::kWords],
           MemoryWord<DepthStamp> depth_buffer[DepthBuffer<TopFormats>::kWords],
           MemoryWord<Planes> database[ShadingDatabase<TopFormats>::kWords],
           MemoryWord<Light> lights[LightTable<TopFormats>::kWords],
           MemoryWord<Material> materials[MaterialTable<TopFormats>::kWords], Port<FrameWord>& frame,
           Port<Triangle>& triangle, Port<Normals>& normals, Port<Visible>& visible, Port<FrameWord>& drawn) {
#ifdef HS_DATAFLOW
#pragma HLS dataflow
#endif
    HS_DEPTH(setup_, TopDepths::setup)
    HS_DEPTH(attributes_, TopDepths::attributes)
    HS_DEPTH(stamp_, TopDepths::stamp)
    fork_frame(frame, setup_frame_, raster_frame_, test_frame_);
    triangle_process(setup_frame_, triangle, setup_, attributes_);
    raster_process(raster_frame_, setup_, stamp_);
    test_process(index_buffer, depth_buffer, test_frame_, stamp_, tested_, tested_frame_);
    select_process(attributes_, tested_, visible, passed_);
    light_process(lights, materials, passed_, normals, lit_, colours_);
    lit_planes_process(lit_, colours_, planes_);
    store_process(database, planes_, tested_frame_, drawn);
  }

 private:
  Port<FrameWord> setup_frame_, raster_frame_, test_frame_, tested_frame_;
  Port<Setup> setup_;
  Port<Attributes> attributes_, passed_, lit_;
  Port<Stamp> stamp_;
  Port<Visible> tested_;
  Port<Colours> colours_;
  Port<Planes> planes_;
};

}  // namespace

extern "C" void front_lit_top(MemoryWord<IndexStamp> index_buffer[IndexBuffer<TopFormats>::kWords],
                              MemoryWord<DepthStamp> depth_buffer[DepthBuffer<TopFormats>::kWords],
                              MemoryWord<Planes> database[ShadingDatabase<TopFormats>::kWords],
                              MemoryWord<Light> lights[LightTable<TopFormats>::kWords],
                              MemoryWord<Material> materials[MaterialTable<TopFormats>::kWords], Port<FrameWord>& frame,
                              Port<Triangle>& triangle, Port<Normals>& normals, Port<Visible>& visible,
                              Port<FrameWord>& drawn) {
  HS_MEMORY_PORT(index_buffer)
  HS_MEMORY_PORT(depth_buffer)
  HS_MEMORY_PORT(database)
  HS_MEMORY_PORT(lights)
  HS_MEMORY_PORT(materials)
  HS_STREAM_PORT(frame)
  HS_STREAM_PORT(triangle)
  HS_STREAM_PORT(normals)
  HS_STREAM_PORT(visible)
  HS_STREAM_PORT(drawn)
  HS_STARTED
  static FrontLit front_lit;
  front_lit.run(index_buffer, depth_buffer, database, lights, materials, frame, triangle, normals, visible, drawn);
}
