// SPDX-License-Identifier: Apache-2.0
// Records as arrays of integers, a field an element, for the top functions: in the order of visit(), lanes in theirs.
#ifndef HALFSPACE_HLS_TOP_FIELDS_HPP_
#define HALFSPACE_HLS_TOP_FIELDS_HPP_

#include "hls/formats/configs/high.hpp"
#include "hls/formats/configs/low.hpp"
#include "hls/formats/configs/middle.hpp"
#include "hls/pipeline/pipeline.hpp"

// A tool that synthesizes a top defines these two, or takes them as they are.
#ifndef HALFSPACE_TOP_CONFIG
#define HALFSPACE_TOP_CONFIG Middle
#endif
#ifndef HALFSPACE_TOP_STAMP
#define HALFSPACE_TOP_STAMP Stamp4
#endif

namespace halfspace {

using TopFormats = Formats<HALFSPACE_TOP_CONFIG, HALFSPACE_TOP_STAMP>;

constexpr int kShadeColours = TopFormats::kGouraud ? 9 : TopFormats::kPhong ? 0 : 3;
constexpr int kVertexColours = TopFormats::kHasColours ? kShadeColours : 0,
              kVertexDepths = TopFormats::kHasDepth ? 3 : 0;
constexpr int kTriangleFields = 8 + (TopFormats::kHasObjects ? 1 : 0) + kVertexDepths + kVertexColours,
              kSetupFields = 17 + (TopFormats::kHasDepth ? 3 : 0);
constexpr int kAttributesFields =
    3 + (TopFormats::kSendsShape ? 8 : 0) + (TopFormats::kOrdersVertices ? 2 : 0) + kVertexColours;
constexpr int kPlanesFields = TopFormats::kGouraud ? 12 : 6;
constexpr int kStampFields = 5 + (TopFormats::kHasDepth ? 2 : 1) * TopFormats::kLanes, kTriangleDepthFields = 6;
constexpr int kUpdateFields = 3 + (TopFormats::kStoresDepth ? 2 : 1) * TopFormats::kLanes, kVisibleFields = 3;
constexpr int kScanFields = 3 + TopFormats::kLanes, kPixelFields = 3 + 3 * TopFormats::kLanes;
constexpr int kLightFields = 1 + (TopFormats::kHasGloss ? 6 : 3),
              kMaterialFields = 2 + (TopFormats::kHasGloss ? 10 : 6);
constexpr int kNormalsFields = 3 + (TopFormats::kShadesPlanes ? 9 : 3), kColoursFields = 2 + kShadeColours;
constexpr int kNormalPlanesFields = 13;
constexpr int kTextureCoordinatesFields = 4 + (TopFormats::kPerspective ? 9 : 6);
constexpr int kTexturePlanesFields = kTextureCoordinatesFields + 1;
constexpr int kKeyFields = (TopFormats::kPerspective ? 9 : 6) + (TopFormats::kRelights ? 9 : 0);
constexpr int kMotionVectorsFields = 3 + kKeys * (4 + kKeyFields), kMotionPlanesFields = kMotionVectorsFields + 1;
constexpr int kMotionFields = 4 + kKeys * (3 + (TopFormats::kRelights ? 3 : 0));
constexpr int kCompensatedFields = 7;
constexpr int kEntryFields = 3 + 5 * TopFormats::kLanes, kMergeFields = 7, kFoundFields = 5;

class FieldReader {
 public:
  explicit FieldReader(const std::int64_t* fields) : fields_(fields), at_(0) {}
  template <class T>
  void operator()(const char*, T& value) {
    value = from_raw<T>(fields_[at_++]);
  }
  template <class T, std::size_t N>
  void lanes(const char*, T (&values)[N]) {
    for (std::size_t l = 0; l < N; ++l) values[l] = from_raw<T>(fields_[at_++]);
  }
  int count() const { return at_; }

 private:
  const std::int64_t* fields_;
  int at_;
};

class FieldWriter {
 public:
  explicit FieldWriter(std::int64_t* fields) : fields_(fields), at_(0) {}
  template <class T>
  void operator()(const char*, const T& value) {
    fields_[at_++] = std::int64_t(raw(value));
  }
  template <class T, std::size_t N>
  void lanes(const char*, const T (&values)[N]) {
    for (std::size_t l = 0; l < N; ++l) fields_[at_++] = std::int64_t(raw(values[l]));
  }
  int count() const { return at_; }

 private:
  std::int64_t* fields_;
  int at_;
};

template <class Record>
Record read_fields(const std::int64_t* fields) {
  Record record{};
  FieldReader reader(fields);
  record.visit(reader);
  return record;
}
template <class Record>
void write_fields(Record record, std::int64_t* fields) {
  FieldWriter writer(fields);
  record.visit(writer);
}

inline Frame<TopFormats> top_frame(int width, int height, int background) {
  Frame<TopFormats> frame;
  frame.width = from_raw<TopFormats::X>(width);
  frame.height = from_raw<TopFormats::Y>(height);
  frame.r = from_raw<TopFormats::Colour>(background >> 16 & 255);
  frame.g = from_raw<TopFormats::Colour>(background >> 8 & 255);
  frame.b = from_raw<TopFormats::Colour>(background & 255);
  return frame;
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_TOP_FIELDS_HPP_
