// SPDX-License-Identifier: Apache-2.0
// The reference against arithmetic that is done another way, and against files that are wrong.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <sstream>

#include "ref/error.hpp"
#include "ref/geometry/geometry.hpp"
#include "ref/raster/raster.hpp"

namespace halfspace::ref {
namespace {

const RasterFormat kLow{"low", 320, 200, 4096, 10, 4, 16};
const RasterFormat kMiddle{"middle", 640, 480, 16384, 11, 8, 24};
const RasterFormat kHigh{"high", 1920, 1080, 262144, 14, 8, 24};
const std::vector<RasterFormat> kAll{kLow, kMiddle, kHigh};
const std::string kModels = HALFSPACE_TESTMODELS "/";

View view_of(const RasterFormat& format) {
  return {format.width, format.height, format.range_bits, format.subpixel_bits};
}

// The sentence of the Error that `what` ends in; a text that no test expects if it does not.
template <class What>
std::string refusal(What&& what) {
  try {
    what();
  } catch (const Error& error) {
    const std::string sentence = error.what();
    EXPECT_EQ(sentence.find('\n'), sentence.npos) << sentence;
    return sentence;
  }
  return "(not refused)";
}

void expect_in(const std::string& part, const std::string& text) {
  EXPECT_NE(text.find(part), text.npos) << "expected '" << part << "' in: " << text;
}

class TemporaryFile {
 public:
  TemporaryFile(const std::string& name, const std::string& text)
      : path_(::testing::TempDir() + "halfspace_ref_" + name) {
    std::ofstream(path_, std::ios::binary) << text;
  }
  ~TemporaryFile() { std::filesystem::remove(path_); }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

std::size_t covered(const Frame& frame) {
  return frame.index.size() - std::count(frame.index.begin(), frame.index.end(), 0u);
}

Frame render_file(const std::string& path, double time = 0) {
  return render(snap(project(load_scene(path, time), {640, 480, kHigh.range_bits, kHigh.subpixel_bits}), kHigh));
}

// --- triangles at random, in sub-pixels ---

using Random = std::mt19937;
int pick(Random& random, int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); }

SnappedTriangle random_triangle(Random& random, int reach, int depth_bits) {
  SnappedTriangle t;
  for (int v = 0; v < 3; ++v) {
    t.x[v] = pick(random, -reach, reach), t.y[v] = pick(random, -reach, reach);
    t.depth[v] = static_cast<std::uint32_t>(random() & full_depth(depth_bits));
    for (auto& channel : t.rgb[v]) channel = static_cast<std::uint8_t>(random());
  }
  if (random() % 3 == 0) {  // a sliver
    t.x[2] = t.x[0] + (t.x[1] - t.x[0]) / 3 + pick(random, -2, 2);
    t.y[2] = t.y[0] + (t.y[1] - t.y[0]) / 3 + pick(random, -2, 2);
  }
  return t;
}

SnappedList list_of(const RasterFormat& format, int width, int height, std::vector<SnappedTriangle> triangles) {
  return {format, width, height, {1, 2, 3}, std::move(triangles)};
}

// --- built-in scenes ---

double area(const Mesh& mesh, const std::array<std::uint32_t, 3>& t) {
  const auto& p = mesh.positions;
  return glm::length(glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]])) / 2;
}

TEST(Scenes, TeapotIsNewells) {
  const Mesh mesh = load_scene("teapot").meshes.at(0);
  EXPECT_EQ(mesh.triangles.size(), 3136u);
  EXPECT_EQ(std::count_if(mesh.triangles.begin(), mesh.triangles.end(), [&](auto& t) { return area(mesh, t) < 1e-12; }),
            56);
}

TEST(Scenes, WindingsAndNormalsPointOutward) {
  for (const std::string& name : builtin_scene_names()) {
    const Scene scene = load_scene(name);
    for (const Mesh& mesh : scene.meshes) {
      for (const auto& t : mesh.triangles) {
        if (area(mesh, t) < 1e-12) continue;
        const auto& p = mesh.positions;
        const glm::dvec3 face = glm::normalize(glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]));
        for (const std::uint32_t i : t) {
          EXPECT_NEAR(glm::length(mesh.normals[i]), 1, 1e-9) << name;
          ASSERT_GT(glm::dot(face, mesh.normals[i]), 0.1) << name << " vertex " << i;
        }
      }
    }
  }
}

TEST(Scenes, SolidsAreClosedAndOutsideOut) {
  using Place = std::array<long, 3>;
  const auto place = [](const glm::dvec3& p) {
    return Place{std::lround(p.x * 1e6), std::lround(p.y * 1e6), std::lround(p.z * 1e6)};
  };
  for (const char* name : {"cube", "pyramid", "ring", "wheel"}) {
    for (const Mesh& mesh : load_scene(name).meshes) {
      std::map<std::pair<Place, Place>, int> balance;
      double volume = 0;
      for (const auto& t : mesh.triangles) {
        const auto& p = mesh.positions;
        volume += glm::dot(p[t[0]], glm::cross(p[t[1]], p[t[2]])) / 6;
        for (int i = 0; i < 3; ++i) {
          const Place from = place(p[t[i]]), to = place(p[t[(i + 1) % 3]]);
          from < to ? ++balance[{from, to}] : --balance[{to, from}];
        }
      }
      EXPECT_GT(volume, 0) << name << " " << mesh.name;
      for (const auto& [edge, count] : balance) ASSERT_EQ(count, 0) << name << " " << mesh.name;
    }
  }
}

TEST(Scenes, AllFitAllConfigurationsAndTheFrame) {
  for (const std::string& name : builtin_scene_names()) {
    for (const RasterFormat& format : kAll) {
      const TriangleList list = project(load_scene(name), view_of(format));
      for (const auto& triangle : list.triangles) {
        for (const Vertex& v : triangle) {
          ASSERT_TRUE(v.x >= 0 && v.x <= format.width && v.y >= 0 && v.y <= format.height)
              << name << " " << format.name;
          ASSERT_TRUE(v.z > 0 && v.z < 1) << name;
        }
      }
      const double share = double(covered(render(snap(list, format)))) / (format.width * format.height);
      EXPECT_GT(share, 0.2) << name << " " << format.name;
    }
  }
}

TEST(Scenes, CastleHidesMuchOfItself) {
  const TriangleList list = project(load_scene("castle"), view_of(kMiddle));
  EXPECT_GE(list.triangles.size(), 2000u);
  EXPECT_LE(list.triangles.size(), 4095u);
  const Frame frame = render(snap(list, kMiddle));
  EXPECT_GT(std::count(frame.visible.begin(), frame.visible.end(), false), 300);
}

// --- .tri ---

TEST(Tri, RoundTripsToTheBit) {
  Random random(1);
  std::uniform_real_distribution<double> position(-3000, 3000), unit(0, 1);
  TriangleList list{640, 480, {10, 20.5, 30}, {}};
  for (int k = 0; k < 500; ++k) {
    auto& triangle = list.triangles.emplace_back();
    for (Vertex& v : triangle) {
      v = {position(random), position(random), unit(random), 255 * unit(random), 255 * unit(random), 0};
    }
  }
  std::ostringstream text;
  write_tri(text, list);
  const TemporaryFile file("round_trip.tri", text.str());
  const TriangleList back = read_tri(file.path());
  EXPECT_EQ(back.background, list.background);
  ASSERT_EQ(back.triangles.size(), list.triangles.size());
  for (std::size_t k = 0; k < list.triangles.size(); ++k) {
    for (int i = 0; i < 3; ++i) {
      const Vertex &a = list.triangles[k][i], &b = back.triangles[k][i];
      ASSERT_TRUE(a.x == b.x && a.y == b.y && a.z == b.z && a.r == b.r && a.g == b.g && a.b == b.b);
    }
  }
}

TEST(Tri, WritesWhatThePageSays) {
  std::ostringstream text;
  write_tri(text, {2, 1, {0, 0, 0}, {{{{0, 0.5, 1, 255, 0, 1}, {-8, 0, 0, 1, 2, 3}, {4, 4, 0.25, 4, 5, 6}}}}});
  EXPECT_EQ(text.str(), "size 2 1\nt 0 0.5 1 255 0 1  -8 0 0 1 2 3  4 4 0.25 4 5 6\n");
}

TEST(Tri, TakesCommentsAndBlankLines) {
  const TemporaryFile file("comments.tri", "# a\r\n\n  size 4 3 # b\n\tt 0 0 0 1 2 3  1 0 0.5 1 2 3  0 1 1 1 2 3");
  const TriangleList list = read_tri(file.path());
  EXPECT_EQ(list.width, 4);
  EXPECT_EQ(list.height, 3);
  EXPECT_EQ(list.triangles.size(), 1u);
}

TEST(Tri, RefusesWithFileAndLine) {
  const std::string good = "t 0 0 0 1 2 3  1 0 0 1 2 3  0 1 0 1 2 3\n";
  const auto vertex = [](const std::string& text) { return "size 4 4\nt " + text + "  1 0 0 1 2 3  0 1 0 1 2 3\n"; };
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "empty"},
      {good, ":1: 't' comes before the line 'size W H'"},
      {"# nothing\n", "no line 'size W H'"},
      {"size 4 4\n", "no triangles"},
      {"size 4\n", ":1: 1 numbers where 2 are needed"},
      {"size 0 4\n", ":1: field 2: width = 0 is outside"},
      {"size 4 -4\n", "height = -4 is outside"},
      {"size 4 1000000\n", "height = 1000000 is outside"},
      {"size 4 4.5\n", "not whole"},
      {"size 4 4\nsize 4 4\n", ":2: a second line 'size'"},
      {"size 4 4\nbackground 0 0 256\n", ":2: field 4: colour = 256 is outside"},
      {"size 4 4\nt 1 2 3\n", ":2: 3 numbers where 18 are needed"},
      {"size 4 4\n" + good + "t 1 2 3", ":3: the file ends in the middle of a line (3 numbers of 18)"},
      {"size 4 4\n" + good.substr(0, good.size() - 1) + " 7\n", "19 numbers where 18 are needed"},
      {vertex("0 0 zero 1 2 3"), ":2: field 4: 'zero' is not a number"},
      {vertex("0x 0 0 1 2 3"), "'0x' is not a number"},
      {vertex("nan 0 0 1 2 3"), ":2: field 2: 'nan' is not finite"},
      {vertex("0 -inf 0 1 2 3"), "'-inf' is not finite"},
      {vertex("1e999 0 0 1 2 3"), "beyond a double"},
      {vertex("0 0 1.01 1 2 3"), "z = 1.01 is outside [0, 1]"},
      {vertex("0 0 0 1 256 3"), "g = 256 is outside [0, 255]"},
      {vertex("0 0 0 -1 2 3"), "r = -1 is outside [0, 255]"},
      {std::string("size 4 4\n\x01\xff\0 garbage\n", 20), ":2: "},
  };
  for (const auto& [text, expected] : cases) {
    const TemporaryFile file("bad.tri", text);
    const std::string sentence = refusal([&] { read_tri(file.path()); });
    expect_in(expected, sentence);
    expect_in(file.path(), sentence);
  }
  expect_in("cannot be opened", refusal([] { read_tri("/nowhere/x.tri"); }));
  expect_in("is a folder", refusal([] { read_tri("/"); }));
}

// --- snapping ---

TriangleList one_vertex(double x, double y, double z = 0, double colour = 0) {
  return {8, 8, {0, 0, 0}, {{{{x, y, z, colour, 0, 0}, {1, 2, 0, 0, 0, 0}, {3, 4, 0, 0, 0, 0}}}}};
}

TEST(Snap, TiesGoToEven) {
  const double half = 1.0 / 32;  // of a sub-pixel of low
  const double cases[][2] = {{half, 0},
                             {3 * half, 2},
                             {5 * half, 2},
                             {-half, 0},
                             {-3 * half, -2},
                             {2 * half, 1},
                             {std::nextafter(half, 1), 1}};
  for (const auto& [pixels, expected] : cases) {
    const SnappedTriangle t = snap(one_vertex(pixels, -pixels), kLow).triangles[0];
    EXPECT_EQ(t.x[0], expected);
    EXPECT_EQ(t.y[0], -expected);
  }
}

TEST(Snap, DepthAndColourReachTheirEnds) {
  const SnappedTriangle t = snap(one_vertex(0, 0, 1, 254.5), kLow).triangles[0];
  EXPECT_EQ(t.depth[0], 65535u);
  EXPECT_EQ(t.rgb[0][0], 255);
  EXPECT_EQ(snap(one_vertex(0, 0, 0.5), kMiddle).triangles[0].depth[0], 8388608u);
}

TEST(Snap, RefusesAndNamesWhatFits) {
  TriangleList list = one_vertex(0, 0);
  list.width = 640;
  expect_in("640x8 pixels does not fit configuration low", refusal([&] { snap(list, kLow, kAll); }));
  expect_in("configuration middle takes it", refusal([&] { snap(list, kLow, kAll); }));
  list.height = 2000;
  expect_in("no configuration takes it", refusal([&] { snap(list, kLow, kAll); }));

  list = one_vertex(0, 0);
  list.triangles.resize(20000, list.triangles[0]);
  expect_in("20000 triangles do not fit configuration low, which takes 4096; configuration high takes it",
            refusal([&] { snap(list, kLow, kAll); }));

  snap(one_vertex(-512, 511.96), kLow);
  expect_in("triangle 1, vertex 0: y = 511.97", refusal([] { snap(one_vertex(0, 511.97), kLow, kAll); }));
  expect_in("[-512, 512) pixels; configuration middle takes it", refusal([] { snap(one_vertex(512, 0), kLow, kAll); }));
  expect_in("x = -512.1", refusal([] { snap(one_vertex(-512.1, 0), kLow); }));
  expect_in("x = 1e+300", refusal([] { snap(one_vertex(1e300, 0), kHigh, kAll); }));
}

TEST(Snap, UnsnapIsItsInverse) {
  Random random(2);
  for (const RasterFormat& format : kAll) {
    std::vector<SnappedTriangle> triangles;
    for (int k = 0; k < 1000; ++k) triangles.push_back(random_triangle(random, 2000, format.depth_bits));
    const SnappedList list = list_of(format, 64, 64, triangles), back = snap(unsnap(list), format);
    EXPECT_EQ(back.background, list.background);
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      const SnappedTriangle &a = list.triangles[k], &b = back.triangles[k];
      ASSERT_TRUE(a.x == b.x && a.y == b.y && a.depth == b.depth && a.rgb == b.rgb);
    }
  }
}

// --- the rasterizer ---

__extension__ typedef __int128 Wide;

// The same plane as a mean of the vertices, weighted by the areas opposite of them: no gradients.
Wide weighted(const SnappedTriangle& t, const std::array<std::int64_t, 3>& value, std::int64_t px, std::int64_t py,
              std::int64_t* area) {
  Wide sum = 0;
  *area = 0;
  for (int i = 0; i < 3; ++i) {
    const int a = (i + 1) % 3, b = (i + 2) % 3;
    const std::int64_t weight = (t.x[a] - px) * (t.y[b] - py) - (t.y[a] - py) * (t.x[b] - px);
    sum += Wide(weight) * value[i];
    *area += weight;
  }
  if (*area < 0) sum = -sum, *area = -*area;
  return sum;
}

TEST(Raster, IsTheSameAsPixelByPixel) {
  Random random(3);
  constexpr int kSide = 40, kBits = 8;
  std::vector<SnappedTriangle> triangles;
  for (int k = 0; k < 600; ++k) triangles.push_back(random_triangle(random, k % 2 ? 12000 : 260000, 24));
  const SnappedList list = list_of(kMiddle, kSide, kSide, triangles);
  const Frame frame = render(list);
  std::vector<bool> visible(triangles.size(), false);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const std::int64_t px = x * 256 + 128, py = y * 256 + 128;
      std::int64_t depth = full_depth(24), area;
      std::uint32_t index = 0;
      for (std::uint32_t k = 1; k <= triangles.size(); ++k) {
        const SnappedTriangle& t = triangles[k - 1];
        if (!covers(t, kBits, x, y)) continue;
        const Wide sum = weighted(t, {t.depth[0], t.depth[1], t.depth[2]}, px, py, &area);
        const auto fragment = static_cast<std::int64_t>((2 * sum + area) / (2 * Wide(area)));
        if (fragment < depth) depth = fragment, index = k, visible[k - 1] = true;
      }
      const std::size_t at = std::size_t(y) * kSide + x;
      ASSERT_EQ(frame.index[at], index) << x << ", " << y;
      ASSERT_EQ(frame.depth[at], depth) << x << ", " << y;
      if (index == 0) continue;
      const SnappedTriangle& t = triangles[index - 1];
      for (int c = 0; c < 3; ++c) {
        const Wide sum = weighted(t, {t.rgb[0][c], t.rgb[1][c], t.rgb[2][c]}, px, py, &area);
        ASSERT_EQ(frame.colour[at][c], static_cast<int>((2 * sum + area) / (2 * Wide(area))));
        ASSERT_NEAR(frame.exact_colour[at][c], double(sum) / double(area), 1e-9);
      }
      ASSERT_LE(std::abs(frame.exact_depth[at] - double(depth)), 0.5 + 1e-6);
    }
  }
  EXPECT_EQ(frame.visible, visible);
}

TEST(Raster, AnyOrderOfTheVerticesIsTheSameTriangle) {
  Random random(4);
  for (int k = 0; k < 300; ++k) {
    const SnappedTriangle t = random_triangle(random, 6000, 24);
    const Frame first = render(list_of(kMiddle, 24, 24, {t}));
    std::array<int, 3> order{0, 1, 2};
    while (std::next_permutation(order.begin(), order.end())) {
      SnappedTriangle turned;
      for (int v = 0; v < 3; ++v) {
        const int from = order[v];
        turned.x[v] = t.x[from], turned.y[v] = t.y[from], turned.depth[v] = t.depth[from], turned.rgb[v] = t.rgb[from];
      }
      const Frame frame = render(list_of(kMiddle, 24, 24, {turned}));
      ASSERT_EQ(frame.index, first.index);
      ASSERT_EQ(frame.depth, first.depth);
      ASSERT_EQ(frame.colour, first.colour);
    }
  }
}

// Corners on a jittered grid, many of them on pixel centres, with the border straight: every centre belongs
// to one.
TEST(Raster, MeshHasNoHolesAndNoDoubles) {
  Random random(5);
  for (int run = 0; run < 20; ++run) {
    constexpr int kCells = 12, kCell = 4 * 16, kSide = kCells * kCell / 16;
    std::array<std::int32_t, 2> corner[kCells + 1][kCells + 1];
    for (int i = 0; i <= kCells; ++i) {
      for (int j = 0; j <= kCells; ++j) {
        const int step = run % 2 ? 1 : 8;
        const auto jitter = [&](int at) { return at == 0 || at == kCells ? 0 : pick(random, -2, 2) * step; };
        corner[i][j] = {j * kCell + jitter(j), i * kCell + jitter(i)};
      }
    }
    std::vector<int> count(kSide * kSide, 0);
    for (int i = 0; i < kCells; ++i) {
      for (int j = 0; j < kCells; ++j) {
        const auto &a = corner[i][j], &b = corner[i][j + 1], &c = corner[i + 1][j + 1], &d = corner[i + 1][j];
        const SnappedTriangle pair[2] = {{{a[0], b[0], c[0]}, {a[1], b[1], c[1]}, {}, {}},
                                         {{a[0], d[0], c[0]}, {a[1], d[1], c[1]}, {}, {}}};
        for (const SnappedTriangle& t : pair) {
          const Frame frame = render(list_of(kLow, kSide, kSide, {t}));
          for (std::size_t at = 0; at < count.size(); ++at) count[at] += frame.index[at] != 0;
        }
      }
    }
    ASSERT_EQ(std::count(count.begin(), count.end(), 1), kSide * kSide) << "run " << run;
  }
}

SnappedTriangle whole_frame(std::uint32_t depth) {
  return {{-1000, 8000, -1000}, {-1000, -1000, 8000}, {depth, depth, depth}, {{{9, 9, 9}, {9, 9, 9}, {9, 9, 9}}}};
}

TEST(Raster, EqualDepthsComeBackAndTheFirstWins) {
  const Frame frame =
      render(list_of(kMiddle, 8, 8, {whole_frame(1234567), whole_frame(1234567), whole_frame(1234566)}));
  EXPECT_EQ(frame.index, std::vector<std::uint32_t>(64, 3));
  EXPECT_EQ(frame.depth, std::vector<std::uint32_t>(64, 1234566));
  EXPECT_EQ(frame.visible, (std::vector<bool>{true, false, true}));
  EXPECT_EQ(frame.exact_depth, std::vector<double>(64, 1234566));
  EXPECT_EQ(frame.exact_colour[0], (std::array<double, 3>{9, 9, 9}));
}

TEST(Raster, FullDepthIsNeverDrawn) {
  const Frame frame = render(list_of(kMiddle, 8, 8, {whole_frame(full_depth(24))}));
  EXPECT_EQ(covered(frame), 0u);
  EXPECT_EQ(frame.visible, std::vector<bool>{false});
  EXPECT_EQ(frame.depth[0], full_depth(24));
  EXPECT_EQ(frame.colour[0], (std::array<std::uint8_t, 4>{1, 2, 3, 255}));
  EXPECT_EQ(covered(render(list_of(kMiddle, 8, 8, {whole_frame(full_depth(24) - 1)}))), 64u);
}

TEST(Raster, NoAreaDrawsNothing) {
  SnappedTriangle t = whole_frame(0);
  t.x[2] = t.x[0], t.y[2] = t.y[0];
  EXPECT_EQ(covered(render(list_of(kMiddle, 8, 8, {t}))), 0u);
  EXPECT_FALSE(covers(t, 8, 0, 0));
}

// --- geometry ---

Scene scene_of(Mesh mesh, const Camera& camera) {
  Scene scene;
  mesh.normals.assign(mesh.positions.size(), {0, 0, 1});
  scene.meshes = {std::move(mesh)};
  scene.materials.emplace_back();
  scene.materials[0].two_sided = true;
  scene.instances = {{0, glm::dmat4(1)}};
  scene.camera = camera;
  return scene;
}

TEST(Geometry, GroundThatReachesBehindTheViewerEndsAtTheHorizon) {
  Mesh ground;
  ground.positions = {{0, -1, 5000}, {60000, -1, -60000}, {-60000, -1, -60000}};
  ground.triangles = {{0, 1, 2}};
  Camera camera;
  camera.half_height = 0.5, camera.near = 0.1, camera.far = 100000;
  for (const RasterFormat& format : kAll) {
    const Frame frame = render(snap(project(scene_of(ground, camera), view_of(format)), format));
    for (int y = 0; y < format.height; ++y) {
      for (int x = 0; x < format.width; ++x) {
        if (std::abs(y + 0.5 - format.height / 2.0) < 1) continue;
        ASSERT_EQ(frame.index[std::size_t(y) * format.width + x] != 0, y > format.height / 2)
            << format.name << " " << x << ", " << y;
      }
    }
  }
}

double distance_to_line(const Vertex& a, const Vertex& b, double x, double y) {
  return std::abs((b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x)) / std::hypot(b.x - a.x, b.y - a.y);
}

// Corners made by clipping are snapped like others, which turns an edge by less than a sub-pixel; all else is
// the same.
TEST(Geometry, GuardBandDoesNotChangeTheFrame) {
  Random random(6);
  Camera camera;
  camera.orthographic = true;
  camera.half_width = 320, camera.half_height = 240, camera.near = 1, camera.far = 3;
  const View narrow = view_of(kMiddle), wide{640, 480, 14, 8};
  RasterFormat wide_format = kMiddle;
  wide_format.range_bits = 14;
  int clipped = 0;
  for (int k = 0; k < 100; ++k) {
    Mesh mesh;
    for (int v = 0; v < 3; ++v) mesh.positions.emplace_back(pick(random, -4000, 4000), pick(random, -4000, 4000), -2);
    mesh.triangles = {{0, 1, 2}};
    const Scene scene = scene_of(mesh, camera);
    TriangleList whole, parts;
    try {
      whole = project(scene, wide), parts = project(scene, narrow);
    } catch (const Error&) {
      continue;  // beside the frame
    }
    clipped += parts.triangles.size() > 1;
    ASSERT_EQ(whole.triangles.size(), 1u);
    const auto& t = whole.triangles[0];
    const Frame a = render(snap(whole, wide_format)), b = render(snap(parts, kMiddle));
    for (std::size_t at = 0; at < a.index.size(); ++at) {
      if ((a.index[at] != 0) == (b.index[at] != 0)) continue;
      const double x = at % 640 + 0.5, y = double(at / 640) + 0.5;
      ASSERT_LT(std::min({distance_to_line(t[0], t[1], x, y), distance_to_line(t[1], t[2], x, y),
                          distance_to_line(t[2], t[0], x, y)}),
                1.0 / 128);
    }
  }
  EXPECT_GT(clipped, 20);
}

TEST(Geometry, GuardBandIsExactWhereCornersFallOnTheGrid) {
  Mesh mesh;
  mesh.positions = {{-310, 230, -2}, {3000, 230, -2}, {-310, -3080, -2}};
  mesh.triangles = {{0, 1, 2}};
  Camera camera;
  camera.orthographic = true;
  camera.half_width = 320, camera.half_height = 240, camera.near = 1, camera.far = 3;
  const TriangleList list = project(scene_of(mesh, camera), view_of(kMiddle));
  EXPECT_GT(list.triangles.size(), 1u);
  EXPECT_EQ(covered(render(snap(list, kMiddle))), std::size_t(630 * 470));
}

TEST(Geometry, MirrorsKeepTheirOutside) {
  Scene scene = load_scene("cube");
  const std::size_t faces = project(scene, view_of(kMiddle)).triangles.size();
  scene.instances[0].to_world[0] *= -1;
  EXPECT_EQ(project(scene, view_of(kMiddle)).triangles.size(), faces);
  scene.meshes[0].triangles = {{0, 2, 1}};  // the face on the left, inside out: seen
  scene.instances[0].to_world = glm::dmat4(1);
  EXPECT_EQ(project(scene, view_of(kMiddle)).triangles.size(), 1u);
  std::swap(scene.meshes[0].triangles[0][1], scene.meshes[0].triangles[0][2]);
  expect_in("cube: no triangle faces the camera", refusal([&] { project(scene, view_of(kMiddle)); }));
}

// Light, viewer and normal on one line: I = Ia Ka + Ii (Kd + Ks).
TEST(Geometry, LightingIsPhongs) {
  Mesh mesh;
  mesh.positions = {{0, 0, -2}, {1e-3, 0, -2}, {0, 1e-3, -2}};
  mesh.colours.assign(3, {1, 0.5, 1});
  mesh.triangles = {{0, 1, 2}};
  Camera camera;
  camera.half_height = 0.001;
  Scene scene = scene_of(mesh, camera);
  scene.materials[0].ambient = glm::dvec3(0.5);
  scene.materials[0].diffuse = glm::dvec3(0.4, 0.4, 0.9);
  scene.materials[0].specular = glm::dvec3(0.2);
  scene.materials[0].shininess = 10;
  scene.ambient = glm::dvec3(0.2);
  scene.lights.emplace_back();
  const Vertex v = project(scene, view_of(kMiddle)).triangles.at(0)[0];
  EXPECT_NEAR(v.r, 255 * (0.2 * 0.5 + 0.4 + 0.2), 1e-3);
  EXPECT_NEAR(v.g, 255 * (0.2 * 0.5 * 0.5 + 0.4 * 0.5 + 0.2), 1e-3);
  EXPECT_EQ(v.b, 255);
  scene.lights[0].direction = {0, 0, 1};  // from behind
  EXPECT_NEAR(project(scene, view_of(kMiddle)).triangles.at(0)[0].r, 255 * 0.2 * 0.5, 1e-9);
}

// --- files ---

TEST(Files, RealOnesAreDrawn) {
  for (const char* name :
       {"OBJ/spider.obj", "glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb", "Collada/duck.dae",
        "Collada/cube_UTF8BOM.dae", "Collada/cameras.dae", "OBJ/cube_with_vertexcolors.obj", "PLY/cube.ply",
        "STL/Spider_binary.stl", "3DS/CameraRollAnim.3ds", "FBX/spider.fbx"}) {
    const std::string path = kModels + name;
    ASSERT_TRUE(std::filesystem::exists(path)) << path;
    try {
      const double share = double(covered(render_file(path))) / (640 * 480);
      EXPECT_GT(share, 0.02) << name;
    } catch (const Error& error) {
      ADD_FAILURE() << error.what();
    }
  }
}

TEST(Files, AnimationsMoveNodesAndBones) {
  for (const char* name : {"Collada/box_nested_animation.dae", "glTF2/simple_skin/simple_skin.gltf"}) {
    const Frame a = render_file(kModels + name), b = render_file(kModels + name, 1.2),
                again = render_file(kModels + name);
    EXPECT_EQ(a.index, again.index) << name;
    EXPECT_NE(a.depth, b.depth) << name;
  }
}

// One end of its cube has been moved by a target; its keys are 1/30 s apart, and lines lie between them.
TEST(Files, AnimationsMorphMeshes) {
  const std::string path = kModels + "glTF2/glTF-Sample-Models/AnimatedMorphCube-glTF/AnimatedMorphCube.gltf";
  const Scene still = load_scene(path);
  EXPECT_NEAR(still.duration, 4.2, 1e-3);
  const auto lowest = [](const Scene& scene) {
    double y = 1e9;
    const Mesh& mesh = scene.meshes[scene.instances[0].mesh];
    for (const auto& corner : mesh.triangles) {
      for (const std::uint32_t i : corner) y = std::min(y, mesh.positions[i].y);
    }
    return y;
  };
  EXPECT_NEAR(lowest(still), -0.01, 1e-6);
  // Weights of the first target, from the file.
  const double at_13 = lowest(load_scene(path, 13 / 30.0)), at_39 = lowest(load_scene(path, 39 / 30.0));
  EXPECT_NEAR(at_13, -0.01 + 0.18032 * 0.01893253, 1e-5);
  EXPECT_NEAR(at_39, -0.01 + 0.907715 * 0.01893253, 1e-5);
  const double at_14 = lowest(load_scene(path, 14 / 30.0));
  EXPECT_NEAR(lowest(load_scene(path, 13.5 / 30.0)), (at_13 + at_14) / 2, 1e-6);
  EXPECT_LT(covered(render_file(path, 3)), covered(render_file(path)));
}

// A triangle, and a camera that goes from (0, 0, 5) to (0, 0, 10) in a second.
TEST(Files, AnimationsMoveCameras) {
  const TemporaryFile file(
      "camera.gltf",
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],"nodes":[{"mesh":0,"name":"face"},{")"
      R"(camera":0,"name":"eye","translation":[0,0,5]}],"cameras":[{"type":"perspective","perspective":{"yfov)"
      R"(":0.8,"aspectRatio":1,"znear":0.1,"zfar":100}}],"meshes":[{"primitives":[{"attributes":{"POSITION":0)"
      R"(}}]}],"buffers":[{"byteLength":68,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPw)"
      R"(AAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAgD8AAAAAAAAAAAAAoEAAAAAAAAAAAAAAIEE="}],"bufferViews":[{"buffer":0)"
      R"(,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":8},{"buffer":0,"byteOffset":44,"byteLengt)"
      R"(h":24}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max)"
      R"(":[1,1,0]},{"bufferView":1,"componentType":5126,"count":2,"type":"SCALAR","min":[0],"max":[1]},{"buf)"
      R"(ferView":2,"componentType":5126,"count":2,"type":"VEC3"}],"animations":[{"channels":[{"sampler":0,"t)"
      R"(arget":{"node":1,"path":"translation"}}],"samplers":[{"input":1,"output":2}]}]})");
  for (const double seconds : {0.0, 0.25, 1.0, 2.0}) {
    const Scene scene = load_scene(file.path(), seconds);
    ASSERT_TRUE(scene.camera);
    EXPECT_NEAR(scene.camera->position.z, 5 + 5 * std::min(seconds, 1.0), 1e-6);
  }
  EXPECT_GT(covered(render_file(file.path())), 3 * covered(render_file(file.path(), 1)));
}

TEST(Files, InvalidOnesAreRefused) {
  for (const char* name :
       {"invalid/empty.obj", "invalid/empty.off", "invalid/empty.ply", "invalid/empty.3ds", "invalid/empty.x",
        "invalid/OutOfMemory.off", "invalid/malformed.obj", "glTF2/MissingBin/BoxTextured.gltf",
        "glTF2/IndexOutOfRange/IndexOutOfRange.gltf", "glTF2/RecursiveNodes/RecursiveNodes.gltf"}) {
    expect_in(kModels + name + ": ", refusal([&] { render_file(kModels + name); }));
  }
}

TEST(Files, WrongOnesAreRefusedWithTheirPlace) {
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "empty"},
      {"v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a coordinate is NaN or infinite"},
      {"v 0 inf 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a coordinate is NaN or infinite"},
      {triangle + "f 1 2 9\n", "cannot be read as a mesh"},
      {triangle, "cannot be read as a mesh"},
      {triangle + "l 1 2\n", "cannot be read as a mesh"},
      {"this is not a mesh\n", "cannot be read as a mesh"},
  };
  for (const auto& [text, expected] : cases) {
    const TemporaryFile file("bad.obj", text);
    const std::string sentence = refusal([&] { load_scene(file.path()); });
    expect_in(expected, sentence);
    expect_in(file.path(), sentence);
  }
  expect_in("cannot be opened", refusal([] { load_scene("teapt"); }));
  expect_in("is a folder", refusal([] { load_scene("/"); }));
}

TEST(Files, CutOnesAreRefused) {
  std::ifstream whole(kModels + "glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb", std::ios::binary);
  std::ostringstream bytes;
  bytes << whole.rdbuf();
  ASSERT_GT(bytes.str().size(), 10000u);
  for (const std::size_t size : {std::size_t(3), std::size_t(200), bytes.str().size() / 2}) {
    const TemporaryFile file("cut.glb", bytes.str().substr(0, size));
    expect_in("cannot be read as a mesh", refusal([&] { load_scene(file.path()); }));
  }
}

TEST(Files, HeadersThatPromiseTooMuchAreRefused) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_index\nend_header\n0 0 0\n1 0 0\n0 1 0\n";
  const TemporaryFile whole("whole.ply", ply + "3 0 1 2\n"), cut("cut.ply", ply),
      headless("headless.ply", ply.substr(0, 60));
  EXPECT_EQ(load_scene(whole.path()).framing.size(), 3u);
  expect_in("announces 4 elements, but only 3 lines follow", refusal([&] { load_scene(cut.path()); }));
  expect_in("the header has no end", refusal([&] { load_scene(headless.path()); }));
}

}  // namespace
}  // namespace halfspace::ref
