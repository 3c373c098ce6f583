// SPDX-License-Identifier: Apache-2.0
// The pipeline as hardware runs it: each unit a process on a thread, each stream as deep as in the RTL. Frames are
// drawn and then scanned out, and the frame control between is the end of the first phase.
//
// It is of a translation unit of its own, in configurations that no other has, as its streams are others.
#ifndef HALFSPACE_TESTS_PIPELINE_BOUNDED_ENGINE_HPP_
#define HALFSPACE_TESTS_PIPELINE_BOUNDED_ENGINE_HPP_

#define HALFSPACE_STREAM_BOUNDED

#include <algorithm>
#include <map>
#include <string>

#include "hls/formats/stream_depths.hpp"
#include "model/pipeline/engine_impl.hpp"

namespace halfspace::tests {

template <class F>
class BoundedEngine : public model::KernelEngine<F> {
 public:
  // Streams that are of another depth than in the RTL.
  std::map<std::string, int> depths;
  // "", or why the last frame did not come to its end.
  std::string report;

  ref::Frame render(const ref::SnappedList& scene) override {
    model::check_frame<F>(scene, answers_, true, only_pass<F>());
    const Frame<F> registers = model::frame_registers<F>(scene);
    ref::Frame frame;
    frame.visible.resize(scene.triangles.size());
    report.clear();
    run([&](Schedule& p) {
      p.add("geometry", [&] { geometry(scene, frame); });
      front(p, registers);
      planes(p);
    });
    if (!report.empty()) return frame;
    model::copy_buffers<F>(*buffers_, scene, frame);
    run([&](Schedule& p) { back(p, scene, registers, frame.colour); });
    return frame;
  }

 private:
  using Schedule = bounded::Schedule;
  using Base = model::KernelEngine<F>;
  using Base::answers_;
  using Base::buffers_;
  using Base::streams_;

  template <class Processes>
  void run(Processes&& add) {
    Schedule schedule;
#define HS_BIND(member, depth, fifo) \
  streams_->member.bind(schedule, #member, depths.count(#member) ? depths.at(#member) : (depth));
    HS_STREAM_DEPTHS(HS_BIND)
#undef HS_BIND
    add(schedule);
    report = schedule.run();
#define HS_LEFT(member, depth, fifo) \
  if (report.empty() && !streams_->member.empty()) report = #member " has words that nobody took\n";
    HS_STREAM_DEPTHS(HS_LEFT)
#undef HS_LEFT
  }

  // One process, as a processor is: it sends as far as it may before it hears of the first.
  void geometry(const ref::SnappedList& scene, ref::Frame& frame) {
    const std::size_t count = scene.triangles.size(), words = std::max<std::size_t>(count, 1);
    std::size_t sent = 0, heard = 0;
    while (heard < words) {
      if (sent < words && sent - heard < std::size_t(kTrianglesAhead)) {
        Triangle<F> t{};
        if (sent < count) {
          t = model::triangle_record<F>(scene.triangles[sent], std::uint32_t(sent + 1),
                                        answers_.objects.empty() ? 1 : answers_.objects[sent]);
        }
        t.last = from_raw<Bit>(++sent == words);
        streams_->triangle.write(t);
      } else {
        const Visible<F> done = streams_->visible.read();
        if (heard < count) frame.visible[heard] = raw(done.visible) != 0;
        model::answer<F>(done, answers_, heard++, only_pass<F>(), *streams_);
      }
    }
  }

  void front(Schedule& p, const Frame<F>& frame) {
    Streams<F>& s = *streams_;
    Buffers<F>& b = *buffers_;
    if (F::kHasObjects) {
      p.add_endless("fork_triangle", [&] { fork(s.triangle, s.drawn_triangle, s.numbered_triangle); });
      p.add_endless("store_object", [&] { store_object(s.numbered_triangle, b.objects); });
    }
    Stream<Triangle<F>>& drawn = F::kHasObjects ? s.drawn_triangle : s.triangle;
    Stream<Visible<F>>& tested = F::kDeferred ? s.tested : s.visible;
    p.add_endless("triangle_setup", [&] { triangle_setup(frame, drawn, s.setup, s.attributes); });
    p.add_endless("raster_pineda", [&] { raster_pineda(frame, s.setup, s.stamp, s.triangle_depth, s.visits); });
    if constexpr (F::kTestsPlanes) {
      p.add_endless("ztest_plane",
                    [&] { ztest_plane(s.stamp, s.triangle_depth, b.index, b.visibility, s.update, tested, s.tests); });
    } else {
      p.add_endless("ztest_index", [&] { ztest_index(s.stamp, b.index, b.depth, s.update, tested); });
    }
    if (!F::kDeferred) return;
    p.add_endless("visible_select", [&] { visible_select(s.attributes, tested, s.visible, s.visible_attributes); });
  }

  template <class Planes, class Database>
  static void add_store(Schedule& p, Stream<Planes>& planes, Database& database) {
    p.add("store_planes", [&] {
      while (!store_planes(planes, database)) {}
    });
  }

  void planes(Schedule& p) {
    Streams<F>& s = *streams_;
    Buffers<F>& b = *buffers_;
    Stream<Attributes<F>>& visible = F::kDeferred ? s.visible_attributes : s.attributes;
    Stream<Attributes<F>>& coloured = F::kHasTexture ? s.coloured_attributes : visible;
    if constexpr (F::kHasMotion) {
      p.add_endless("motion_setup", [&] { motion_setup(visible, s.motion_vectors, s.motion_planes); });
      return add_store(p, s.motion_planes, b.motion);
    }
    if constexpr (F::kHasTexture) {
      p.add_endless("fork_attributes", [&] { fork(visible, s.coloured_attributes, s.texed_attributes); });
      p.add_endless("texture_setup",
                    [&] { texture_setup(s.texed_attributes, s.texture_coordinates, s.texture_planes); });
      add_store(p, s.texture_planes, b.coordinates);
    }
    if constexpr (F::kPhong) {
      p.add_endless("phong_setup", [&] { phong_setup(coloured, s.normals, s.normal_planes); });
      return add_store(p, s.normal_planes, b.normals);
    }
    if constexpr (F::kHasLighting && !F::kPhong) {
      p.add_endless("light_vertex", [&] { light_vertex(s.normals, b.lights, b.materials, s.colours); });
      p.add_endless("shade_setup", [&] { shade_setup(coloured, s.colours, s.planes); });
    } else {
      p.add_endless("shade_setup", [&] { shade_setup(coloured, s.planes); });
    }
    add_store(p, s.planes, b.shading);
  }

  void back(Schedule& p, const ref::SnappedList& scene, const Frame<F>& frame, model::Colours8& colour) {
    Streams<F>& s = *streams_;
    Buffers<F>& b = *buffers_;
    p.add("scan_index", [&] {
      for (int y = 0; y * F::kLanesY < scene.height; ++y) scan_index(frame, y, b.index, s.scan);
    });
    if constexpr (F::kHasMotion) {
      p.add_endless("motion_field", [&] { motion_field(s.scan, b.motion, s.motion); });
      p.add("frame", [&] {
        while (!raw(s.motion.read().last)) {}
      });
      return;
    }
    Stream<Scan<F>>& scan = F::kHasObjects ? s.pixel_scan : s.scan;
    Stream<Scan<F>>& coloured = F::kHasTexture ? s.coloured_scan : scan;
    Stream<Pixel<F>>& shown = F::kHasObjects ? s.shown_pixel : s.pixel;
    Stream<Pixel<F>>& lit = F::kHasTexture ? s.lit : shown;
    if (F::kHasObjects) {
      p.add_endless("fork_scan", [&] { fork(s.scan, s.pixel_scan, s.object_scan); });
      p.add_endless("scan_object", [&] { scan_object(s.object_scan, b.depth, b.objects, s.object_pixel); });
      p.add_endless("join_entry", [&] { join_entry(shown, s.object_pixel, s.entry); });
    }
    if constexpr (F::kPhong) {
      p.add_endless("shade_phong", [&] { shade_phong(frame, coloured, b.normals, b.lights, b.materials, lit); });
    } else {
      p.add_endless("shade_gouraud", [&] { shade_gouraud(frame, coloured, b.shading, lit); });
    }
    if constexpr (F::kHasTexture) {
      p.add_endless("fork_texture", [&] { fork(scan, s.coloured_scan, s.texed_scan); });
      p.add_endless("shade_texture",
                    [&] { shade_texture(s.texed_scan, s.lit, b.coordinates, b.textures, b.texels, shown); });
    }
    colour.resize(std::size_t(scene.width) * scene.height);
    p.add("frame", [&] {
      for (bool last = false; !last;) {
        const Pixel<F> word = F::kHasObjects ? Pixel<F>(s.entry.read()) : s.pixel.read();
        model::put_stamp<F>(word, scene.width, scene.height, colour);
        last = raw(word.last) != 0;
      }
    });
  }
};

}  // namespace halfspace::tests

#endif  // HALFSPACE_TESTS_PIPELINE_BOUNDED_ENGINE_HPP_
