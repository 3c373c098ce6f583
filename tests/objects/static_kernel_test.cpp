// SPDX-License-Identifier: Apache-2.0
// Static objects buffers by the kernels: each frame is, to the bit, the one that the same kernels draw of everything in
// one go, with any number of S-buffers, of lanes and of indices, with query and without; and shows the objects that the
// reference shows.
#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "model/drivers/static_frames.hpp"
#include "ref/error.hpp"
#include "ref/objects/object_raster.hpp"
#include "tests/config_path.hpp"
#include "vectors/frames/moving_scene.hpp"

namespace halfspace::tests {
namespace {

using model::RawEntry;
using model::StaticFrames;

constexpr int kWidth = 40, kHeight = 30, kObjects = 16;

struct Case {
  const char* base;
  int depth_bits, lanes, triangles, window, buffers;
  bool query;
  int frames;
};
std::string name_of(const Case& c) {
  return std::string(c.base) + ", depths of " + std::to_string(c.depth_bits) + " bits, " + std::to_string(c.lanes) +
         " lanes, " + std::to_string(c.triangles) + " indices, window " + std::to_string(c.window) + ", " +
         std::to_string(c.buffers) + " S-buffers, query " + std::to_string(c.query);
}

// All triangles of a scene have an index in one frame of the other.
constexpr int kEnough = 4000;
model::Configuration configuration(const Case& c, int triangles) {
  const std::string base = c.base;
  Config config = model::find_configuration(base.find('_') == std::string::npos ? base : config_path(base)).config();
  config.width = kWidth, config.height = kHeight;
  config.depth_bits = c.depth_bits;
  config.triangles = triangles;
  config.object_bits = 5;
  if (has_lighting(config)) config.materials = 32;
  return model::Configuration("static", config);
}

struct Counts {
  std::uint64_t states[4] = {}, frames = 0, new_views = 0, queries = 0, skipped = 0, erased = 0, redrawn = 0, runs = 0,
                run_cycles = 0;
  std::uint64_t passes = 0, frames_of_passes = 0;  // those that took more than one for what moves
  std::uint64_t moving_wins = 0, still_wins = 0;   // ties: pixels where both are as near, by who has the lesser number
  std::uint64_t compared = 0, too_near = 0, covered = 0;  // pixels, with the reference
};

struct Fragment {
  std::uint32_t depth = ~0u, object = 0, next = ~0u;  // the nearest; the depth of the nearest of another object
};

// Whom the picture shows. A depth of the kernels is off by less than half an LSB before it is rounded, so by one at
// most.
void expect_reference(const ref::Scene& scene, const model::Configuration& configuration,
                      const std::vector<RawEntry>& picture, Counts& counts) {
  ref::ObjectRaster raster(scene, model::raster_format(configuration), kWidth, kHeight);
  std::vector<Fragment> nearest(picture.size());
  for (std::uint32_t n = 0; n < scene.instances.size(); ++n) {
    raster.fragments(n, {0, 0, kWidth, kHeight}, [&](int x, int y, std::uint32_t depth, std::uint32_t) {
      Fragment& f = nearest[std::size_t(y * kWidth + x)];
      if (depth < f.depth) {
        if (f.object != n + 1) f.next = f.depth;
        f.depth = depth, f.object = n + 1;
      } else if (f.object != n + 1 && depth < f.next) {
        f.next = depth;
      }
    });
  }
  const std::uint32_t full = ref::full_depth(configuration.config().depth_bits);
  for (std::size_t at = 0; at < picture.size(); ++at) {
    const Fragment& f = nearest[at];
    if (f.object == 0) {
      ASSERT_EQ(picture[at].object, 0u) << "a pixel that nothing covers: " << at;
      ++counts.compared;
    } else if (f.depth + 1 < full && (f.next == ~0u || f.next - f.depth > 2)) {
      ASSERT_EQ(picture[at].object, f.object) << at;
      ASSERT_LE(picture[at].depth, f.depth + 1) << at;
      ASSERT_LE(f.depth, picture[at].depth + 1) << at;
      ++counts.compared, ++counts.covered;
    } else {
      ASSERT_TRUE(f.depth + 1 >= full || picture[at].object != 0) << at;
      ++counts.too_near;
    }
  }
}

// A triangle out of view: the middle of the scene stays where it is, wherever the others go.
void hold_middle(ref::Scene& scene) {
  ref::Mesh& mesh = scene.meshes.back();
  const std::uint32_t first = std::uint32_t(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), {{-40, -40, -40}, {40, 40, 40}, {40, 40, 40}});
  mesh.normals.resize(mesh.positions.size(), glm::dvec3(0, 0, 1));
  mesh.triangles.push_back({first, first + 1, first + 2});
}

void texture(ref::Scene& scene) {
  ref::Texture chequered;
  chequered.width = chequered.height = 8;
  for (int n = 0; n < 64; ++n)
    chequered.texels.push_back({std::uint8_t((n + n / 8) % 2 * 200 + 55), std::uint8_t(n * 4), 255});
  scene.textures = {chequered};
  for (ref::Material& material : scene.materials) material.texture = 0;
  for (ref::Mesh& mesh : scene.meshes) {
    for (const glm::dvec3& p : mesh.positions) mesh.texture_coordinates.emplace_back(p.x + 0.5, p.y + p.z + 0.5);
  }
}

void run(const Case& c, std::uint64_t seed, Counts& counts) {
  const model::Configuration small = configuration(c, c.triangles), large = configuration(c, kEnough);
  const bool lit = has_lighting(small.config());
  ref::Scene scene = model::moving_scene(kObjects);
  if (lit) hold_middle(scene);
  if (has_texture(small.config())) texture(scene);
  model::SceneMotion motion(seed, kObjects);
  motion.begin(scene);
  StaticFrames ours(scene, {small, c.lanes, kWidth, kHeight, c.buffers, c.query, c.window});
  const auto everything = model::make_engine(large, c.lanes);
  std::vector<std::uint32_t> all(scene.instances.size());
  for (std::uint32_t n = 0; n < all.size(); ++n) all[n] = n;
  std::uint64_t passes_of_frame = 0;
  model::StaticFramesSink sink;
  sink.run = [&](const char* what, const model::MergeInput& in) {
    if (what != std::string("frame") || !in.drawn) return;
    ++passes_of_frame;
    for (std::size_t at = 0; at < in.stored->size(); ++at) {
      const RawEntry &still = (*in.stored)[at], &moving = (*in.drawn)[at];
      if (still.object == 0 || moving.object == 0 || still.depth != moving.depth) continue;
      ++(moving.object < still.object ? counts.moving_wins : counts.still_wins);
    }
  };
  for (int frame = 0; frame < c.frames; ++frame) {
    motion.step(scene);
    motion.move_viewer(scene);
    if (motion.dim(scene) && !lit) ours.start_anew();
    passes_of_frame = 0;
    const model::StaticFrameWork& work = ours.draw(sink);
    const std::vector<RawEntry> whole = StaticFrames::entries(*everything, large, ours.triangles(all));
    for (std::size_t at = 0; at < whole.size(); ++at) {
      const RawEntry &got = ours.picture()[at], &want = whole[at];
      ASSERT_TRUE(got == want) << "frame " << frame << ", pixel " << at << ": depth " << got.depth << ", object "
                               << got.object << " of " << want.depth << ", " << want.object;
    }
    expect_reference(scene, large, ours.picture(), counts);
    if (testing::Test::HasFatalFailure()) FAIL() << "frame " << frame;
    // An S-buffer is the one that is drawn anew of what stands in it.
    for (int k = 0; frame % 5 == 0 && k < c.buffers; ++k) {
      std::vector<std::uint32_t> standing;
      for (const std::uint32_t n : all) {
        if (ours.states().is_static(n) && ours.states().buffer_of(n) == k) standing.push_back(n);
      }
      const auto rebuilt = StaticFrames::entries(*everything, large, ours.triangles(standing));
      for (std::size_t at = 0; ours.static_buffer(k) && at < rebuilt.size(); ++at) {
        ASSERT_TRUE((*ours.static_buffer(k))[at] == rebuilt[at])
            << "frame " << frame << ", S-buffer " << k << ", pixel " << at;
      }
    }
    for (const std::uint32_t n : all) ++counts.states[int(ours.states().state(n))];
    ASSERT_TRUE(!work.new_view || (work.moving == all.size() && work.added + work.redrawn + work.queries == 0));
    ASSERT_TRUE(c.query || work.queries == 0);
    ++counts.frames;
    counts.new_views += work.new_view, counts.queries += work.queries, counts.skipped += work.skipped,
        counts.erased += work.erased;
    counts.redrawn += work.redrawn, counts.runs += work.runs, counts.run_cycles += work.run_cycles,
        counts.passes += work.passes;
    counts.frames_of_passes += passes_of_frame > 1;
  }
}

void tell(const Counts& c) {
  std::printf(
      "%lu frames, %lu of a new view or light; SS %lu, SD %lu, DS %lu, DD %lu; %lu queries, %lu skipped, %lu erased, "
      "%lu redrawn\n",
      c.frames, c.new_views, c.states[0], c.states[1], c.states[2], c.states[3], c.queries, c.skipped, c.erased,
      c.redrawn);
  std::printf("%lu passes, %lu frames in several; %lu runs of %lu cycles; ties %lu to what moves, %lu to what stands\n",
              c.passes, c.frames_of_passes, c.runs, c.run_cycles, c.moving_wins, c.still_wins);
  std::printf("%lu pixels show the reference's object, %lu of them one; %lu are too near to tell\n", c.compared,
              c.covered, c.too_near);
}

TEST(StaticFrames, AreThoseOfDrawingEverything) {
  constexpr Case kCases[] = {{"low", 5, 1, 400, 0, 1, true, 800},         {"low", 5, 16, 40, 0, 3, true, 2000},
                             {"middle", 24, 4, 4000, 0, 1, false, 1500},  {"middle", 24, 16, 30, 0, 3, false, 1500},
                             {"middle", 24, 4, 100, 0, 1, true, 1500},    {"low", 5, 4, 20, 3, 3, true, 1500},
                             {"lit_low", 16, 4, 60, 0, 1, true, 1000},    {"middle", 24, 16, 25, 8, 7, true, 1500},
                             {"textured_low", 16, 2, 80, 0, 3, true, 500}};
  std::uint64_t frames = 0;
  for (const Case& c : kCases) {
    SCOPED_TRACE(name_of(c));
    Counts counts;
    run(c, 7 + std::uint64_t(&c - kCases), counts);
    if (HasFatalFailure()) return;
    std::printf("%s\n", name_of(c).c_str());
    tell(counts);
    for (const std::uint64_t count : counts.states) EXPECT_GT(count, 500u);
    EXPECT_GT(counts.new_views, 10u);
    EXPECT_GT(counts.erased, 100u);
    EXPECT_GT(counts.redrawn, 100u);
    EXPECT_EQ(counts.skipped > 50, c.query);
    EXPECT_EQ(counts.frames_of_passes > 100, c.triangles <= 40) << "how many take several passes";
    EXPECT_GT(counts.moving_wins, 1000u);
    EXPECT_GT(counts.still_wins, 1000u);
    EXPECT_GT(counts.covered, (counts.compared + counts.too_near) / 2);
    frames += counts.frames;
  }
  EXPECT_GT(frames, 10000u);
}

// A pass ends where the next triangle has no index, and not before.
TEST(Engine, FitsAsManyAsThereAreIndicesFor) {
  const Case c{"low", 16, 4, 20, 0, 1, true, 0};
  const model::Configuration few = configuration(c, c.triangles);
  ref::Scene scene = model::moving_scene(kObjects);
  model::SceneMotion motion(3, kObjects);
  std::vector<std::uint32_t> all(scene.instances.size());
  for (std::uint32_t n = 0; n < all.size(); ++n) all[n] = n;
  for (const int window : {0, 1, 3, 8}) {
    const auto engine = model::make_engine(few, c.lanes);
    engine->reuse_indices(window);
    std::size_t most = 0, cut = 0;
    for (int n = 0; n < 20; ++n) {
      motion.begin(scene);
      StaticFrames frames(scene, {few, c.lanes, kWidth, kHeight});
      frames.draw();
      model::NamedFrame frame = frames.triangles(all);
      engine->number(frame.objects);
      const std::size_t fits = engine->fits(frame.scene);
      ASSERT_GE(fits, std::size_t(c.triangles));
      most = std::max(most, fits);
      if (fits == frame.scene.triangles.size()) continue;
      ++cut;
      model::NamedFrame more = frame;
      frame.scene.triangles.resize(fits), frame.objects.resize(fits);
      EXPECT_NO_THROW(StaticFrames::entries(*engine, few, frame));
      EXPECT_EQ(engine->fits(frame.scene), fits);
      more.scene.triangles.resize(fits + 1), more.objects.resize(fits + 1);
      const auto another = model::make_engine(few, c.lanes);
      another->reuse_indices(window);
      EXPECT_THROW(StaticFrames::entries(*another, few, more), ref::Error);
    }
    EXPECT_EQ(most > std::size_t(c.triangles), window != 0);
    EXPECT_GT(cut, 10u) << window;
  }
}

TEST(StaticFrames, AreOfAConfigurationWithObjects) {
  ref::Scene scene = model::moving_scene(kObjects);
  const Case c{"low", 16, 4, 100, 0, 1, true, 0};
  EXPECT_THROW(StaticFrames(scene, {model::find_configuration("low"), 4, kWidth, kHeight}), ref::Error);
  EXPECT_THROW(StaticFrames(scene, {configuration(c, 100), 4, kWidth, kHeight, 0}), ref::Error) << "no S-buffer";
  EXPECT_NO_THROW(StaticFrames(scene, {configuration(c, 100), 4, kWidth, kHeight, 1}));
  Config few = configuration(c, 100).config();
  few.object_bits = 4;  // 15 objects, and there are 17
  EXPECT_THROW(StaticFrames(scene, {model::Configuration("few", few), 4, kWidth, kHeight}), ref::Error);
}

}  // namespace
}  // namespace halfspace::tests
