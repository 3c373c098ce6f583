// SPDX-License-Identifier: Apache-2.0
// Scene files with numbers that no picture has: NaN and infinities are refused with the file's name; vertices beside
// the eye and behind it (w <= 0) are clipped, and what is left is what a ray through each pixel centre hits.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

#include "model/pipeline/engine.hpp"
#include "ref/error.hpp"
#include "ref/geometry/geometry.hpp"
#include "ref/scene/scene.hpp"
#include "study/trade/accuracy.hpp"

namespace halfspace::tests {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();
constexpr double kHalfHeight = 0.5, kNear = 0.01;  // of the view at distance 1; of the camera

using Positions = std::vector<std::array<float, 3>>;  // three a triangle, the viewer at 0 looking along −z

std::string base64(const std::string& bytes) {
  constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) bits = bits << 8 | (i + k < bytes.size() ? std::uint8_t(bytes[i + k]) : 0);
    for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : kDigits[bits >> (18 - 6 * k) & 63];
  }
  return text;
}

std::string bytes_of(const void* data, std::size_t size) { return std::string(static_cast<const char*>(data), size); }

// A glTF file of one two-sided mesh without indices, its node placed by `matrix`, and a camera at the origin.
std::string gltf(const Positions& positions, const std::string& matrix = "1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1") {
  const std::string count = std::to_string(positions.size()), size = std::to_string(positions.size() * 12);
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],
"nodes":[{"mesh":0,"matrix":[)" +
         matrix + R"(]},{"camera":0}],
"cameras":[{"type":"perspective","perspective":{"yfov":)" +
         std::to_string(2 * std::atan(kHalfHeight)) + R"(,"znear":)" + std::to_string(kNear) + R"(,"zfar":1e30}}],
"materials":[{"doubleSided":true}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":)" +
         count +
         R"(,"type":"VEC3","min":[-1,-1,-1],"max":[1,1,1]}],
"bufferViews":[{"buffer":0,"byteLength":)" +
         size + R"(}],
"buffers":[{"byteLength":)" +
         size + R"(,"uri":"data:application/octet-stream;base64,)" +
         base64(bytes_of(positions.data(), positions.size() * 12)) + R"("}]})";
}

std::string stl(const Positions& positions) {
  const std::uint32_t count = std::uint32_t(positions.size() / 3);
  std::string text(80, ' ');
  text += bytes_of(&count, 4);
  for (std::uint32_t t = 0; t < count; ++t) {
    const float normal[3] = {0, 0, 1};
    text += bytes_of(normal, 12) + bytes_of(&positions[3 * t], 36) + std::string(2, '\0');
  }
  return text;
}

std::string ply(const Positions& positions) {
  std::string text = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(positions.size()) +
                     "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                     std::to_string(positions.size() / 3) + "\nproperty list uchar int vertex_index\nend_header\n";
  text += bytes_of(positions.data(), positions.size() * 12);
  for (std::int32_t v = 0; v < std::int32_t(positions.size()); v += 3) {
    const std::int32_t corners[3] = {v, v + 1, v + 2};
    text += '\3' + bytes_of(corners, 12);
  }
  return text;
}

class Unclean : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string file(const std::string& name, const std::string& bytes) const {
    std::string path = (folder_ / name).string();
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
  }
  ref::SnappedList frame(const std::string& path, const ref::RasterFormat& format) const {
    return ref::snap(ref::project(ref::load_scene(path), {160, 120, format.range_bits, format.subpixel_bits}), format);
  }
  // The sentence of the refusal.
  std::string refusal(const std::string& path) const {
    try {
      frame(path, model::raster_format("middle"));
    } catch (const ref::Error& error) {
      return error.what();
    }
    return "";
  }
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("halfspace_unclean_" + std::to_string(getpid()));
};

TEST_F(Unclean, NanAndInfinitiesAreRefusedByName) {
  const Positions good = {{-1, -1, -3}, {1, -1, -3}, {0, 1, -3}};
  const struct {
    const char* name;
    std::string (*bytes)(const Positions&);
  } kinds[] = {{"mesh.gltf", [](const Positions& p) { return gltf(p); }}, {"mesh.stl", stl}, {"mesh.ply", ply}};
  for (const auto& kind : kinds) {
    EXPECT_EQ(refusal(file(kind.name, kind.bytes(good))), "") << kind.name;
    for (const float value : {kNan, -kNan, kInfinity, -kInfinity}) {
      for (int axis = 0; axis < 3; ++axis) {
        Positions bad = good;
        bad[1][axis] = value;
        const std::string path = file(kind.name, kind.bytes(bad)), sentence = refusal(path);
        EXPECT_NE(sentence.find(path), std::string::npos) << kind.name << ' ' << value << ": '" << sentence << "'";
      }
    }
  }
  for (const char* matrix : {"1e999,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1", "1,0,0,0,0,1,0,0,0,0,1,0,-1e999,0,0,1"}) {
    const std::string path = file("matrix.gltf", gltf(good, matrix));
    EXPECT_NE(refusal(path).find(path), std::string::npos) << matrix << ": '" << refusal(path) << "'";
  }
}

// 1: the ray of a pixel centre hits the triangle well inside; −1: well outside; 0: too near an edge or the eye to say.
int hit(const std::array<float, 3>* corner, double x, double y) {
  const double d[3] = {x, y, -1};
  auto cross = [](const double(&a)[3], const double(&b)[3], double(&c)[3]) {
    for (int i = 0; i < 3; ++i) c[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
  };
  auto dot = [](const double(&a)[3], const double(&b)[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  double from_a[3], ab[3], ac[3], normal[3], p[3], q[3];
  for (int i = 0; i < 3; ++i) {
    from_a[i] = -double(corner[0][i]);
    ab[i] = double(corner[1][i]) - corner[0][i];
    ac[i] = double(corner[2][i]) - corner[0][i];
  }
  cross(ab, ac, normal), cross(d, ac, p), cross(from_a, ab, q);
  const double area = dot(ab, p), depth = dot(ac, q) / area;
  const double u = dot(from_a, p) / area, v = dot(d, q) / area, least = std::min({u, v, 1 - u - v});
  if (!(std::fabs(depth) > 2 * kNear) || !(std::fabs(least) > 0.05)) return 0;
  return depth > 0 && least > 0 ? 1 : -1;
}

TEST_F(Unclean, VerticesAtTheEyeAndBehindAreClipped) {
  const struct {
    const char* name;
    Positions positions;
  } cases[] = {
      {"one behind", {{-1, -1, -5}, {1, -1, -5}, {0, 1, 3}}},
      {"two behind", {{-1, -1, 2}, {1, -1, 3}, {0, 1, -4}}},
      {"one beside the eye, w = 0", {{2, 0.3f, 0}, {-1, -1, -4}, {-1, 1, -4}}},
      {"two beside the eye, w = 0", {{2, -0.3f, 0}, {-2, -0.3f, 0}, {0, 0.5f, -4}}},
      {"w = -1e-30", {{1, 1, 1e-30f}, {-1, -1, -4}, {1, -1, -4}}},
      {"w = 1e-30", {{1, 1, -1e-30f}, {-1, -1, -4}, {1, -1, -4}}},
      {"all behind, and one before", {{-1, -1, 1}, {1, -1, 2}, {0, 1, 3}, {-1, -1, -4}, {1, -1, -4}, {0, 1, -4}}},
      {"1e18 away", {{1e18f, -1e18f, -2e18f}, {-1e18f, -1e18f, -2e18f}, {0, 1e18f, -3e18f}}},
  };
  for (const auto& [name, positions] : cases) {
    for (const char* config : {"low", "middle", "high"}) {
      SCOPED_TRACE(std::string(name) + ", " + config);
      const ref::RasterFormat format = model::raster_format(config);
      const ref::SnappedList scene = frame(file("eye.gltf", gltf(positions)), format);
      const ref::Frame reference = ref::render(scene), kernels = model::make_engine(config, 4)->render(scene);
      const model::Accuracy a = model::accuracy(reference, kernels, format.depth_bits);
      EXPECT_EQ(a.index_differ, 0u);
      EXPECT_LE(a.depth_largest, 1);
      EXPECT_LE(a.colour_largest, 1);
      int inside = 0, outside = 0, wrong = 0;
      for (int y = 0; y < scene.height; ++y) {
        for (int x = 0; x < scene.width; ++x) {
          const double right = (2 * x + 1.0) / scene.height - double(scene.width) / scene.height;
          const double up = 1 - (2 * y + 1.0) / scene.height;
          int expected = -1;
          for (std::size_t first = 0; first < positions.size() && expected <= 0; first += 3) {
            const int here = hit(&positions[first], right * kHalfHeight, up * kHalfHeight);
            if (here >= 0) expected = here;
          }
          const bool covered = kernels.index[std::size_t(y) * scene.width + x] != 0;
          inside += expected > 0, outside += expected < 0;
          wrong += expected != 0 && covered != (expected > 0);
        }
      }
      EXPECT_GT(inside, 100);
      EXPECT_GT(outside, 100);
      EXPECT_EQ(wrong, 0);
    }
  }
}

TEST_F(Unclean, NothingButWOfZeroIsBackground) {
  const Positions beside = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}, at = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  for (const Positions& positions : {beside, at}) {
    const ref::SnappedList scene = frame(file("eye.gltf", gltf(positions)), model::raster_format("middle"));
    const ref::Frame reference = ref::render(scene), kernels = model::make_engine("middle", 4)->render(scene);
    EXPECT_EQ(reference.index, kernels.index);
    EXPECT_EQ(kernels.index, std::vector<std::uint32_t>(kernels.index.size(), 0));
  }
}

}  // namespace
}  // namespace halfspace::tests
