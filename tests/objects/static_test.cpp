// SPDX-License-Identifier: Apache-2.0
// Static objects buffers against the renderer that draws everything: random starts and stops, frame by frame, to the
// bit.
#include <gtest/gtest.h>

#include <cstdio>
#include <glm/gtc/matrix_transform.hpp>

#include "model/pipeline/cycles.hpp"
#include "ref/builtin/crowd.hpp"
#include "ref/error.hpp"
#include "ref/geometry/geometry.hpp"
#include "ref/objects/static_objects.hpp"
#include "ref/raster/raster.hpp"
#include "vectors/moving_scene.hpp"

namespace halfspace::ref {
namespace {

constexpr int kWidth = 40, kHeight = 30, kObjects = 16;

RasterFormat format_of(int depth_bits) { return {"static", kWidth, kHeight, 4096, 7, 6, depth_bits}; }
View view_of(const RasterFormat& format) { return {kWidth, kHeight, format.range_bits, format.subpixel_bits}; }

Scene small_scene() { return model::moving_scene(kObjects); }
struct Motion : model::SceneMotion {
  explicit Motion(std::uint64_t seed) : SceneMotion(seed, kObjects) {}
};

// Pixels at which the picture is not what the renderer draws, by face, depth or colour.
int wrong_pixels(const Scene& scene, const Frame& drawn, const std::vector<std::uint32_t>& faces,
                 const ObjectBuffer& picture) {
  std::vector<std::uint32_t> first{1};
  for (const Instance& instance : scene.instances)
    first.push_back(first.back() + std::uint32_t(scene.meshes[instance.mesh].triangles.size()));
  int wrong = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const std::size_t at = std::size_t(y) * kWidth + x;
      const ObjectPixel& pixel = picture.at(x, y);
      const std::uint32_t face = pixel.object() == 0 ? 0 : first[pixel.object() - 1] + face_of(pixel.triangle);
      wrong += face != (drawn.index[at] == 0 ? 0 : faces[drawn.index[at] - 1]) || pixel.depth() != drawn.depth[at] ||
               pixel.colour != drawn.colour[at];
    }
  }
  return wrong;
}

struct Everything {
  Frame frame;
  std::vector<std::uint32_t> faces;
};
Everything draw_everything(const Scene& scene, const RasterFormat& format) {
  const TriangleList list = project(scene, view_of(format));
  return {render(snap(list, format)), list.face};
}

// An S-buffer drawn from nothing.
ObjectBuffer rebuilt(const Scene& scene, const RasterFormat& format, StaticObjects& objects, int k) {
  ObjectBuffer buffer(kWidth, kHeight, full_depth(format.depth_bits));
  for (std::uint32_t n = 0; n < scene.instances.size(); ++n) {
    if (objects.is_static(n) && objects.buffer_of(n) == k) objects.raster().draw(n, buffer, buffer.frame());
  }
  return buffer;
}

bool same_objects(const ObjectBuffer& a, const ObjectBuffer& b) {
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      if (a.at(x, y).key != b.at(x, y).key || a.at(x, y).triangle != b.at(x, y).triangle) return false;
    }
  }
  return true;
}

StaticOptions options_of(int buffers, OcclusionQuery query) {
  StaticOptions options;
  options.buffers = buffers;
  options.query = std::move(query);
  return options;
}

// --- pictures ---

struct Case {
  int buffers;
  bool query;
};

TEST(StaticObjects, EachFrameIsThatOfDrawingEverything) {
  constexpr Case kCases[] = {{1, false}, {1, true}, {7, false}, {7, true}, {3, true}};
  constexpr int kFrames = 3000;
  std::uint64_t states[4] = {}, ties = 0, new_views = 0, shown_moving = 0;
  for (const int depth_bits : {24, 5}) {
    const RasterFormat format = format_of(depth_bits);
    Scene scene = small_scene();
    Motion motion(7 + std::uint64_t(depth_bits));
    motion.begin(scene);
    std::vector<StaticObjects> ours;
    for (const Case& c : kCases)
      ours.emplace_back(scene, format, kWidth, kHeight,
                        options_of(c.buffers, c.query ? visible_pixels : OcclusionQuery()));
    for (int frame = 0; frame < kFrames / 2; ++frame) {
      motion.step(scene);
      motion.move_viewer(scene);
      const bool dimmed = motion.dim(scene);
      const Everything all = draw_everything(scene, format);
      for (std::size_t i = 0; i < ours.size(); ++i) {
        if (dimmed) ours[i].start_anew();
        const FrameWork& work = ours[i].draw();
        ASSERT_EQ(wrong_pixels(scene, all.frame, all.faces, ours[i].picture()), 0)
            << "frame " << frame << ", " << kCases[i].buffers << " S-buffers, query " << kCases[i].query;
        for (int k = 0; k < kCases[i].buffers; ++k)
          ASSERT_TRUE(same_objects(ours[i].static_buffer(k), rebuilt(scene, format, ours[i], k)))
              << "frame " << frame << ", " << k;
        ASSERT_EQ(work.queries, kCases[i].query ? work.started : 0u);
        ASSERT_TRUE(!work.new_view || work.moving == scene.instances.size());
        new_views += i == 0 && work.new_view;
      }
      for (std::uint32_t n = 0; n < scene.instances.size(); ++n) ++states[int(ours[0].state(n))];
      // Pixels where something that stands and something that moves are equally near.
      for (std::uint32_t n = 0; n < scene.instances.size(); ++n) {
        if (ours[0].is_static(n)) continue;
        ours[0].raster().fragments(n, ours[0].picture().frame(), [&](int x, int y, std::uint32_t depth, std::uint32_t) {
          const ObjectPixel& still = ours[0].static_buffer(0).at(x, y);
          ties += still.object() != 0 && still.depth() == depth && ours[0].picture().at(x, y).depth() == depth;
          shown_moving += ours[0].picture().at(x, y).object() == n + 1;
        });
      }
    }
  }
  for (const std::uint64_t count : states) EXPECT_GT(count, 2000u);
  EXPECT_GT(ties, 10000u);
  EXPECT_GT(shown_moving, 100000u);
  EXPECT_GT(new_views, 50u);
  std::printf("SS %lu, SD %lu, DS %lu, DD %lu; %lu ties of S and D, %lu frames from a new viewpoint or in new light\n",
              states[0], states[1], states[2], states[3], ties, new_views);
}

// --- the occlusion query ---

// Every object that starts to move, with what its S-buffer showed of it a frame before.
TEST(StaticObjects, QuerySkipsWhatIsNotNeededAndNothingElse) {
  const RasterFormat format = format_of(24);
  for (const int buffers : {1, 3}) {
    Scene scene = small_scene();
    Motion motion(99);
    motion.begin(scene);
    std::vector<std::pair<std::uint32_t, bool>> answers;  // object, skipped
    const OcclusionQuery query = [&](const ObjectBuffer& buffer, std::uint32_t object, const Box& box) {
      const std::uint64_t count = buffer.count(object, box);
      answers.emplace_back(object, count == 0);
      return count;
    };
    StaticObjects ours(scene, format, kWidth, kHeight, options_of(buffers, query));
    std::uint64_t needed = 0, unneeded = 0, skipped = 0;
    ours.draw();
    for (int frame = 0; frame < 2000; ++frame) {
      std::vector<ObjectBuffer> before;
      for (int k = 0; k < buffers; ++k) before.push_back(rebuilt(scene, format, ours, k));
      std::vector<bool> by_drawing;  // seen, as the Z-test counts it
      for (std::uint32_t n = 0; n < scene.instances.size(); ++n)
        by_drawing.push_back(ours.is_static(n) &&
                             ours.raster().count_equal(n, ours.static_buffer(ours.buffer_of(n))) != 0);
      motion.step(scene);
      answers.clear();
      ours.draw();
      for (const auto& [object, skip] : answers) {
        const ObjectBuffer& buffer = before[ours.buffer_of(object - 1)];
        const bool need = buffer.count(object, buffer.frame()) != 0;
        ASSERT_EQ(by_drawing[object - 1], need);
        ++(need ? needed : unneeded);
        ASSERT_FALSE(need && skip) << "frame " << frame << ", object " << object;
        skipped += skip;
      }
    }
    std::printf("%d S-buffers: %lu updates needed, %lu not, of which %lu skipped\n", buffers, needed, unneeded,
                skipped);
    EXPECT_GT(needed, 500u);
    EXPECT_GT(unneeded, 200u);
    EXPECT_GE(double(skipped), 0.95 * double(unneeded));
  }
}

// Frames that come out wrong with a query that answers as `broken` does.
int wrong_frames(int buffers, const std::function<OcclusionQuery(const StaticObjects*&)>& broken) {
  const RasterFormat format = format_of(24);
  Scene scene = small_scene();
  Motion motion(5);
  motion.begin(scene);
  const StaticObjects* asked = nullptr;
  StaticObjects ours(scene, format, kWidth, kHeight, options_of(buffers, broken(asked)));
  asked = &ours;
  int wrong = 0;
  for (int frame = 0; frame < 300; ++frame) {
    motion.step(scene);
    const Everything all = draw_everything(scene, format);
    ours.draw();
    wrong += wrong_pixels(scene, all.frame, all.faces, ours.picture()) != 0;
  }
  return wrong;
}

TEST(StaticObjects, BrokenQueriesLeaveGhosts) {
  EXPECT_EQ(wrong_frames(1, [](auto&) { return visible_pixels; }), 0);
  // The picture in the place of the S-buffer: what a moving object hides now is a ghost when that has gone.
  const auto picture = [](const StaticObjects*& asked) {
    return [&asked](const ObjectBuffer&, std::uint32_t object, const Box& box) {
      return asked->picture().count(object, box);
    };
  };
  EXPECT_GT(wrong_frames(1, picture), 0);
  EXPECT_GT(wrong_frames(7, picture), 0);
  // Few pixels taken for none.
  EXPECT_GT(wrong_frames(1,
                         [](auto&) {
                           return [](const ObjectBuffer& buffer, std::uint32_t object, const Box& box) {
                             return buffer.count(object, box) / 8;
                           };
                         }),
            0);
  // Not the whole box.
  EXPECT_GT(wrong_frames(1,
                         [](auto&) {
                           return [](const ObjectBuffer& buffer, std::uint32_t object, const Box& box) {
                             return buffer.count(object, {box.x0, box.y0, box.x1, box.y1 - 1});
                           };
                         }),
            0);
}

// --- what a frame takes ---

TEST(StaticObjects, DrawWhatMovesAndNothingElse) {
  const RasterFormat format = format_of(24);
  Scene scene = small_scene();
  Motion motion(1);
  motion.begin(scene);
  const std::uint64_t all = scene.instances.size();
  StaticObjects ours(scene, format, kWidth, kHeight, options_of(1, visible_pixels));
  scene.instances[2].to_world = motion.place();
  FrameWork work = ours.draw();
  EXPECT_EQ(work.moving, 1u);
  EXPECT_EQ(work.added, all - 1);
  EXPECT_EQ(ours.state(2), ObjectState::kDD);
  EXPECT_EQ(ours.state(3), ObjectState::kDS);
  work = ours.draw();
  EXPECT_EQ(work.moving, 0u);
  EXPECT_EQ(work.added, 1u);
  EXPECT_EQ(ours.draw().drawn(), 0u);
  EXPECT_EQ(ours.state(2), ObjectState::kSS);
  scene.instances[2].to_world = glm::scale(glm::dmat4(1), glm::dvec3(0.9));
  work = ours.draw();
  EXPECT_EQ(ours.state(2), ObjectState::kSD);
  EXPECT_EQ(work.moving, 1u);
  EXPECT_EQ(work.started, 1u);

  scene.camera->position.x += 0.1;
  work = ours.draw();
  EXPECT_TRUE(work.new_view);
  EXPECT_EQ(work.moving, all);
  EXPECT_EQ(work.added + work.redrawn + work.queries, 0u);
  work = ours.draw();
  EXPECT_FALSE(work.new_view);
  EXPECT_EQ(work.moving, 0u);
  EXPECT_EQ(work.added, all);
  EXPECT_EQ(ours.draw().drawn(), 0u);
}

// More triangles than there are indices are drawn in passes, wherever these begin: the merge, a pass after the other,
// gives the whole, with the first pass where keys are equal.
TEST(ObjectBuffer, PassesMergeToTheWhole) {
  const RasterFormat format = format_of(5);
  Scene scene = small_scene();
  Motion motion(3);
  for (int run = 0; run < 50; ++run) {
    motion.begin(scene);
    AllObjects all(scene, format, kWidth, kHeight);
    all.draw();
    const int indices = 1 + motion.below(20);
    ObjectRaster raster(scene, format, kWidth, kHeight);
    ObjectBuffer merged(kWidth, kHeight, full_depth(format.depth_bits)), pass = merged;
    int used = 0;
    const auto finish = [&] {
      for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
          if (pass.at(x, y).key < merged.at(x, y).key) merged.at(x, y) = pass.at(x, y);
        }
      }
      pass.clear(pass.frame());
      used = 0;
    };
    for (std::uint32_t n = 0; n < scene.instances.size(); ++n) {
      std::uint32_t last = ~0u;
      raster.fragments(n, merged.frame(), [&](int x, int y, std::uint32_t depth, std::uint32_t triangle) {
        if (triangle != last && used++ == indices) finish();
        last = triangle;
        pass.test(x, y, object_key(depth, n + 1), triangle);
      });
    }
    finish();
    ASSERT_TRUE(same_objects(merged, all.picture()));
  }
}

// --- what is drawn, and the planes of depth ---

// A scene by Geometry, snapped, and one object after the other. Returns how many triangles clipping has made.
int expect_geometry(const Scene& scene, const RasterFormat& format, int width, int height) {
  const View view{width, height, format.range_bits, format.subpixel_bits};
  const SnappedList list = snap(Geometry(scene, view).positions(), format);
  ObjectRaster raster(scene, format, width, height);
  std::size_t k = 0;
  int parts = 0;
  for (std::uint32_t n = 0; n < scene.instances.size(); ++n) {
    raster.triangles(n, [&](const SnappedTriangle& t, std::uint32_t number) {
      parts += part_of(number) != 0;
      if (k == list.triangles.size()) FAIL() << "more than " << k;
      const SnappedTriangle& expected = list.triangles[k++];
      ASSERT_TRUE(t.x == expected.x && t.y == expected.y && t.depth == expected.depth) << "triangle " << k;
    });
  }
  EXPECT_EQ(k, list.triangles.size());
  return parts;
}

TEST(ObjectRaster, TrianglesAreThoseOfGeometry) {
  const RasterFormat format{"static", 160, 120, 1 << 20, 8, 8, 24};
  int clipped = 0;
  for (const std::string& name : builtin_scene_names()) {
    SCOPED_TRACE(name);
    Scene scene = load_scene(name);
    expect_geometry(scene, format, 160, 120);
    // From so near that the near plane and the guard band cut it.
    const Viewpoint far_off = viewpoint(scene, 4 / 3.0);
    const DepthPlanes planes = depth_planes(scene, 4 / 3.0);
    Camera camera;
    camera.position = far_off.eye + (planes.near + 0.1 * (planes.far - planes.near)) * far_off.forward;
    camera.forward = far_off.forward;
    camera.up = far_off.up;
    camera.half_height = 1.2;
    camera.near = 0.02 * (planes.far - planes.near);
    scene.camera = camera;
    clipped += expect_geometry(scene, format, 160, 120);
  }
  EXPECT_GT(clipped, 100);
}

TEST(DepthPlanes, HoldOverTheTimesOfAnAnimation) {
  Scene first = load_scene("wheel_in_out", 0.2), second = load_scene("wheel_in_out", 0.9);
  const double aspect = 4 / 3.0;
  ASSERT_NE(viewpoint(first, aspect), viewpoint(second, aspect));
  const DepthPlanes planes = joined(depth_planes(first, aspect), depth_planes(second, aspect));
  EXPECT_EQ(planes.near, depth_planes(first, aspect).near);
  EXPECT_EQ(planes.far, depth_planes(second, aspect).far);
  first.depth_planes = second.depth_planes = planes;
  EXPECT_EQ(viewpoint(first, aspect), viewpoint(second, aspect));
  EXPECT_EQ(depth_planes(first, aspect).far, planes.far);
}

TEST(StaticObjects, RefuseWhatTheyCannotDo) {
  Scene scene = small_scene();
  EXPECT_THROW(StaticObjects(scene, format_of(0), kWidth, kHeight, {}), Error);
  EXPECT_THROW(StaticObjects(scene, format_of(24), kWidth, kHeight, options_of(0, {})), Error);
  StaticOptions few_bits;
  few_bits.object_bits = 4;  // 15 objects, and there are 17
  EXPECT_THROW(StaticObjects(scene, format_of(24), kWidth, kHeight, few_bits), Error);
  few_bits.object_bits = 5;
  StaticObjects ours(scene, format_of(24), kWidth, kHeight, few_bits);
  scene.instances.pop_back();
  EXPECT_THROW(ours.draw(), Error);
}

// --- the experiment ---

TEST(Crowd, KeepsItsNumberMovingAndInView) {
  CrowdOptions options;
  options.objects = 400;
  options.layers = 10;
  options.interval = 20;
  Crowd crowd(options), again(options);
  const RasterFormat format{"static", 160, 120, 1 << 20, 11, 8, 24};
  int starts = 0;
  std::vector<glm::dmat4> before(400);
  for (int frame = 0; frame < 400; ++frame) {
    const int wanted = frame < 200 ? 30 : 60;
    for (int n = 0; n < 400; ++n) before[n] = crowd.scene().instances[n].to_world;
    crowd.step(wanted);
    again.step(wanted);
    int moved = 0;
    for (int n = 0; n < 400; ++n) {
      moved += crowd.scene().instances[n].to_world != before[n];
      ASSERT_EQ(crowd.scene().instances[n].to_world, again.scene().instances[n].to_world);
    }
    ASSERT_EQ(moved, wanted);
    starts += frame > 0 && frame != 200 ? crowd.starts() : 0;
  }
  EXPECT_NEAR(starts, 400 * 45 / 20.0, 150);
  ObjectRaster raster(crowd.scene(), format, 160, 120);
  ObjectBuffer buffer(160, 120, full_depth(24));
  for (std::uint32_t n = 0; n < 400; ++n) {
    Box box;
    const Drawn drawn = raster.fragments(n, buffer.frame(), [&](int x, int y, std::uint32_t depth, std::uint32_t) {
      box.add(x, y);
      ASSERT_LT(depth, full_depth(24));
    });
    ASSERT_FALSE(box.empty()) << n;
    ASSERT_GT(drawn.triangles, 500u);
  }
  EXPECT_THROW(crowd.step(200), Error);
}

// The setup units set the pace of small triangles, so that their cycles add up to a frame, but for waits.
TEST(Crowd, CyclesOfAFrameAreThoseOfItsSetup) {
  CrowdOptions options;
  options.objects = 7;
  options.layers = 0.04;  // as large as in the experiment
  const Crowd crowd(options);
  const model::Configuration middle = model::find_configuration("middle");
  const RasterFormat format = model::raster_format(middle);
  SnappedList list = snap(project(crowd.scene(), {640, 480, format.range_bits, format.subpixel_bits}), format);
  const auto engine = model::make_engine("middle", 4);
  const model::Cycles modelled = model::model_cycles(middle.config(), *engine, list, render(list));
  const model::SetupModel model(middle.config(), 640, 480);
  std::uint64_t triangle_setup = 0, shade_setup = 0;
  for (const SnappedTriangle& t : list.triangles) {
    const model::SetupCycles cycles = model.cycles(t);
    triangle_setup += std::uint64_t(cycles.triangle_setup), shade_setup += std::uint64_t(cycles.shade_setup);
  }
  EXPECT_EQ(triangle_setup, modelled.triangle_setup);
  EXPECT_EQ(shade_setup, modelled.shade_setup);
  const double slowest = double(std::max(triangle_setup, shade_setup));
  std::printf("%zu triangles: %lu cycles of triangle setup, %lu of shade setup, %lu of the rasterizer; a frame %lu\n",
              list.triangles.size(), triangle_setup, shade_setup, modelled.raster, modelled.frame);
  EXPECT_LT(double(modelled.raster), 0.5 * slowest);
  EXPECT_NEAR(double(modelled.frame) / slowest, 1, 0.1);
}

}  // namespace
}  // namespace halfspace::ref
