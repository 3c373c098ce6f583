// SPDX-License-Identifier: Apache-2.0
// The top functions of texture, fields as plain integers, give the words of the kernels.
#include <gtest/gtest.h>

#include <memory>

#include "hls/texture/shade_texture.hpp"
#include "hls/texture/texture_setup.hpp"
#include "hls/top/fields.hpp"
#include "model/texture/texture_records.hpp"
#include "vectors/frames/awkward.hpp"
#include "vectors/standard_set.hpp"

using TopTextureDatabase = halfspace::TextureDatabase<halfspace::TopFormats>;
using TopTextureTable = halfspace::TextureTable<halfspace::TopFormats>;
using TopTextureMemory = halfspace::TextureMemory<halfspace::TopFormats>;
extern "C" void texture_setup_top(const std::int64_t*, const std::int64_t*, std::int64_t*);
extern "C" void shade_texture_top(const std::int64_t*, const std::int64_t*, const TopTextureDatabase*,
                                  const TopTextureTable*, const TopTextureMemory*, std::int64_t*);

namespace halfspace::tests {
namespace {

using F = TopFormats;

template <class Record>
std::vector<std::int64_t> fields_of(const Record& record, int count) {
  std::vector<std::int64_t> fields(std::size_t(count) + 1, -1);
  write_fields(record, fields.data());
  EXPECT_EQ(fields.back(), -1) << "more fields than its top";
  EXPECT_NE(fields[std::size_t(count) - 1], -1) << "fewer fields than its top";
  return fields;
}

TEST(TextureTops, GiveTheWordsOfTheKernels) {
  const model::Configuration configuration(F::config().name, F::config());
  const auto database = std::make_unique<TopTextureDatabase>();
  const auto table = std::make_unique<TopTextureTable>();
  const auto memory = std::make_unique<TopTextureMemory>();
  std::size_t planes = 0, pixels = 0, textured = 0;
  for (const model::NamedFrame& frame : model::random_frames(model::raster_format(configuration), 5, 4, 60)) {
    const model::TextureFrame texture = model::awkward_coordinates(frame.scene.triangles.size(), F::config(), 5);
    model::load_textures<F>(texture, *table);
    model::load_texels<F>(texture, *memory);
    Frame<F> registers{};
    registers.width = from_raw<F::X>(frame.scene.width);
    registers.height = from_raw<F::Y>(frame.scene.height);
    Stream<Triangle<F>> triangle;
    Stream<halfspace::Setup<F>> setup;  // Test::Setup is another
    Stream<Attributes<F>> attributes, again;
    Stream<TextureCoordinates<F>> coordinates;
    Stream<TexturePlanes<F>> out;
    for (std::size_t k = 0; k < frame.scene.triangles.size(); ++k) {
      Triangle<F> t{};
      t.index = from_raw<F::Index>(k + 1);
      for (int v = 0; v < 3; ++v) {
        t.x[v] = from_raw<F::Coord>(frame.scene.triangles[k].x[v]);
        t.y[v] = from_raw<F::Coord>(frame.scene.triangles[k].y[v]);
      }
      triangle.write(t);
      triangle_setup(registers, triangle, setup, attributes);
      setup.read();
      const Attributes<F> in = attributes.read();
      if (raw(in.empty)) continue;
      const TextureCoordinates<F> given = model::coordinates_record<F>(texture.triangles[k], int(k) + 1, false);
      std::vector<std::int64_t> got(std::size_t(kTexturePlanesFields) + 1, -1);
      texture_setup_top(fields_of(in, kAttributesFields).data(), fields_of(given, kTextureCoordinatesFields).data(),
                        got.data());
      again.write(in), coordinates.write(given);
      texture_setup(again, coordinates, out);
      const TexturePlanes<F> want = out.read();
      ASSERT_EQ(got, fields_of(want, kTexturePlanesFields)) << frame.note << ", triangle " << k + 1;
      database->planes[k] = want;
      ++planes;
      // A pixel of each lane near its first vertex, as if it was covered.
      Scan<F> scan{};
      Pixel<F> lit{};
      scan.x = lit.x = from_raw<F::X>(std::max(int(raw(in.x)), 0) >> F::kSubpixelBits >> F::kLog2LanesX);
      scan.y = lit.y = from_raw<F::Y>(std::max(int(raw(in.y)), 0) >> F::kSubpixelBits >> F::kLog2LanesY);
      for (int l = 0; l < F::kLanes; ++l) {
        scan.index[l] = from_raw<F::Index>(l % 3 == 2 ? 0 : k + 1);
        lit.r[l] = from_raw<F::Colour>(255 - l), lit.g[l] = from_raw<F::Colour>(7 * l),
        lit.b[l] = from_raw<F::Colour>(k);
      }
      std::vector<std::int64_t> shaded(std::size_t(kPixelFields) + 1, -1);
      shade_texture_top(fields_of(scan, kScanFields).data(), fields_of(lit, kPixelFields).data(), database.get(),
                        table.get(), memory.get(), shaded.data());
      Stream<Scan<F>> scans;
      Stream<Pixel<F>> before, after;
      scans.write(scan), before.write(lit);
      shade_texture(scans, before, *database, *table, *memory, after);
      ASSERT_EQ(shaded, fields_of(after.read(), kPixelFields)) << frame.note << ", triangle " << k + 1;
      ++pixels;
      textured += shaded != fields_of(lit, kPixelFields);
    }
  }
  EXPECT_GT(planes, 100u);
  EXPECT_GT(pixels, 100u);
  EXPECT_GT(textured, 50u);
}

}  // namespace
}  // namespace halfspace::tests
