// SPDX-License-Identifier: Apache-2.0
// The top functions of the motion field, fields as plain integers, give the words of the kernels.
#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "hls/motion/motion_field.hpp"
#include "hls/motion/motion_setup.hpp"
#include "hls/top/fields.hpp"
#include "model/motion/motion_records.hpp"
#include "vectors/frames/awkward.hpp"
#include "vectors/standard_set.hpp"

using TopMotionDatabase = halfspace::MotionDatabase<halfspace::TopFormats>;
extern "C" void motion_setup_top(const std::int64_t*, const std::int64_t*, std::int64_t*);
extern "C" int motion_field_top(const std::int64_t*, const TopMotionDatabase*,
                                std::int64_t (*)[halfspace::kMotionFields]);

namespace halfspace::tests {
namespace {

using F = TopFormats;
constexpr std::int64_t kNoField = std::numeric_limits<std::int64_t>::min();

template <class Record>
std::vector<std::int64_t> fields_of(const Record& record, int count) {
  std::vector<std::int64_t> fields(std::size_t(count) + 1, kNoField);
  write_fields(record, fields.data());
  EXPECT_EQ(fields.back(), kNoField) << "more fields than its top";
  EXPECT_NE(fields[std::size_t(count) - 1], kNoField) << "fewer fields than its top";
  return fields;
}

TEST(MotionFieldTops, GiveTheWordsOfTheKernels) {
  const model::Configuration configuration(F::config().name, F::config());
  const auto database = std::make_unique<TopMotionDatabase>();
  std::size_t planes = 0, words = 0, ends = 0;
  for (const model::NamedFrame& frame : model::random_frames(model::raster_format(configuration), 5, 4, 60)) {
    const model::MotionFrame motion = model::awkward_motion(frame.scene, F::config(), 5);
    Frame<F> registers{};
    registers.width = from_raw<F::X>(frame.scene.width);
    registers.height = from_raw<F::Y>(frame.scene.height);
    Stream<Triangle<F>> triangle;
    Stream<halfspace::Setup<F>> setup;  // Test::Setup is another
    Stream<Attributes<F>> attributes, again;
    Stream<MotionVectors<F>> vectors_of;
    Stream<MotionPlanes<F>> out;
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
      const MotionVectors<F> given = model::vectors_record<F>(motion.triangles[k], int(k) + 1, false);
      std::vector<std::int64_t> got(std::size_t(kMotionPlanesFields) + 1, kNoField);
      motion_setup_top(fields_of(in, kAttributesFields).data(), fields_of(given, kMotionVectorsFields).data(),
                       got.data());
      again.write(in), vectors_of.write(given);
      motion_setup(again, vectors_of, out);
      const MotionPlanes<F> want = out.read();
      ASSERT_EQ(got, fields_of(want, kMotionPlanesFields)) << frame.note << ", triangle " << k + 1;
      database->planes[k] = want;
      ++planes;
      // Lanes near its first vertex, as if they were covered, or none of them.
      Scan<F> scan{};
      scan.last = from_raw<Bit>(k % 2);
      scan.x = from_raw<F::X>(std::max(int(raw(in.x)), 0) >> F::kSubpixelBits >> F::kLog2LanesX);
      scan.y = from_raw<F::Y>(std::max(int(raw(in.y)), 0) >> F::kSubpixelBits >> F::kLog2LanesY);
      for (int l = 0; l < F::kLanes; ++l) scan.index[l] = from_raw<F::Index>(l % 3 == 2 || k % 5 == 0 ? 0 : k + 1);
      std::int64_t fields[F::kLanes][kMotionFields];
      const int count = motion_field_top(fields_of(scan, kScanFields).data(), database.get(), fields);
      Stream<Scan<F>> scans;
      Stream<Motion<F>> field;
      scans.write(scan);
      motion_field(scans, *database, field);
      for (int n = 0; n < count; ++n) {
        ASSERT_FALSE(field.empty());
        const Motion<F> word = field.read();
        std::vector<std::int64_t> expected = fields_of(word, kMotionFields);
        expected.pop_back();
        ASSERT_EQ(std::vector<std::int64_t>(fields[n], fields[n] + kMotionFields), expected)
            << frame.note << ", triangle " << k + 1;
        ++words;
        ends += raw(word.last) != 0;
      }
      ASSERT_TRUE(field.empty());
      ASSERT_EQ(count > 0, k % 5 != 0 || k % 2 != 0);
    }
  }
  EXPECT_GT(planes, 100u);
  EXPECT_GT(words, 100u);
  EXPECT_GT(ends, 50u);
}

}  // namespace
}  // namespace halfspace::tests
