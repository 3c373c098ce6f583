// SPDX-License-Identifier: Apache-2.0
// A frame of a vector set through each composed top, as frames.hpp has them for those of units.
#ifndef HALFSPACE_HLS_TOP_BENCH_COMPOSED_FRAMES_HPP_
#define HALFSPACE_HLS_TOP_BENCH_COMPOSED_FRAMES_HPP_

#include "hls/top/bench/bench.hpp"
#include "hls/top/bench/memories.hpp"
#include "hls/top/tops.hpp"

namespace halfspace {

inline FrameWord<TopFormats> frame_word(const Bench::Size& size) {
  FrameWord<TopFormats> word = {background_frame(size.background[0], size.background[1], size.background[2])};
  word.frame.width = top_frame(size.width, size.height).width;
  word.frame.height = top_frame(size.width, size.height).height;
  return word;
}

// What a frame is drawn with, from the frame's word to the memories.
template <template <class> class Record, class Database>
struct DrawBench {
  using F = TopFormats;

  // `planes` is the stream that the database is of.
  template <class B>
  DrawBench(B& bench, const char* planes) {
    drawn().clear(), expected().clear();
    expected().draw(bench.template records<Update<F>>("update"));
    store_planes<Record<F>>(bench, planes, of_set());
    frame.write(packed(frame_word(bench.size())));
    bench.template send<Triangle<F>>("triangle", triangle);
  }
  // Of arguments `first` and the next: `visible`, and the word once the frame is drawn.
  template <class B>
  void announce(B& bench, int first) {
    bench.announce(first, bench.template records<Visible<F>>("visible").size());
    bench.announce(first + 1, 1);
  }
  template <class B>
  void expect(B& bench) {
    bench.template expect<Visible<F>>("visible", visible);
    bench.template expect<FrameWord<F>>("drawn", drawn_frame, {frame_word(bench.size())});
    bench.expect("I-buffer", drawn().index, expected().index);
    if (F::kStoresDepth) bench.expect("Z-buffer", drawn().depth, expected().depth);
    bench.expect("database", database(), of_set());
  }

  using Memory = MemoryWord<Record>[Database::kWords];
  static Drawn& drawn() {
    static Drawn memories;
    return memories;
  }
  static Drawn& expected() {
    static Drawn memories;
    return memories;
  }
  static Memory& database() {
    static Memory memory;
    return memory;
  }
  static Memory& of_set() {
    static Memory memory;
    return memory;
  }

  Port<FrameWord> frame, drawn_frame;
  Port<Triangle> triangle;
  Port<Visible> visible;
};

template <class B>
void frame_of_front(B& bench) {
  DrawBench<Planes, ShadingDatabase<TopFormats>> draw(bench, "planes");
  draw.announce(bench, 5);
  front_top(draw.drawn().index, draw.drawn().depth, draw.database(), draw.frame, draw.triangle, draw.visible,
            draw.drawn_frame);
  draw.expect(bench);
}

template <class B>
void frame_of_front_lit(B& bench) {
  static Lights lights;
  lights.load(bench);
  DrawBench<Planes, ShadingDatabase<TopFormats>> draw(bench, "planes");
  Port<Normals> normals;
  bench.template send<Normals<TopFormats>>("normals", normals);
  draw.announce(bench, 8);
  front_lit_top(draw.drawn().index, draw.drawn().depth, draw.database(), lights.light, lights.material, draw.frame,
                draw.triangle, normals, draw.visible, draw.drawn_frame);
  draw.expect(bench);
}

template <class B>
void frame_of_front_phong(B& bench) {
  DrawBench<NormalPlanes, NormalDatabase<TopFormats>> draw(bench, "planes");
  Port<Normals> normals;
  bench.template send<Normals<TopFormats>>("normals", normals);
  draw.announce(bench, 6);
  front_phong_top(draw.drawn().index, draw.drawn().depth, draw.database(), draw.frame, draw.triangle, normals,
                  draw.visible, draw.drawn_frame);
  draw.expect(bench);
}

template <class B>
void frame_of_front_textured(B& bench) {
  static MemoryWord<TexturePlanes> coordinates[TextureDatabase<TopFormats>::kWords],
      of_set[TextureDatabase<TopFormats>::kWords];
  store_planes<TexturePlanes<TopFormats>>(bench, "texture_planes", of_set);
  DrawBench<Planes, ShadingDatabase<TopFormats>> draw(bench, "planes");
  Port<TextureCoordinates> texture_coordinates;
  bench.template send<TextureCoordinates<TopFormats>>("texture_coordinates", texture_coordinates);
  draw.announce(bench, 7);
  front_textured_top(draw.drawn().index, draw.drawn().depth, draw.database(), coordinates, draw.frame, draw.triangle,
                     texture_coordinates, draw.visible, draw.drawn_frame);
  draw.expect(bench);
  bench.expect("database of coordinates", coordinates, of_set);
}

template <class B>
void frame_of_front_motion(B& bench) {
  DrawBench<MotionPlanes, MotionDatabase<TopFormats>> draw(bench, "motion_planes");
  Port<MotionVectors> vectors;
  bench.template send<MotionVectors<TopFormats>>("motion_vectors", vectors);
  draw.announce(bench, 6);
  front_motion_top(draw.drawn().index, draw.drawn().depth, draw.database(), draw.frame, draw.triangle, vectors,
                   draw.visible, draw.drawn_frame);
  draw.expect(bench);
}

// What a drawn frame is shaded with.
template <template <class> class Record, class Database>
struct ShadeBench {
  using F = TopFormats;

  template <class B>
  ShadeBench(B& bench, const char* planes) {
    drawn().clear();
    drawn().draw(bench.template records<Update<F>>("update"));
    store_planes<Record<F>>(bench, planes, database());
    frame.write(packed(frame_word(bench.size())));
  }
  // The colours: of argument `argument`.
  template <class B>
  void announce(B& bench, int argument) {
    bench.announce(argument, bench.template records<Scan<F>>("scan").size());
  }
  template <class B>
  void expect_cleared(B& bench) {
    static Drawn cleared;
    bench.expect("I-buffer", drawn().index, cleared.index);
  }

  using Memory = MemoryWord<Record>[Database::kWords];
  static Drawn& drawn() {
    static Drawn memories;
    return memories;
  }
  static Memory& database() {
    static Memory memory;
    return memory;
  }

  Port<FrameWord> frame;
  Port<Pixel> pixel;
};

template <class B>
void frame_of_back(B& bench) {
  ShadeBench<Planes, ShadingDatabase<TopFormats>> shade(bench, "planes");
  shade.announce(bench, 3);
  back_top(shade.drawn().index, shade.database(), shade.frame, shade.pixel);
  expect_shaded(bench, shade.pixel);
  shade.expect_cleared(bench);
}

template <class B>
void frame_of_back_phong(B& bench) {
  static Lights lights;
  lights.load(bench);
  ShadeBench<NormalPlanes, NormalDatabase<TopFormats>> shade(bench, "planes");
  shade.announce(bench, 5);
  back_phong_top(shade.drawn().index, shade.database(), lights.light, lights.material, shade.frame, shade.pixel);
  expect_shaded(bench, shade.pixel);
  shade.expect_cleared(bench);
}

template <class B>
void frame_of_back_textured(B& bench) {
  static Textures textures;
  static MemoryWord<TexturePlanes> coordinates[TextureDatabase<TopFormats>::kWords];
  textures.load(bench);
  store_planes<TexturePlanes<TopFormats>>(bench, "texture_planes", coordinates);
  ShadeBench<Planes, ShadingDatabase<TopFormats>> shade(bench, "planes");
  shade.announce(bench, 6);
  back_textured_top(shade.drawn().index, shade.database(), coordinates, textures.table, textures.texels, shade.frame,
                    shade.pixel);
  expect_shown(bench, shade.pixel);
  shade.expect_cleared(bench);
}

template <class B>
void frame_of_back_motion(B& bench) {
  ShadeBench<MotionPlanes, MotionDatabase<TopFormats>> shade(bench, "motion_planes");
  Port<Motion> motion;
  bench.announce(3, bench.template records<Motion<TopFormats>>("motion").size());
  back_motion_top(shade.drawn().index, shade.database(), shade.frame, motion);
  bench.template expect<Motion<TopFormats>>("motion", motion);
  shade.expect_cleared(bench);
}

template <class B>
void frame_of_back_compensate(B& bench) {
  using F = TopFormats;
  static KeyFrames keys;
  static KeyWeightWord<F> weight{};  // a set has a word where it changes
  for (const KeyWeightWord<F>& word : bench.template records<KeyWeightWord<F>>("key_weight")) weight = word;
  keys.load(bench);
  ShadeBench<MotionPlanes, MotionDatabase<F>> shade(bench, "motion_planes");
  Port<KeyWeightWord> key_weight;
  Port<Compensated> compensated;
  key_weight.write(packed(weight));
  bench.announce(6, bench.template records<Compensated<F>>("compensated").size());
  back_compensate_top(shade.drawn().index, shade.database(), keys.key_0, keys.key_1, shade.frame, key_weight,
                      compensated);
  bench.template expect<Compensated<F>>("compensated", compensated);
  shade.expect_cleared(bench);
}

template <class B>
void frame_of_back_objects(B& bench) {
  static MemoryWord<ObjectEntry> objects[ObjectTable<TopFormats>::kWords];
  store_objects(bench, objects);
  ShadeBench<Planes, ShadingDatabase<TopFormats>> shade(bench, "planes");
  Port<Entry> entry;
  shade.announce(bench, 5);
  back_objects_top(shade.drawn().index, shade.drawn().depth, shade.database(), objects, shade.frame, entry);
  bench.template expect<Entry<TopFormats>>("entry", entry);
  shade.expect_cleared(bench);
}

// Places are answered in the order of the set, as pixels stand in it. A frame has several commands.
template <class B>
void frame_of_static_frames(B& bench) {
  using F = TopFormats;
  Port<StaticCommand> command;
  Port<Entry> entry, shown;
  Port<BufferPlace> stored_place, drawn_place;
  Port<StampPixels> stored_pixels, drawn_pixels;
  Port<KeptStamp> kept;
  Port<Found> found;
  bench.template send<StaticCommand<F>>("command", command);
  bench.template send<Entry<F>>("entry", entry);
  bench.template send<StampPixels<F>>("stored_pixels", stored_pixels);
  bench.template send<StampPixels<F>>("drawn_pixels", drawn_pixels);
  const std::size_t commands = bench.template records<StaticCommand<F>>("command").size();
  bench.announce(2, bench.template records<BufferPlace<F>>("stored_place").size());
  bench.announce(4, bench.template records<BufferPlace<F>>("drawn_place").size());
  bench.announce(6, bench.template records<KeptStamp<F>>("kept").size());
  bench.announce(7, bench.template records<Entry<F>>("shown").size());
  bench.announce(8, commands);
  for (std::size_t n = 0; n < commands; ++n)
    static_frames_top(command, entry, stored_place, stored_pixels, drawn_place, drawn_pixels, kept, shown, found);
  bench.template expect<BufferPlace<F>>("stored_place", stored_place);
  bench.template expect<BufferPlace<F>>("drawn_place", drawn_place);
  bench.template expect<KeptStamp<F>>("kept", kept);
  bench.template expect<Entry<F>>("shown", shown);
  bench.template expect<Found<F>>("found", found);
}

template <class B>
void frame_of_pipeline(B& bench) {
  Port<FrameWord> frame;
  Port<Triangle> triangle;
  Port<Visible> visible;
  Port<Pixel> pixel;
  bench.template send<Triangle<TopFormats>>("triangle", triangle);
  frame.write(packed(frame_word(bench.size())));
  bench.announce(2, bench.template records<Visible<TopFormats>>("visible").size());
  bench.announce(3, bench.template records<Pixel<TopFormats>>("pixel").size());
  pipeline_top(frame, triangle, visible, pixel);
  bench.template expect<Visible<TopFormats>>("visible", visible);
  bench.template expect<Pixel<TopFormats>>("pixel", pixel);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_TOP_BENCH_COMPOSED_FRAMES_HPP_
