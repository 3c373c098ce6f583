// SPDX-License-Identifier: Apache-2.0
// Phong shading at scan-out: planes of normals against exact ones, and configurations.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "model/pipeline/engine_impl.hpp"
#include "model/shade/frame_lighting.hpp"
#include "ref/error.hpp"
#include "ref/geometry/surface.hpp"
#include "ref/raster/architecture.hpp"
#include "ref/scene/scene.hpp"
#include "study/proofs/phong_bounds.hpp"
#include "tests/config_path.hpp"
#include "tests/shade/lit_configs.hpp"
#include "vectors/frames/awkward.hpp"
#include "vectors/standard_set.hpp"

namespace halfspace::tests {
namespace {

using ref::Wide;

std::vector<model::NamedFrame> frames_of(const Config& config) {
  const ref::RasterFormat format = model::raster_format(configuration_of(config));
  std::vector<model::NamedFrame> frames = model::corner_frames(format);
  for (auto& frame : model::random_frames(format, 3, 6, 60)) frames.push_back(std::move(frame));
  for (std::size_t n = 0; n < frames.size(); ++n) {
    frames[n].lighting = model::awkward_normals(frames[n].scene.triangles.size(), config, n);
  }
  return frames;
}

// Planes of normals at every pixel that a triangle covers, against exact ones of the same integers.
template <class C>
void expect_planes_within_bound() {
  using F = Formats<C, Stamp1>;
  const Config config = C::config();
  const int f = config.subpixel_bits, g = config.normal_fraction;
  std::uint64_t compared = 0;
  double share = 0, largest = 0;
  int turned = 0, first = 0;
  for (const model::NamedFrame& frame : frames_of(config)) {
    Frame<F> registers{};
    registers.width = from_raw<typename F::X>(frame.scene.width);
    registers.height = from_raw<typename F::Y>(frame.scene.height);
    for (std::size_t k = 0; k < frame.scene.triangles.size(); ++k) {
      const ref::SnappedTriangle& in = frame.scene.triangles[k];
      const model::RawNormals& given = frame.lighting.triangles[k];
      Stream<Triangle<F>> triangle;
      Stream<Setup<F>> setup;
      Stream<Attributes<F>> attributes;
      Stream<Normals<F>> normals;
      Stream<NormalPlanes<F>> planes;
      Triangle<F> t{};
      t.index = from_raw<typename F::Index>(k + 1);
      for (int v = 0; v < 3; ++v) {
        t.x[v] = from_raw<typename F::Coord>(in.x[v]);
        t.y[v] = from_raw<typename F::Coord>(in.y[v]);
      }
      triangle.write(t);
      triangle_setup(registers, triangle, setup, attributes);
      const Attributes<F> shape = attributes.read();
      if (raw(shape.empty)) continue;
      attributes.write(shape);
      normals.write(model::normals_record<F>(given, int(k) + 1, false));
      phong_setup(attributes, normals, planes);
      const NormalPlanes<F> got = planes.read();
      const ref::OrderedTriangle exact(in);
      turned += exact.vertex[1] != (exact.vertex[0] + 1) % 3;
      first += in.y[0] > std::min(in.y[1], in.y[2]);
      const int one = 1 << f;
      auto [left, right] = std::minmax({in.x[0], in.x[1], in.x[2]});
      auto [top, bottom] = std::minmax({in.y[0], in.y[1], in.y[2]});
      const int x0 = std::max(left / one - 1, 0), x1 = std::min(right / one + 1, frame.scene.width - 1);
      const int y0 = std::max(top / one - 1, 0), y1 = std::min(bottom / one + 1, frame.scene.height - 1);
      const int step = std::max(1, (x1 - x0) / 40);
      for (int y = y0; y <= y1; y += std::max(1, (y1 - y0) / 40)) {
        for (int x = x0; x <= x1; x += step) {
          const std::int64_t px = std::int64_t(x) * one + one / 2, py = std::int64_t(y) * one + one / 2;
          std::int64_t weight[3];
          bool inside = true;
          for (int i = 0; i < 3; ++i) {
            const int a = (i + 1) % 3, b = (i + 2) % 3;
            weight[i] = (exact.x[b] - exact.x[a]) * (py - exact.y[a]) - (exact.y[b] - exact.y[a]) * (px - exact.x[a]);
            inside = inside && weight[i] >= 0;
          }
          if (!inside) continue;
          double distance = 0;  // from any vertex: which one the kernels start from is theirs
          for (int v = 0; v < 3; ++v) {
            distance = std::max(distance, double(std::llabs(px - in.x[v]) + std::llabs(py - in.y[v])) / one);
          }
          const double bound = model::normal_plane_bound(config, distance);
          for (int c = 0; c < 3; ++c) {
            Wide sum = 0;
            for (int i = 0; i < 3; ++i) sum += Wide(weight[i]) * given.normals[exact.vertex[i]][c];
            const long double want = (long double)sum / exact.area;
            // The plane before rounding, without its ½ and its offset.
            const std::uint64_t bits = std::uint64_t(raw(got.start[c])) +
                                       std::uint64_t(std::int64_t(raw(got.dx[c]))) * x +
                                       std::uint64_t(std::int64_t(raw(got.dy[c]))) * y;
            const int width = F::NormalPlane::width();
            const long double plane =
                (long double)(bits & ((std::uint64_t(1) << width) - 1)) / (1 << g) - 0.5L - (1 << config.normal_bits);
            const double error = double(std::abs(plane - want));
            ASSERT_LE(error, bound) << frame.note << ", triangle " << k + 1 << ", pixel " << x << ", " << y;
            largest = std::max(largest, error), share = std::max(share, error / bound);
            const auto rounded = normal_component<F>(got.start[c], got.dx[c], got.dy[c], x, y);
            ASSERT_EQ(std::int64_t(raw(rounded)), std::int64_t(std::floor(plane + 0.5L))) << frame.note;
            ++compared;
          }
        }
      }
    }
  }
  std::printf("%-10s %llu components: largest error %.4f units of 2^-p, %.3f of the bound\n", config.name,
              static_cast<unsigned long long>(compared), largest, share);
  EXPECT_GT(compared, 10000u);
  EXPECT_GT(share, 0.5) << "the frames are blind, or the bound is loose";
  EXPECT_GT(turned, 100);
  EXPECT_GT(first, 100);
}
TEST(NormalPlanes, AreWithinTheBound) {
  expect_planes_within_bound<PhongLow>();
  expect_planes_within_bound<PhongMiddle>();
  expect_planes_within_bound<PhongHigh>();
}

// All stamps draw the same picture, and formats read at run time draw that of compiled ones.
TEST(PhongShading, IsTheSameWithAllStampsAndCompiled) {
  const Config config = PhongLow::config();
  model::KernelEngine<Formats<PhongLow, Stamp4>> compiled;
  std::uint64_t lit = 0;
  for (const model::NamedFrame& frame : frames_of(config)) {
    compiled.light(frame.lighting);
    const ref::Frame want = compiled.render(frame.scene);
    for (const int lanes : {1, 2, 4, 8, 16}) {
      const auto engine = model::make_engine(configuration_of(config), lanes);
      engine->light(frame.lighting);
      ASSERT_EQ(engine->render(frame.scene).colour, want.colour) << frame.note << ", " << lanes << " lanes";
    }
    for (const std::uint32_t index : want.index) lit += index != 0;
  }
  EXPECT_GT(lit, 10000u);
}

TEST(PhongConfigurations, FilesAndHeadersAgree) {
  for (const Config& config : {PhongLow::config(), PhongMiddle::config(), PhongHigh::config()}) {
    const std::string path = config_path(config.name);
    EXPECT_EQ(model::configuration_toml(model::find_configuration(path)),
              model::configuration_toml(configuration_of(config)));
  }
}

TEST(PhongConfigurations, AreRefusedWithAReason) {
  const auto refusal_of = [](auto change) { return halfspace::refusal_of(PhongHigh::config(), change); };
  EXPECT_EQ(refusal_of([](Config&) {}), "accepted");
  EXPECT_NE(refusal_of([](Config& c) { c.lights = 0; }).find("there are no lights"), std::string::npos);
  EXPECT_NE(
      refusal_of([](Config& c) { c.normal_fraction = 0; }).find("normal_fraction and coordinate_fraction are 1 to 40"),
      std::string::npos);
  EXPECT_NE(refusal_of([](Config& c) { c.normal_fraction = 14; }).find("planes of normals can be off"),
            std::string::npos);
  EXPECT_NE(refusal_of([](Config& c) { c.normal_fraction = 21; }).find("more fraction bits than its reciprocal"),
            std::string::npos);
  EXPECT_NE(refusal_of([](Config& c) { c.colour_fraction = 18; }).find("colour_fraction where shading is not"),
            std::string::npos);
  EXPECT_NE(refusal_of([](Config& c) {
              c.shading = Shading::kGouraud, c.colour_fraction = 18;
            }).find("normal_fraction where"),
            std::string::npos);
  EXPECT_NE(refusal_of([](Config& c) { c.normal_bits = 17; }).find("normal_bits is 9 to 16"), std::string::npos);
}

TEST(PhongShading, RefusesFramesWithoutNormals) {
  const Config config = PhongLow::config();
  const auto frames = model::random_frames(model::raster_format(configuration_of(config)), 1, 1, 5);
  EXPECT_THROW(model::make_engine(configuration_of(config), 1)->render(frames[0].scene), ref::Error);
}

}  // namespace
}  // namespace halfspace::tests
