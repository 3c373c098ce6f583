// SPDX-License-Identifier: Apache-2.0
// The top functions of ztest_merge and scan_object, fields as plain integers, give the words of the kernels, the same
// at run time.
#include <gtest/gtest.h>

#include <map>
#include <memory>

#include "hls/top/fields.hpp"
#include "model/formats/field_value.hpp"
#include "model/pipeline/engine.hpp"
#include "vectors/frames/merge_frames.hpp"
#include "vectors/standard_set.hpp"

using TopDepthBuffer = halfspace::DepthBuffer<halfspace::TopFormats>;
using TopObjectTable = halfspace::ObjectTable<halfspace::TopFormats>;
extern "C" void ztest_merge_top(int, const std::int64_t*, const std::int64_t*, const std::int64_t*, std::int64_t*,
                                std::int64_t*);
extern "C" void scan_object_top(const std::int64_t*, const std::int64_t*, TopDepthBuffer*, const TopObjectTable*,
                                std::int64_t*);

namespace halfspace::tests {
namespace {

using F = TopFormats;
using Fields = std::vector<std::int64_t>;

void append_fields(Fields& out, const model::Layout& layout, const model::Word& word) {
  for (const model::Field& field : layout.fields) {
    for (int lane = 0; lane < field.count; ++lane) out.push_back(model::field_value(word, field, lane));
  }
}
Fields fields_of(const model::StreamWords& stream) {
  Fields out;
  for (const model::Word& word : stream.words) append_fields(out, stream.layout, word);
  return out;
}

model::Configuration configuration() { return model::Configuration(F::config().name, F::config()); }

TEST(MergeTop, GivesTheWordsOfTheKernel) {
  const model::Merger merger(configuration(), F::kLanes);
  std::size_t stamps = 0, merged_words = 0, found_pixels = 0;
  for (const model::NamedMerge& run : model::merge_frames(F::config(), 5)) {
    std::vector<model::StreamWords> streams;
    merger.capture(run.input(), streams);
    std::map<std::string, Fields> words;
    for (const model::StreamWords& stream : streams) words[stream.layout.stream] = fields_of(stream);
    const std::size_t count = words["stored"].size() / kEntryFields;
    ASSERT_EQ(words["merge"].size(), std::size_t(kMergeFields));
    ASSERT_EQ(words["stored"].size(), count * kEntryFields);
    Fields merged(words["merged"].size() + 1, -1), found(std::size_t(kFoundFields) + 1, -1);
    ztest_merge_top(int(count), words["merge"].data(), words["stored"].data(), words["entry"].data(), merged.data(),
                    found.data());
    for (Fields* fields : {&merged, &found}) {
      ASSERT_EQ(fields->back(), -1) << "more words than there are";
      fields->pop_back();
    }
    ASSERT_EQ(merged, words["merged"]) << run.note;
    ASSERT_EQ(found, words["found"]) << run.note;
    stamps += count, merged_words += merged.size() / kEntryFields, found_pixels += std::size_t(found[0]);
  }
  EXPECT_GT(stamps, 2500u);
  EXPECT_GT(merged_words, 1500u);
  EXPECT_GT(found_pixels, 1000u);
}

// The buffers as they are at scan-out follow from the words: where no triangle is, a depth means nothing.
TEST(ScanObjectTop, GivesTheWordsOfTheKernel) {
  const auto engine = model::make_engine(configuration(), F::kLanes);
  const auto depths = std::make_unique<TopDepthBuffer>();
  const auto table = std::make_unique<TopObjectTable>();
  const std::uint32_t most = (1u << F::config().object_bits) - 1;
  std::size_t stamps = 0, shown = 0, background = 0;
  for (const model::NamedFrame& frame : model::random_frames(model::raster_format(configuration()), 5, 6, 60)) {
    std::vector<std::uint32_t> objects;
    for (std::size_t k = 0; k < frame.scene.triangles.size(); ++k) objects.push_back(1 + std::uint32_t(k * 7) % most);
    for (std::size_t k = 0; k < objects.size(); ++k) table->object[k] = from_raw<F::Object>(objects[k]);
    engine->number(objects);
    Fields scan, entry;
    engine->capture(frame.scene, [&](const model::Layout& layout, const model::Word* words, std::size_t count) {
      Fields* const out = layout.stream == "scan" ? &scan : layout.stream == "entry" ? &entry : nullptr;
      for (std::size_t n = 0; out && n < count; ++n) append_fields(*out, layout, words[n]);
    });
    const std::size_t count = scan.size() / kScanFields;
    ASSERT_EQ(entry.size(), count * kEntryFields);
    for (std::size_t n = 0; n < count; ++n) {
      const auto scan_word = scan.begin() + long(n * kScanFields), entry_word = entry.begin() + long(n * kEntryFields);
      const Fields in(scan_word, scan_word + kScanFields), want(entry_word, entry_word + kEntryFields);
      Fields pixel(want.begin(), want.begin() + 3);
      pixel.insert(pixel.end(), want.begin() + 3 + 2 * F::kLanes, want.end());
      ASSERT_EQ(pixel.size(), std::size_t(kPixelFields));
      for (int l = 0; l < F::kLanes; ++l) {
        const std::int64_t index = in[std::size_t(3 + l)];
        depths->depth[in[2] * F::kStampsX + in[1]][l] =
            from_raw<F::Depth>(index ? want[std::size_t(3 + l)] : std::int64_t(n));
        ++(index ? shown : background);
        ASSERT_EQ(want[std::size_t(3 + F::kLanes + l)], index ? objects[std::size_t(index - 1)] : 0);
      }
      Fields got(std::size_t(kEntryFields) + 1, -1);
      scan_object_top(in.data(), pixel.data(), depths.get(), table.get(), got.data());
      ASSERT_EQ(got.back(), -1);
      got.pop_back();
      ASSERT_EQ(got, want) << frame.note << ", stamp " << n;
      ++stamps;
    }
  }
  EXPECT_GT(stamps, 1000u);
  EXPECT_GT(shown, 1000u);
  EXPECT_GT(background, 300u);
}

}  // namespace
}  // namespace halfspace::tests
