// SPDX-License-Identifier: Apache-2.0
#include "ref/motion/up_convert.hpp"

#include <utility>

#include "ref/error.hpp"
#include "ref/objects/static_instances.hpp"

namespace halfspace::ref {
namespace {

// Of twice the size each way: what a pixel says is said of 2 × 2. Vectors are in pixels of the size.
MotionField doubled(const MotionField& field) {
  MotionField out{2 * field.width, 2 * field.height, {}, {}, {}};
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x) {
      const std::size_t at = std::size_t(y / 2) * field.width + x / 2;
      out.triangle.push_back(field.triangle[at]);
      out.face.push_back(field.face[at]);
      for (int key = 0; key < kKeys; ++key) {
        out.to_key[key].push_back(field.to_key[key][at]);
        if (out.to_key[key].back()) *out.to_key[key].back() *= 2.0;
      }
    }
  }
  return out;
}

LightPlanes doubled(const LightPlanes& light, int width, int height) {
  LightPlanes out;
  for (int key = 0; key < kKeys; ++key) {
    for (int y = 0; !light[key].empty() && y < 2 * height; ++y) {
      for (int x = 0; x < 2 * width; ++x) out[key].push_back(light[key][std::size_t(y / 2) * width + x / 2]);
    }
  }
  return out;
}

}  // namespace

const char* name_of(KeyFaces faces) {
  constexpr const char* kNames[] = {"pure", "most", "two"};
  return kNames[int(faces)];
}

Interval::Interval(const Scene& first, const Scene& second, const UpConversion& mode)
    : scenes_{first, second},
      mode_(mode),
      identities_(mode.surfaces ? surface_identities(first) : face_identities(first)),
      frames_(drawn(mode.width * mode.samples, mode.height * mode.samples)),
      field_(mode.field == FieldSize::kHalf     ? drawn(mode.width / 2, mode.height / 2)
             : mode.field == FieldSize::kPixels ? drawn(mode.width, mode.height)
                                                : drawn(mode.width * mode.samples, mode.height * mode.samples)) {
  if (mode.relight && mode.method == MotionMethod::kStraight)
    throw Error("relighting needs exact motion: straight lines have no light between the keys; leave one of them out");
  const bool by_samples = mode.field == FieldSize::kSamples || (mode.samples == 1 && mode.field == FieldSize::kPixels);
  if (mode.static_buffer && (mode.method == MotionMethod::kStraight || !by_samples)) {
    throw Error(
        "a static buffer needs exact motion and a vector a sample, as what moves is held against its depths: leave it "
        "out with straight lines or half a field");
  }
  if (mode.samples % mode.key_scale != 0 && mode.key_scale % mode.samples != 0)
    throw Error("pixels of a key frame for one of a frame: take a number that divides the samples, or a multiple");
  if (mode.key_scale != 1 && !by_samples) throw Error("key frames that are finer than frames need a vector a sample");
  const bool mixed = mode.samples > mode.key_scale;
  // Without the test of what a place shows colours are those of the frame that is shown.
  const bool pure =
      mode.key_faces == KeyFaces::kPure || mode.field != FieldSize::kSamples || !mode.compensation.index_test;
  if (mixed && !pure && mode.key_faces == KeyFaces::kTwo) second_.emplace();
  for (int k = 0; k < kKeys; ++k) {
    const DrawnFrame frame = draw_frame(*frames_.keys[k], {frames_.format, mode.shading, mode.texture});
    key_colours_[k] = averaged(frame.colour, frame.width, frame.height, mode.samples);
    if (mode.key_scale > mode.samples) {
      const Drawn fine = drawn(mode.width * mode.key_scale, mode.height * mode.key_scale);
      keys_[k] = key_frame(draw_frame(*fine.keys[k], {fine.format, mode.shading, mode.texture}), 1, identities_);
      continue;
    }
    const int samples = mode.samples / mode.key_scale;
    keys_[k] = pure ? pure_key_frame(frame, samples, identities_) : key_frame(frame, samples, identities_);
    if (second_) (*second_)[k] = second_key_frame(frame, samples, identities_);
    if (mode.samples == 1 || mode.field == FieldSize::kSamples) continue;
    // A pixel has one vector, so it goes by what it shows in its middle.
    const Drawn middle = drawn(mode.width, mode.height);
    const DrawnFrame shown = draw_frame(*middle.keys[k], {middle.format, ShadingMode::kFlat, {}});
    for (std::size_t at = 0; at < shown.face.size(); ++at) keys_[k].identity[at] = identities_[shown.face[at]];
  }
}

Interval::Drawn Interval::drawn(int width, int height) const {
  Drawn out{{width, height, mode_.format.range_bits, mode_.format.subpixel_bits}, mode_.format, {}};
  out.format.width = width, out.format.height = height;
  for (int k = 0; k < kKeys; ++k) out.keys[k] = std::make_unique<Geometry>(scenes_[k], out.view);
  return out;
}

FrameBetween Interval::at(const Scene& between, double a) {
  Geometry whole(between, frames_.view);
  const DrawnFrame frame = draw_frame(whole, {frames_.format, mode_.shading, mode_.texture});
  FrameBetween out;
  out.rendered = averaged(frame.colour, frame.width, frame.height, mode_.samples);

  const Between motion = follow(mode_.method, scenes_[0], scenes_[1], between, a, field_.view);
  MotionField field = motion_field(motion, field_.format, mode_.mapping);
  const std::uint64_t still = mode_.static_buffer ? leave_out_static(between, field) : 0;
  LightPlanes light;
  if (mode_.relight) {
    Geometry lit(between, field_.view);
    OfKeys<LightChange> change;
    for (int k = 0; k < kKeys; ++k)
      change[k] = light_change(lit, *field_.keys[k], field_.format.colour_bits, mode_.texture.has_value());
    light = light_planes(motion, field, field_.format, change);
  }
  if (mode_.field == FieldSize::kHalf) {
    light = doubled(light, field.width, field.height);
    field = doubled(field);
  }
  const bool by_samples = mode_.field == FieldSize::kSamples;
  Compensated made = compensate(keys_, field, identities_, a, mode_.compensation, light,
                                by_samples ? frame.colour : out.rendered, second_ ? &*second_ : nullptr);
  out.colour = by_samples ? averaged(made.colour, field.width, field.height, mode_.samples) : std::move(made.colour);
  out.shares = made.shares;
  out.of_keys =
      made_of_keys(made.keys, field.face, field.width, field.height, by_samples ? mode_.samples : 1, out.shares);
  out.shares.background -= still, out.shares.still = still;
  return out;
}

std::uint64_t Interval::leave_out_static(const Scene& between, MotionField& field) const {
  const double aspect = double(mode_.width) / mode_.height;
  const std::vector<bool> still = static_instances(scenes_[0], scenes_[1], between, aspect);
  const std::vector<std::uint32_t> instance = instances_of_faces(between);
  std::uint64_t pixels = 0;
  for (std::uint32_t& face : field.face) {
    if (face == 0 || !still[instance[face]]) continue;
    face = 0, ++pixels;
  }
  return pixels;
}

Colours temporal_average(const Colours& first, const Colours& second) {
  Colours out = first;
  for (std::size_t at = 0; at < out.size(); ++at) {
    for (int c = 0; c < 3; ++c) out[at][c] = std::uint8_t((first[at][c] + second[at][c] + 1) / 2);
  }
  return out;
}

const Colours& repeated(const Colours& first, const Colours& second, double a) { return a <= 0.5 ? first : second; }

}  // namespace halfspace::ref
