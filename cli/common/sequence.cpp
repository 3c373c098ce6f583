// SPDX-License-Identifier: Apache-2.0
#include "cli/common/sequence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "cli/common/numbers.hpp"
#include "cli/common/progress.hpp"
#include "cli/common/scene_input.hpp"
#include "model/drivers/up_convert.hpp"
#include "model/texture/texture.hpp"
#include "ref/error.hpp"
#include "ref/geometry/viewpoint.hpp"
#include "ref/motion/foresee.hpp"
#include "ref/motion/quality.hpp"

namespace halfspace::cli {
namespace {

constexpr int kMostBetween = 9, kMostMeasured = 4;

// By the reference or the kernels.
class Converter {
 public:
  virtual ~Converter() = default;
  virtual void set_keys(const ref::Scene& first, const ref::Scene& second) = 0;
  virtual const ref::Colours& key(int k) const = 0;
  // All but the number and the baselines.
  virtual SequenceFrame at(const ref::Scene& between, double a) = 0;
};

class ReferenceConverter : public Converter {
 public:
  explicit ReferenceConverter(const ref::UpConversion& mode) : mode_(mode) {}

  void set_keys(const ref::Scene& first, const ref::Scene& second) override {
    interval_ = std::make_unique<ref::Interval>(first, second, mode_);
  }
  const ref::Colours& key(int k) const override { return interval_->key_colour(k); }
  SequenceFrame at(const ref::Scene& between, double a) override {
    ref::FrameBetween made = interval_->at(between, a);
    SequenceFrame out;
    out.shown = std::move(made.colour);
    out.rendered = std::move(made.rendered);
    out.of_keys = std::move(made.of_keys);
    out.shares = made.shares;
    return out;
  }

 private:
  const ref::UpConversion mode_;
  std::unique_ptr<ref::Interval> interval_;
};

class KernelConverter : public Converter {
 public:
  explicit KernelConverter(const model::KernelUpConversion& mode) : converter_(mode) {}

  void set_keys(const ref::Scene& first, const ref::Scene& second) override { converter_.set_keys(first, second); }
  const ref::Colours& key(int k) const override { return converter_.key_colour(k); }
  SequenceFrame at(const ref::Scene& between, double a) override {
    model::KernelFrameBetween made = converter_.at(between, a);
    SequenceFrame out;
    out.shown = std::move(made.colour);
    out.rendered = std::move(made.rendered);
    out.of_keys = std::move(made.of_keys);
    out.shares = made.shares;
    out.work = {made.triangles, made.static_triangles, made.words, made.misses[0] + made.misses[1],
                made.cycles,    made.second_words};
    return out;
  }

 private:
  model::KernelUpConverter converter_;
};

std::unique_ptr<Converter> reference_converter(const SequenceOptions& options, const FrameSize& size,
                                               const ref::RasterFormat& format) {
  ref::UpConversion mode{size.width, size.height, format};
  mode.samples = options.samples;
  mode.shading = kind_of(ref::kShadingModes, options.shading);
  if (options.texture != "none") {
    mode.texture =
        ref::TextureMode{options.texture == "nearest" ? ref::TextureFilter::kNearest : ref::TextureFilter::kBilinear};
  }
  mode.method = options.method == "straight" ? ref::MotionMethod::kStraight : ref::MotionMethod::kExact;
  const bool linear = options.mapping == "affine" || options.method == "straight";
  mode.mapping = linear ? ref::VectorMapping::kLinear : ref::VectorMapping::kPerspective;
  if (!options.filter.empty()) mode.compensation.filter = kind_of(ref::kFilters, options.filter);
  mode.compensation.index_test = options.index_test;
  mode.compensation.render_holes = options.render_holes;
  mode.field = options.half            ? ref::FieldSize::kHalf
               : options.pixel_vectors ? ref::FieldSize::kPixels
                                       : ref::FieldSize::kSamples;
  mode.surfaces = options.surfaces;
  mode.key_faces = kind_of(ref::kKeyFaces, options.key_faces);
  mode.key_scale = options.key_scale;
  mode.relight = options.relight && options.method == "exact";
  mode.static_buffer = options.static_buffer;
  return std::make_unique<ReferenceConverter>(mode);
}

// The configuration that draws frames of this size, with texture if it is asked for.
model::Configuration colour_configuration(const SequenceOptions& options, const FrameSize& size) {
  const int scale = std::max(options.samples, options.key_scale);
  const auto fits = [&](const model::Configuration& c) {
    return size.width * scale <= c.config().width && size.height * scale <= c.config().height;
  };
  model::Configuration chosen = model::find_configuration(options.config.empty() ? "middle" : options.config);
  if (options.config.empty() && !fits(chosen)) chosen = model::find_configuration("high");
  if (!fits(chosen)) {
    throw ref::Error(fmt::format(
        "--size {}: with {} samples or pixels of a key frame for a pixel each way it is more than configuration {} "
        "draws: take a smaller one, or a larger configuration",
        options.size, scale, chosen.name()));
  }
  if (options.texture == "none" || has_texture(chosen.config())) return chosen;
  return model::textured_configuration(
      chosen, options.texture == "nearest" ? TextureFilter::kNearest : TextureFilter::kBilinear);
}

// "weight_bits=4"
void set_number(Config& config, const std::string& text) {
  const std::size_t sign = text.find('=');
  std::string known;
  for (const model::ConfigField& field : model::config_fields()) {
    if (!field.is_number() || (field.part != Part::kCoordinates && field.part != Part::kMotion)) continue;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", field.name);
    if (sign == std::string::npos || text.compare(0, sign, field.name) != 0 || text.size() == sign + 1) continue;
    if (text.find_first_not_of("0123456789", sign + 1) != std::string::npos || text.size() > sign + 7) break;
    field.set(config, std::stoi(text.substr(sign + 1)));
    return;
  }
  throw ref::Error(fmt::format("--set {}: no number of the motion: write it like weight_bits=4, of {}", text, known));
}

model::Configuration motion_of(const SequenceOptions& options, const FrameSize& size,
                               const model::Configuration& colour, const ref::Scene& scene) {
  if (!options.motion.empty()) {
    Config numbers = model::find_configuration(options.motion).config();
    for (const std::string& text : options.set) set_number(numbers, text);
    return model::Configuration(numbers.name, numbers);
  }
  Config numbers = model::default_motion(colour.config(), &scene);
  if (!options.filter.empty()) model::set_choice(numbers, "filter", options.filter);
  if (!options.mapping.empty()) model::set_choice(numbers, "mapping", options.mapping);
  if (options.method == "straight") numbers.mapping = TextureMapping::kAffine;
  numbers.relight = options.relight && options.method == "exact" ? 1 : 0;
  numbers.samples = std::max(1, options.samples / options.key_scale);
  for (const std::string& text : options.set) set_number(numbers, text);
  return model::motion_configuration(colour, numbers, size.width * options.samples, size.height * options.samples);
}

// Frames between two keys; or as many as keep a PSNR, as it is foreseen or as it is measured.
constexpr int kForeseen = 0, kMeasured = -1;
int between_of(const std::string& keys) {
  if (keys == "auto") return kForeseen;
  if (keys == "measured") return kMeasured;
  if (keys.size() == 3 && keys.compare(0, 2, "1:") == 0 && keys[2] >= '1' && keys[2] <= '0' + kMostBetween)
    return keys[2] - '0';
  throw ref::Error(fmt::format("--keys {}: one key frame to how many in between: write 1:1 … 1:{}, auto or measured",
                               keys, kMostBetween));
}

}  // namespace

void add(ref::Shares& sum, const ref::Shares& shares) {
  sum.background += shares.background, sum.blended += shares.blended;
  sum.copied += shares.copied, sum.filled += shares.filled, sum.still += shares.still;
  sum.pixels += shares.pixels, sum.rendered += shares.rendered;
}

void add(Work& sum, const Work& work) {
  sum.triangles += work.triangles, sum.static_triangles += work.static_triangles;
  sum.words += work.words, sum.tiles += work.tiles, sum.cycles += work.cycles;
  sum.second_words += work.second_words;
}

void add_sequence_options(CLI::App* command, SequenceOptions& o) {
  command->add_option("SCENE", o.scene, "an animated scene (" + builtin_names() + ") or a mesh file with an animation")
      ->required();
  add_scene_choice(command, o.choice);
  command
      ->add_option("--keys", o.keys,
                   "key frames to frames in between, 1:1 … 1:9; auto: as many in between as keep --psnr as the motion "
                   "foresees it, before they are rendered; measured: as it comes out, up to 1:4")
      ->capture_default_str();
  command
      ->add_option("--psnr", o.psnr,
                   "dB that each frame in between has to keep against its rendered one, with --keys auto and measured")
      ->capture_default_str()
      ->check(finite());
  command->add_option("--engine", o.engine, "ref: floating-point reference; hls: fixed-point kernels")
      ->check(CLI::IsMember({"ref", "hls"}))
      ->capture_default_str();
  command->add_option("--config", o.config,
                      "of the frames: low, middle, high or a .toml file; default: middle, or high for a large frame");
  command->add_option("--motion", o.motion,
                      "of the motion: a .toml file with shading = \"motion\"; default: made for --config");
  command->add_option("--set", o.set, "a number of the motion's configuration, like weight_bits=4");
  command->add_option("--size", o.size, "frame, WxH")->capture_default_str();
  command->add_option("--first", o.first, "first frame of the animation")->capture_default_str()->check(zero_or_more());
  command->add_option("--frames", o.frames, "how many; default: to the end of the animation")->check(above_zero());
  command->add_option("--zoom", o.zoom, "everything so many times as large in the frame")
      ->capture_default_str()
      ->check(CLI::Range(1e-3, 1e3));
  command->add_option("--speed", o.speed, "the animation so many times as fast")
      ->capture_default_str()
      ->check(CLI::Range(1e-3, 1e3));
  command
      ->add_option("--filter", o.filter,
                   "of key frames; footprint, for --engine ref: over the pixel as the motion stretches it")
      ->check(CLI::IsMember({"nearest", "bilinear", "area", "bicubic", "footprint"}));
  command->add_option("--mapping", o.mapping, "of places in key frames: affine on the screen, or perspective (default)")
      ->check(CLI::IsMember({"affine", "perspective"}));
  command
      ->add_option("--method", o.method,
                   "exact: where each vertex is; straight: on the line between its places in the key frames")
      ->check(CLI::IsMember({"exact", "straight"}))
      ->capture_default_str();
  command->add_option("--texture", o.texture, "draw the textures; built-in animations are of bricks then")
      ->check(CLI::IsMember({"none", "nearest", "bilinear"}))
      ->capture_default_str();
  command->add_option("--samples", o.samples, "of a pixel each way: 1, 2, 4")
      ->check(CLI::IsMember({1, 2, 4}))
      ->capture_default_str();
  command
      ->add_option("--key-scale", o.key_scale,
                   "pixels of a key frame for one of a frame, each way: 1, 2, 4; finer than --samples, keys are drawn "
                   "for themselves")
      ->check(CLI::IsMember({1, 2, 4}))
      ->capture_default_str();
  command
      ->add_option("--key-faces", o.key_faces,
                   "what a key pixel keeps whose samples show several faces: pure, nothing; most, the face that most "
                   "of them show; two, the next one as well")
      ->check(CLI::IsMember({"pure", "most", "two"}))
      ->capture_default_str();
  command->add_flag("--relight,!--no-relight", o.relight, "add what the light changes between the keys (default)");
  command->add_flag("--half", o.half, "a motion vector for 2x2 pixels");
  command->add_flag("--static-buffer", o.static_buffer,
                    "keep what stands still between two keys in an S-buffer, and set up, vector and compensate what "
                    "moves alone: the viewpoint "
                    "has to rest");
  command->add_flag("!--no-index-test", o.index_test,
                    "for --engine ref: take what lies in the place, whatever face it shows");
  command->add_flag("!--no-render-holes", o.render_holes,
                    "for --engine ref: take what no key shows from what lies in the place");
  command->add_flag("--surfaces", o.surfaces, "for --engine ref: pixels match by smooth surfaces, not by faces");
}

namespace {

Sequence run_with(const SequenceOptions& options, const std::function<void(const SequenceFrame&)>& sink) {
  const int fill = between_of(options.keys);
  const FrameSize size = parse_size(options.size);
  const bool textured = options.texture != "none";
  if (options.static_buffer && (options.half || options.method != "exact")) {
    throw ref::Error(
        "--static-buffer: what moves is held against its depths, a sample at a time: leave out --half and --method "
        "straight");
  }
  const SceneSource source(options.scene, options.choice, textured);
  const double aspect = double(size.width) / size.height;
  const auto scene_at = [&](int number) {
    ref::Scene at = source.at(options.speed * double(options.first + number) / kFramesASecond);
    if (options.zoom != 1) ref::zoom(at, options.zoom, aspect);
    return at;
  };
  const ref::Scene scene = scene_at(0);
  if (scene.duration <= 0)
    throw ref::Error(fmt::format("{}: nothing moves in it: take an animated scene", options.scene));
  const int all = int(std::floor(scene.duration / options.speed * kFramesASecond)) + 1 - options.first;
  const int frames = options.frames ? std::min(options.frames, all) : all;
  if (frames < 3)
    throw ref::Error(fmt::format("{}: {} frames from --first on, and two keys with one in between are 3: take more",
                                 options.scene, std::max(frames, 0)));

  const model::Configuration colour = colour_configuration(options, size);
  Sequence out{size.width, size.height, frames, {}, colour.name(), ""};
  std::optional<ref::DepthPlanes> planes;
  for (int n = 0; n < frames && (options.static_buffer || options.held_planes); ++n) {
    const ref::DepthPlanes at = ref::depth_planes(scene_at(n), aspect);
    planes = planes ? ref::joined(*planes, at) : at;
  }
  const auto fitted = [&](int number) {
    ref::Scene at = scene_at(number);
    at.depth_planes = planes;
    if (has_texture(colour.config())) model::fit_textures(at, colour.config());
    return at;
  };
  if (fill == kForeseen && (textured || has_texture(colour.config()) || options.samples != 1 || !options.relight ||
                            options.method != "exact" || options.half)) {
    throw ref::Error(
        "--keys auto: foreseen are frames without textures, of a sample a pixel, relit, of exact and whole motion: "
        "take "
        "--keys measured");
  }
  const Config numbers = colour.config();
  const ref::View view{size.width * options.samples, size.height * options.samples, numbers.range_bits,
                       numbers.subpixel_bits};
  const auto foreseen = [&](const ref::Scene& first, const ref::Scene& last, const ref::Scene& between, double a) {
    ref::Geometry lit(between, view);
    const ref::Between motion = ref::follow(ref::MotionMethod::kExact, first, last, between, a, view);
    return ref::foreseen_psnr_y(ref::moving_gradient(motion, lit, view));
  };
  std::unique_ptr<Converter> converter;
  if (options.engine == "ref") {
    converter = reference_converter(options, size, model::raster_format(colour));
  } else {
    if (!options.index_test || options.surfaces || !options.render_holes)
      throw ref::Error("--no-index-test, --surfaces, --no-render-holes: the kernels go by faces: take --engine ref");
    if (options.filter == "footprint")
      throw ref::Error("--filter footprint: the kernels' filters are of a fixed size: take --engine ref");
    const model::Configuration motion = motion_of(options, size, colour, scene);
    tell_if_faces_share(scene, motion.config());
    out.motion = motion.name();
    out.tile_bytes = 64 * model::key_pixel_bits(motion.config()) / 8;
    const auto method = options.method == "straight" ? ref::MotionMethod::kStraight : ref::MotionMethod::kExact;
    model::KernelUpConversion mode{size.width, size.height, colour, motion, method, options.half};
    mode.static_buffer = options.static_buffer;
    mode.samples = options.motion.empty() ? options.samples : 0;
    mode.key_scale = options.key_scale;
    mode.key_faces = kind_of(ref::kKeyFaces, options.key_faces);
    converter = std::make_unique<KernelConverter>(mode);
  }

  Progress progress(options.scene);
  ref::Scene first = fitted(0);
  for (int key = 0; key < frames;) {
    out.keys.push_back(key);
    if (key + 1 == frames) break;
    std::vector<SequenceFrame> between;
    ref::Scene last;
    const int most = fill == kForeseen ? kMostBetween : fill == kMeasured ? kMostMeasured : fill;
    int count = std::min(most, frames - 2 - key);
    for (; fill == kForeseen && count > 1; --count) {
      const int middle = (count + 1) / 2;
      if (foreseen(first, fitted(key + count + 1), fitted(key + middle), double(middle) / (count + 1)) >= options.psnr)
        break;
    }
    for (bool kept = false; !kept; --count) {
      between.clear();
      last = fitted(key + count + 1);
      converter->set_keys(first, last);
      kept = true;
      for (int n = 1; n <= count && kept; ++n) {
        const ref::Scene now = fitted(key + n);
        SequenceFrame& frame = between.emplace_back(converter->at(now, double(n) / (count + 1)));
        frame.number = key + n;
        if (fill == kForeseen || options.foresee) frame.foreseen = foreseen(first, last, now, double(n) / (count + 1));
        if (fill == kMeasured)
          kept = ref::quality(frame.shown, frame.rendered, size.width, size.height).psnr_y >= options.psnr;
        progress.tell(std::size_t(key + n), std::size_t(frames));
      }
      if (kept) break;
    }
    SequenceFrame shown;
    shown.number = key;
    shown.is_key = true;
    shown.shown = shown.rendered = converter->key(0);
    sink(shown);
    for (SequenceFrame& frame : between) {
      const double a = double(frame.number - key) / double(between.size() + 1);
      frame.average = ref::temporal_average(converter->key(0), converter->key(1));
      frame.repeat = ref::repeated(converter->key(0), converter->key(1), a);
      sink(frame);
    }
    key += int(between.size()) + 1;
    first = std::move(last);
    if (key + 1 == frames) {
      shown.number = key;
      shown.shown = shown.rendered = converter->key(1);
      sink(shown);
    }
  }
  return out;
}

}  // namespace

Sequence run_sequence(const SequenceOptions& options, const std::function<void()>& begin,
                      const std::function<void(const SequenceFrame&)>& sink) {
  begin();
  try {
    return run_with(options, sink);
  } catch (const ref::Misfit& misfit) {
    if (!options.config.empty() || !options.motion.empty())
      throw ref::Error(fmt::format("{}: {}", options.scene, misfit.what()));
  }
  SequenceOptions larger = options;
  larger.config = "high";
  return run_sequence(larger, begin, sink);
}

}  // namespace halfspace::cli
