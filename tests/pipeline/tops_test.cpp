// SPDX-License-Identifier: Apache-2.0
// The top functions in a chain, fields as plain integers, give the words of the pipeline.
#include <gtest/gtest.h>

#include <memory>

#include "hls/top/fields.hpp"
#include "model/pipeline/engine.hpp"
#include "vectors/standard_set.hpp"

extern "C" {
int triangle_setup_top(int, int, const std::int64_t*, std::int64_t*, std::int64_t*);
void shade_setup_top(const std::int64_t*, std::int64_t*);
int raster_pineda_top(int, int, const std::int64_t*, std::int64_t*, std::int64_t*);
void ztest_index_top(int, const std::int64_t*, halfspace::IndexBuffer<halfspace::TopFormats>*,
                     halfspace::DepthBuffer<halfspace::TopFormats>*, std::int64_t*);
void ztest_plane_top(int, const std::int64_t*, const std::int64_t*, halfspace::IndexBuffer<halfspace::TopFormats>*,
                     halfspace::VisibilityDatabase<halfspace::TopFormats>*, std::int64_t*);
int scan_index_top(int, int, int, halfspace::IndexBuffer<halfspace::TopFormats>*, std::int64_t*);
void shade_gouraud_top(int, const std::int64_t*, const halfspace::ShadingDatabase<halfspace::TopFormats>*,
                       std::int64_t*);
}

namespace halfspace::tests {
namespace {

using F = TopFormats;

template <class Record>
int field_count() {
  std::int64_t fields[64] = {};
  FieldWriter writer(fields);
  Record{}.visit(writer);
  return writer.count();
}

TEST(Tops, HaveRoomForEveryField) {
  EXPECT_EQ(field_count<Triangle<F>>(), kTriangleFields);
  EXPECT_EQ(field_count<halfspace::Setup<F>>(), kSetupFields);
  EXPECT_EQ(field_count<Attributes<F>>(), kAttributesFields);
  EXPECT_EQ(field_count<Planes<F>>(), kPlanesFields);
  EXPECT_EQ(field_count<Visible<F>>(), kVisibleFields);
  EXPECT_EQ(field_count<Stamp<F>>(), kStampFields);
  EXPECT_EQ(field_count<TriangleDepth<F>>(), kTriangleDepthFields);
  EXPECT_EQ(field_count<Update<F>>(), kUpdateFields);
  EXPECT_EQ(field_count<Scan<F>>(), kScanFields);
  EXPECT_EQ(field_count<Pixel<F>>(), kPixelFields);
}

TEST(Tops, RenderTheStandardFrames) {
  const model::Configuration configuration(F::config().name, F::config());
  const ref::RasterFormat format = model::raster_format(configuration);
  std::vector<model::NamedFrame> frames = model::corner_frames(format);
  for (auto& frame : model::random_frames(format, 3, 3, 30)) frames.push_back(std::move(frame));
  auto buffers = std::make_unique<Buffers<F>>();
  std::vector<std::int64_t> stamps(std::size_t(F::kStamps) * kStampFields),
      scans(std::size_t(F::kStampsX) * kScanFields);
  std::size_t covered = 0;
  for (const model::NamedFrame& named : frames) {
    const ref::SnappedList& scene = named.scene;
    const ref::Frame expected = model::make_engine(configuration, F::kLanes)->render(scene);
    for (std::size_t k = 0; k < scene.triangles.size(); ++k) {
      const ref::SnappedTriangle& t = scene.triangles[k];
      std::int64_t triangle[kTriangleFields] = {k + 1 == scene.triangles.size(), std::int64_t(k + 1)};
      for (int v = 0; v < 3; ++v) {
        triangle[2 + v] = t.x[v], triangle[5 + v] = t.y[v];
        if (F::kHasDepth) triangle[8 + v] = t.depth[v];
        for (int c = 0; c < 3 && F::kGouraud; ++c) triangle[8 + kVertexDepths + 3 * c + v] = t.rgb[v][c];
      }
      for (int c = 0; c < 3 && !F::kGouraud; ++c) triangle[8 + kVertexDepths + c] = t.rgb[0][c];
      std::int64_t setup[kSetupFields], attributes[kAttributesFields], planes[kPlanesFields], visible[kVisibleFields];
      if (triangle_setup_top(scene.width, scene.height, triangle, setup, attributes)) {
        shade_setup_top(attributes, planes);
        Stream<Planes<F>> stream;
        stream.write(read_fields<Planes<F>>(planes));
        store_planes(stream, buffers->shading);
      }
      std::int64_t triangle_depth[kTriangleDepthFields];
      const int count = raster_pineda_top(scene.width, scene.height, setup, stamps.data(), triangle_depth);
      if (F::kTestsPlanes) {
        DepthEntry<F>& entry = buffers->visibility.entry[k];
        entry.dx = from_raw<F::DepthGradient>(1);
        const auto dx = from_raw<F::DepthGradient>(triangle_depth[4]);
        ztest_plane_top(count, stamps.data(), triangle_depth, &buffers->index, &buffers->visibility, visible);
        // TdbV has the visible triangles alone.
        EXPECT_EQ(raw(entry.dx), visible[1] ? raw(dx) : 1) << named.note;
      } else {
        ztest_index_top(count, stamps.data(), &buffers->index, &buffers->depth, visible);
      }
      EXPECT_EQ(visible[1] != 0, expected.visible[k]);
    }
    const int background = scene.background[0] << 16 | scene.background[1] << 8 | scene.background[2];
    for (int n = 0, count = 0, y = 0; y * F::kLanesY < scene.height; ++n) {
      if (n == count) n = 0, count = scan_index_top(scene.width, scene.height, y, &buffers->index, scans.data());
      if (n + 1 == count) ++y;
      std::int64_t pixel[kPixelFields];
      shade_gouraud_top(background, &scans[std::size_t(n) * kScanFields], &buffers->shading, pixel);
      for (int l = 0; l < F::kLanes; ++l) {
        const int x = int(pixel[1]) * F::kLanesX + l % F::kLanesX, y = int(pixel[2]) * F::kLanesY + l / F::kLanesX;
        if (x >= scene.width || y >= scene.height) continue;
        const auto& colour = expected.colour[std::size_t(y) * scene.width + x];
        ASSERT_EQ(pixel[3 + l], colour[0]) << named.note;
        ASSERT_EQ(pixel[3 + F::kLanes + l], colour[1]) << named.note;
        ASSERT_EQ(pixel[3 + 2 * F::kLanes + l], colour[2]) << named.note;
        covered += expected.index[std::size_t(y) * scene.width + x] != 0;
      }
    }
  }
  EXPECT_GT(covered, 1000u);
}

}  // namespace
}  // namespace halfspace::tests
