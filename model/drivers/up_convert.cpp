// SPDX-License-Identifier: Apache-2.0
#include "model/drivers/up_convert.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "model/motion/motion.hpp"
#include "model/shade/frame_lighting.hpp"
#include "model/shade/lighting.hpp"
#include "model/texture/texture.hpp"
#include "ref/error.hpp"
#include "ref/objects/static_instances.hpp"
#include "ref/raster/ideal.hpp"

namespace halfspace::model {
namespace {

// Those that the place of a vertex, the coverage and the depth of a pixel follow from.
constexpr int Config::*const kShared[] = {&Config::range_bits,  &Config::subpixel_bits,   &Config::depth_bits,
                                          &Config::colour_bits, &Config::reciprocal_bits, &Config::depth_fraction};

// Colours of a picture as a key frame holds them; the inverse of ref::displayed_colour.
std::uint8_t stored_colour(std::uint8_t displayed, int bits) {
  const unsigned full = (1u << bits) - 1;
  return std::uint8_t((displayed * full + 127) / 255);
}

// Fraction bits of the gradients of planes of b bits that are accepted; 40 where none are.
int least_fraction(const Config& config, int b) {
  int g = 0;
  while (g < 40 && !plane_error_ok(config, b, g)) ++g;
  return g;
}

// Half a field, of a word for 2 × 2 pixels of the frame.
std::vector<RawMotion> doubled(const std::vector<RawMotion>& field, int width, int height, const Config& config) {
  std::vector<RawMotion> out;
  const int most = 1 << (config.vector_range + config.vector_fraction);
  for (const RawMotion& word : field) {
    for (int n = 0; n < 4; ++n) {
      RawMotion& pixel = out.emplace_back(word);
      pixel.x = 2 * word.x + n % 2;
      pixel.y = 2 * word.y + n / 2;
      if (pixel.x >= width || pixel.y >= height) {
        out.pop_back();
        continue;
      }
      for (RawKeyVector& key : pixel.key) {
        key.x *= 2, key.y *= 2;
        if (key.x < -most || key.x >= most || key.y < -most || key.y >= most) key = {};
      }
    }
  }
  return out;
}

// Of words that go to keys so many times as fine as their pixels.
Configuration finer_configuration(const Configuration& motion, int finer) {
  if (finer == 1) return motion;
  Config c = motion.config();
  c.width *= finer, c.height *= finer;
  c.vector_range = std::min(13, c.vector_range + bits_for(unsigned(finer) - 1));
  return Configuration(motion.name() + "_finer", c);
}

// Takes the triangles of `still` instances out of what is drawn.
void leave_out(const std::vector<bool>& still, const ref::Scene& scene, ref::Between& motion,
               ref::OfKeys<ref::LightChange>& change) {
  const std::vector<std::uint32_t> instance = ref::instances_of_faces(scene);
  std::size_t kept = 0;
  for (std::size_t k = 0; k < motion.traces.size(); ++k) {
    if (still[instance[motion.list.face[k]]]) continue;
    motion.list.triangles[kept] = motion.list.triangles[k];
    motion.list.face[kept] = motion.list.face[k];
    motion.traces[kept] = motion.traces[k];
    for (ref::LightChange& of_key : change) {
      if (!of_key.empty()) of_key[kept] = of_key[k];
    }
    ++kept;
  }
  motion.list.triangles.resize(kept), motion.list.face.resize(kept), motion.traces.resize(kept);
  for (ref::LightChange& of_key : change) {
    if (!of_key.empty()) of_key.resize(kept);
  }
}

}  // namespace

int face_bits_of(const ref::Scene& scene) {
  std::size_t faces = 0;
  for (const ref::Instance& placed : scene.instances) faces += scene.meshes[placed.mesh].triangles.size();
  int bits = 1;
  while (faces >> bits != 0) ++bits;
  return bits;
}

Config default_motion(const Config& colour, const ref::Scene* numbered) {
  Config c{};
  c.filter = KeyFilter::kBilinear;
  c.mapping = TextureMapping::kPerspective;
  // A reciprocal 4 bits longer than a place leaves 7/8 of the half unit to the gradients.
  c.coordinate_bits = std::min(24, colour.reciprocal_bits - 4);
  c.vector_fraction = 5;
  c.weight_bits = 6;
  c.face_bits = numbered ? std::clamp(face_bits_of(*numbered), 16, 22) : 16;
  c.relight = 1;
  c.samples = 1;
  return c;
}

Configuration motion_configuration(const Configuration& colour, const Config& motion, int width, int height) {
  const Config c = colour.config();
  Config out = motion;
  for (const auto field : kShared) out.*field = c.*field;
  out.width = width, out.height = height;
  out.triangles = c.triangles;
  out.lanes = c.lanes;
  out.architecture = c.architecture;
  out.shading = Shading::kMotion;
  // As far as the frame is long, and gradients as fine as they have to be.
  if (out.vector_range == 0) out.vector_range = std::min(13, bits_for(std::max(width, height)));
  if (out.coordinate_fraction == 0) out.coordinate_fraction = least_fraction(out, out.coordinate_bits);
  out.colour_fraction = relights(out) ? least_fraction(out, colour_plane_bits(out)) : 0;
  return Configuration("motion_" + colour.name(), out);
}

Configuration colour_configuration(const Configuration& motion) {
  Config c = motion.config();
  clear_part(c, Part::kMotion), clear_part(c, Part::kCoordinates);
  c.shading = Shading::kGouraud;
  c.colour_fraction = least_fraction(c, c.colour_bits);
  return Configuration("colour_of_" + motion.name(), c);
}

Configuration unlit_configuration(const Configuration& lit) {
  Config c = lit.config();
  clear_part(c, Part::kLighting);
  c.shading = Shading::kGouraud;
  c.colour_fraction = least_fraction(c, c.colour_bits);
  return Configuration("unlit_" + lit.name(), c);
}

Configuration textured_configuration(const Configuration& colour, TextureFilter filter) {
  Config c = colour.config();
  c.texture = filter;
  c.mapping = TextureMapping::kPerspective;
  c.texels = 65536;
  c.textures = 32;
  c.coordinate_bits = std::min(24, c.reciprocal_bits - 2);
  c.coordinate_fraction = c.depth_fraction;
  return Configuration("textured_" + colour.name(), c);
}

ref::OfKeys<ref::LightChange> light_changes(const ref::Scene& between, const ref::OfKeys<const ref::Scene*>& keys,
                                            const ref::View& view, const Config& colour) {
  ref::OfKeys<ref::LightChange> change;
  ref::Geometry lit(between, view);
  const int bits = colour.colour_bits;
  const bool textured = has_texture(colour);
  for (std::size_t k = 0; k < keys.size(); ++k) {
    ref::Geometry key(*keys[k], view);
    change[k] = has_lighting(colour) ? ref::distant_light_change(lit, key, most_squarings(colour), bits, textured)
                                     : ref::light_change(lit, key, bits, textured);
  }
  return change;
}

KernelUpConverter::KernelUpConverter(const KernelUpConversion& mode)
    : mode_(mode),
      motion_(mode_.motion.config()),
      samples_(mode.samples ? mode.samples : motion_.samples * mode.key_scale),
      finer_(std::max(1, mode.key_scale / samples_)),
      colour_engine_(make_engine(mode.colour, mode.lanes)),
      motion_engine_(make_engine(mode.motion, mode.lanes)),
      compensator_(finer_configuration(mode.motion, finer_)),
      static_buffer_(*colour_engine_, mode_.colour) {
  const Config colour = mode.colour.config();
  for (const auto field : kShared) {
    if (colour.*field == motion_.*field) continue;
    for (const ConfigField& named : config_fields()) {
      if (named.number != field) continue;
      throw ref::Error(
          fmt::format("configurations {} and {}: {} differs, so that the field would have other edges than the frames: "
                      "take the same",
                      mode.colour.name(), mode.motion.name(), named.name));
    }
  }
  if (motion_.samples * mode.key_scale != samples_ * finer_ || (finer_ != 1 && motion_.vector_fraction == 0)) {
    throw ref::Error(
        fmt::format("configuration {}: samples = {} of a key frame's pixel, and {} for a pixel of {} samples do not go "
                    "together: the samples are the product, or 1 and the keys finer than they",
                    mode.motion.name(), motion_.samples, mode.key_scale, samples_));
  }
  if (mode.half_field && mode.key_scale != 1)
    throw ref::Error("half a field goes to key frames of the frame's own size: take a whole one for finer keys");
  if (mode.half_field && motion_.samples != 1) {
    throw ref::Error(
        fmt::format("configuration {}: half a field has no samples: take one with samples = 1", mode.motion.name()));
  }
  if (mode.static_buffer &&
      (mode.half_field || mode.method != ref::MotionMethod::kExact || !stores_depth(colour) || has_lighting(colour))) {
    throw ref::Error(fmt::format(
        "configuration {}: a static buffer needs exact motion, a vector a sample, triangles that come lit, and a "
        "Z-buffer, as what moves is held against its depths: leave it out here",
        mode.colour.name()));
  }
}

ref::View KernelUpConverter::view(int scale) const {
  return {mode_.width * scale, mode_.height * scale, motion_.range_bits, motion_.subpixel_bits};
}

ref::DrawnFrame KernelUpConverter::drawn(ref::Geometry& geometry) {
  const Config colour = mode_.colour.config();
  if (has_lighting(colour)) colour_engine_->light(frame_lighting(geometry, colour));
  if (has_texture(colour)) colour_engine_->texture(texture_frame(geometry, colour));
  const ref::TriangleList list = ref::lit_triangles(geometry);
  ref::Frame frame = colour_engine_->render(ref::snap(list, raster_format(mode_.colour)));
  for (std::uint32_t& shown : frame.index) shown = ref::face_of(list, shown);
  return {frame.width, frame.height, std::move(frame.colour), std::move(frame.index)};
}

KeyFrame KernelUpConverter::stored(const ref::KeyFrame& drawn) const {
  KeyFrame key{drawn.width, drawn.height, {}, drawn.identity};
  for (const auto& colour : drawn.colour) {
    auto& rgb = key.rgb.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) rgb[c] = stored_colour(colour[c], motion_.colour_bits);
  }
  return key;
}

void KernelUpConverter::set_keys(const ref::Scene& first, const ref::Scene& second) {
  scenes_[0].emplace(first), scenes_[1].emplace(second);
  for (std::size_t k = 0; k < 2; ++k) {
    ref::Geometry geometry(*scenes_[k], view(samples_));
    ref::DrawnFrame frame = drawn(geometry);
    key_colours_[k] = ref::averaged(frame.colour, frame.width, frame.height, samples_);
    if (finer_ != 1) {
      ref::Geometry fine(*scenes_[k], view(samples_ * finer_));
      frame = drawn(fine);
    }
    ref::Identities numbers = ref::face_identities(*scenes_[k]);
    for (std::size_t face = 1; face < numbers.size(); ++face)
      numbers[face] = std::uint32_t(face_number(std::uint32_t(face), motion_));
    const bool pure = mode_.key_faces == ref::KeyFaces::kPure;
    keys_[k] = stored((pure ? ref::pure_key_frame : ref::key_frame)(frame, motion_.samples, numbers));
    if (two_faces()) second_keys_[k] = stored(ref::second_key_frame(frame, motion_.samples, numbers));
  }
}

std::vector<RawMotion> KernelUpConverter::led_to_keys(std::vector<RawMotion> words) const {
  if (finer_ == 1) return words;
  // A sample's centre is in the middle of its key pixels: as far behind the centre of the first of these.
  const int centre = ((finer_ - 1) << motion_.vector_fraction) / 2;
  const int most = 1 << (finer_configuration(mode_.motion, finer_).config().vector_range + motion_.vector_fraction);
  for (RawMotion& word : words) {
    word.x *= finer_, word.y *= finer_;
    for (RawKeyVector& key : word.key) {
      key.x = key.x * finer_ + centre, key.y = key.y * finer_ + centre;
      if (!key.there || key.x < -most || key.x >= most || key.y < -most || key.y >= most) key = {};
    }
  }
  return words;
}

std::vector<RawMotion> KernelUpConverter::field(const ref::Scene& between, double a, const std::vector<bool>& still) {
  ref::View seen = view(samples_);
  if (mode_.half_field) seen.width /= 2, seen.height /= 2;
  ref::Between motion = ref::follow(mode_.method, *scenes_[0], *scenes_[1], between, a, seen);
  ref::OfKeys<ref::LightChange> change;
  if (relights(motion_)) {
    change = light_changes(between, {&*scenes_[0], &*scenes_[1]}, seen, mode_.colour.config());
  }
  if (!still.empty()) leave_out(still, between, motion, change);
  motion_engine_->move(motion_frame(motion, motion_, change));
  list_ = ref::snap(motion.list, raster_format(mode_.motion));
  ref::Frame frame;
  std::vector<RawMotion> words = motion_engine_->motion(list_, still.empty() ? nullptr : &frame);
  if (!still.empty()) drop_hidden(between, motion.list.face, frame, words);
  return mode_.half_field ? doubled(words, mode_.width, mode_.height, motion_) : words;
}

void KernelUpConverter::drop_hidden(const ref::Scene& between, const std::vector<std::uint32_t>& face,
                                    const ref::Frame& frame, std::vector<RawMotion>& words) const {
  const std::vector<std::uint32_t> instance = ref::instances_of_faces(between);
  const auto hidden = [&](const RawMotion& word) {
    const std::size_t at = std::size_t(word.y) * frame.width + word.x;
    return static_buffer_.hides(word.x, word.y, frame.depth[at], instance[face[frame.index[at] - 1]] + 1);
  };
  words.erase(std::remove_if(words.begin(), words.end(), hidden), words.end());
}

std::uint64_t KernelUpConverter::show_static(const std::vector<RawMotion>& words, int width,
                                             ref::Colours& colour) const {
  std::vector<bool> moving(colour.size(), false);
  for (const RawMotion& word : words) moving[std::size_t(word.y) * width + word.x] = true;
  std::uint64_t pixels = 0;
  for (std::size_t at = 0; at < colour.size(); ++at) {
    if (moving[at]) continue;
    const ref::ObjectPixel& shown = static_buffer_.at(int(at) % width, int(at) / width);
    colour[at] = shown.colour;
    pixels += shown.object() != 0;
  }
  return pixels;
}

KernelFrameBetween KernelUpConverter::at(const ref::Scene& between, double a) {
  ref::Geometry geometry(between, view(samples_));
  const ref::DrawnFrame whole = drawn(geometry);

  KernelFrameBetween out;
  std::vector<bool> still;
  if (mode_.static_buffer) {
    still = ref::static_instances(*scenes_[0], *scenes_[1], between, double(whole.width) / whole.height);
    out.static_instances = std::size_t(std::count(still.begin(), still.end(), true));
    if (out.static_instances == 0) still.clear();
    else out.static_triangles = static_buffer_.show(between, still, view(samples_));
  }
  const std::vector<RawMotion> words = field(between, a, still);
  input_ = {whole.width * finer_, whole.height * finer_, {&keys_[0], &keys_[1]}, led_to_keys(words), 0};
  input_.weight = int(std::floor((1 - a) * (1 << motion_.weight_bits) + 0.5));

  out.triangles = list_.triangles.size();
  out.words = words.size();
  out.rendered = ref::averaged(whole.colour, whole.width, whole.height, samples_);
  ref::Colours colour = whole.colour;  // holes and background
  if (!still.empty()) out.shares.still = show_static(words, whole.width, colour);
  out.shares.background = colour.size() - out.words - out.shares.still;
  std::vector<std::uint8_t> keys(colour.size(), 0);
  std::vector<std::uint32_t> shows(colour.size(), 0);
  for (const RawMotion& word : words) shows[std::size_t(word.y) * whole.width + word.x] = word.face;
  const auto place = [&](int x, int y) { return std::size_t(y / finer_) * whole.width + x / finer_; };
  const auto compensate = [&](const CompensationInput& input) {
    const CompensatedFrame made = compensator_.run(input);
    for (std::size_t k = 0; k < 2; ++k) out.misses[k] += made.misses[k];
    out.cycles += made.cycles;
    for (const CompensatedPixel& pixel : made.pixels) {
      if (pixel.keys == 0) continue;
      const std::size_t at = place(pixel.x, pixel.y);
      keys[at] = std::uint8_t(pixel.keys);
      ++(pixel.keys == 3 ? out.shares.blended : out.shares.copied);
      for (std::size_t c = 0; c < 3; ++c) colour[at][c] = ref::displayed_colour(pixel.rgb[c], motion_.colour_bits);
    }
  };
  compensate(input_);
  if (two_faces()) {
    CompensationInput again{input_.width, input_.height, {&second_keys_[0], &second_keys_[1]}, {}, input_.weight};
    for (const RawMotion& word : input_.motion) {
      if (keys[place(word.x, word.y)] == 0) again.motion.push_back(word);
    }
    out.second_words = again.motion.size();
    if (out.second_words != 0) compensate(again);
  }
  out.shares.filled = out.words - out.shares.blended - out.shares.copied;
  std::set<std::uint32_t> holes;
  for (std::size_t at = 0; at < keys.size(); ++at) {
    if (keys[at] == 0 && shows[at] != 0) holes.insert(shows[at]);
  }
  out.hole_faces.assign(holes.begin(), holes.end());
  out.colour = ref::averaged(colour, whole.width, whole.height, samples_);
  out.of_keys = ref::made_of_keys(keys, shows, whole.width, whole.height, samples_, out.shares);
  return out;
}

}  // namespace halfspace::model
