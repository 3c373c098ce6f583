// SPDX-License-Identifier: Apache-2.0
// Frames between key frames by the kernels, on the animations that stand for the paper's: how near they are to the
// rendered ones, and to what the floating-point reference makes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "model/drivers/up_convert.hpp"
#include "model/texture/texture.hpp"
#include "ref/error.hpp"
#include "ref/motion/quality.hpp"
#include "tests/config_path.hpp"

namespace halfspace {
namespace {

using model::Configuration;
using model::KernelUpConverter;

constexpr double kRate = 30;

// Of the paper, dB, for the animation that ours stands for; and a key frame after which much moves.
struct Animation {
  const char* scene;
  double printed;
  int first;
};
constexpr Animation kAnimations[] = {
    {"drone", 36.17, 25},      {"jet", 34.54, 25},          {"cube_zoom", 33.53, 5},     {"cube_fast", 29.97, 20},
    {"cube_slow", 31.05, 20},  {"pyramid_fast", 33.56, 20}, {"pyramid_slow", 31.54, 20}, {"wheel_in_out", 39.91, 10},
    {"wheel_turn", 34.05, 20}, {"ring_fall", 26.64, 20}};

struct Kind {
  const char* name;
  const char* config;
  bool textured;
  int samples, width, height;
  std::vector<int> between;  // of four
  double least;              // dB, mean over the animations
  int key_scale = 1;
  double most_rendered = 1;  // of the covered pixels, of each animation
  double least_alone = 0;    // dB, of the pixels that are made of keys alone, mean over the animations
};

Configuration colour_of(const Kind& kind) {
  const std::string name = kind.config;
  const bool built_in = name == "low" || name == "middle" || name == "high";
  const Configuration named = model::find_configuration(built_in ? name : config_path(name));
  return kind.textured ? model::textured_configuration(named, TextureFilter::kBilinear) : named;
}

ref::Scene scene_at(const Animation& animation, int n, const Config& colour) {
  ref::Scene scene = ref::load_scene(animation.scene, (animation.first + n) / kRate, {has_texture(colour)});
  if (has_texture(colour)) model::fit_textures(scene, colour);
  return scene;
}

ref::UpConversion reference_of(const Kind& kind, const Configuration& colour) {
  ref::UpConversion mode{kind.width, kind.height, model::raster_format(colour)};
  mode.samples = kind.samples;
  mode.key_scale = kind.key_scale;
  mode.mapping = ref::VectorMapping::kPerspective;
  mode.relight = true;
  if (is_phong(colour.config())) mode.shading = ref::ShadingMode::kPhong;
  if (kind.textured) mode.texture = ref::TextureMode{};
  return mode;
}

class UpConversion : public testing::TestWithParam<Kind> {};

TEST_P(UpConversion, IsNearToWhatIsRendered) {
  const Kind& kind = GetParam();
  const Configuration colour = colour_of(kind);
  Config numbers = model::default_motion(colour.config());
  numbers.samples = std::max(1, kind.samples / kind.key_scale);
  const Configuration motion =
      model::motion_configuration(colour, numbers, kind.width * kind.samples, kind.height * kind.samples);
  model::KernelUpConversion mode{kind.width, kind.height, colour, motion};
  mode.samples = kind.samples, mode.key_scale = kind.key_scale;
  KernelUpConverter kernels(mode);
  double kernel_mean = 0, reference_mean = 0, average_mean = 0, alone_mean = 0;
  for (const Animation& animation : kAnimations) {
    const ref::Scene first = scene_at(animation, 0, colour.config()), second = scene_at(animation, 5, colour.config());
    kernels.set_keys(first, second);
    ref::Interval interval(first, second, reference_of(kind, colour));
    ref::MeanQuality made, reference, average;
    std::uint64_t covered = 0, words = 0, pixels = 0, rendered = 0;
    double alone = 0;
    for (const int n : kind.between) {
      const ref::Scene between = scene_at(animation, n, colour.config());
      const model::KernelFrameBetween frame = kernels.at(between, n / 5.0);
      const auto against = [&](const ref::Colours& picture) {
        return ref::quality(picture, frame.rendered, kind.width, kind.height);
      };
      made.add(against(frame.colour));
      average.add(against(ref::temporal_average(kernels.key_colour(0), kernels.key_colour(1))));
      const ref::FrameBetween exact = interval.at(between, n / 5.0);
      reference.add(ref::quality(exact.colour, exact.rendered, kind.width, kind.height));
      covered += frame.shares.blended + frame.shares.copied + frame.shares.filled;
      words += frame.words;
      pixels += frame.shares.pixels, rendered += frame.shares.rendered;
      alone += ref::psnr_y_of(frame.colour, frame.rendered, frame.of_keys).value() / double(kind.between.size());
    }
    EXPECT_EQ(covered, words);
    const double psnr = made.mean().psnr_y;
    std::printf(
        "%-12s %-22s average %6.2f, reference %6.2f, kernels %6.2f dB, alone %6.2f, %.2f %% rendered, %.4f %% of "
        "blocks under 20 dB\n",
        animation.scene, kind.name, average.mean().psnr_y, reference.mean().psnr_y, psnr, alone,
        100.0 * double(rendered) / double(pixels), 100 * made.mean().blocks[0]);
    EXPECT_LE(double(rendered), kind.most_rendered * double(pixels)) << animation.scene;
    alone_mean += alone / std::size(kAnimations);
    EXPECT_GE(psnr, animation.printed) << animation.scene;
    EXPECT_GT(psnr, average.mean().psnr_y + 8) << animation.scene;
    if (kind.samples == 1) {
      EXPECT_LT(made.mean().blocks[0], 0.0005) << animation.scene;
    }
    kernel_mean += psnr / std::size(kAnimations);
    reference_mean += reference.mean().psnr_y / std::size(kAnimations);
    average_mean += average.mean().psnr_y / std::size(kAnimations);
  }
  std::printf("%s: mean %.2f dB, reference %.2f, temporal average %.2f\n", kind.name, kernel_mean, reference_mean,
              average_mean);
  EXPECT_GE(kernel_mean, kind.least);
  EXPECT_GE(alone_mean, kind.least_alone);
  EXPECT_LE(reference_mean - kernel_mean, kind.key_scale == 1 ? 0.3 : 0.5);
}

INSTANTIATE_TEST_SUITE_P(Kinds, UpConversion,
                         testing::Values(Kind{"gouraud", "middle", false, 1, 320, 240, {1, 2, 3, 4}, 60},
                                         Kind{"lit", "lit_middle", false, 1, 320, 240, {2}, 70},
                                         Kind{"phong", "phong_middle", false, 1, 320, 240, {2}, 70},
                                         Kind{"phong_textured", "phong_middle", true, 1, 320, 240, {2}, 45},
                                         Kind{"textured", "middle", true, 1, 320, 240, {1, 2, 3, 4}, 46},
                                         Kind{"supersampled", "high", false, 4, 160, 120, {2}, 56},
                                         Kind{"supersampled_textured", "high", true, 4, 320, 240, {2}, 47},
                                         Kind{"finer", "middle", true, 1, 320, 240, {2}, 50, 2, 0.03, 44},
                                         Kind{"finer_gouraud", "middle", false, 1, 320, 240, {2}, 60, 2, 0.03, 60},
                                         Kind{"finer_supersampled", "high", true, 4, 320, 240, {2}, 50, 2, 0.1, 45}),
                         [](const auto& info) { return std::string(info.param.name); });

// Where a texture moves: light alone hides how exact a place is, as its difference is added.
TEST(UpConversionFormats, FewBitsCostQuality) {
  const Kind kind{"textured", "middle", true, 1, 320, 240, {2}, 0};
  const Configuration colour = colour_of(kind);
  const Animation& animation = kAnimations[3];  // large faces that turn
  const auto psnr = [&](void (*change)(Config&), bool half) {
    Config numbers = model::default_motion(colour.config());
    change(numbers);
    KernelUpConverter kernels(
        {320, 240, colour, model::motion_configuration(colour, numbers, 320, 240), ref::MotionMethod::kExact, half});
    kernels.set_keys(scene_at(animation, 0, colour.config()), scene_at(animation, 5, colour.config()));
    const auto frame = kernels.at(scene_at(animation, 2, colour.config()), 0.4);
    return ref::quality(frame.colour, frame.rendered, 320, 240).psnr_y;
  };
  const double enough = psnr([](Config&) {}, false);
  EXPECT_LT(psnr([](Config& c) { c.vector_fraction = 1; }, false), enough - 0.5);
  EXPECT_LT(psnr([](Config& c) { c.weight_bits = 2; }, false), enough - 0.2);
  EXPECT_LT(psnr([](Config& c) { c.relight = 0; }, false), enough - 0.2);
  EXPECT_LT(psnr([](Config&) {}, true), enough - 8);  // half a field
}

TEST(UpConversionFormats, RefusesWhatDoesNotFit) {
  const Configuration middle = model::find_configuration("middle"), low = model::find_configuration("low");
  Config numbers = model::default_motion(low.config());
  const Configuration motion = model::motion_configuration(low, numbers, 320, 200);
  try {
    const KernelUpConverter converter({320, 200, middle, motion});
    FAIL() << "middle and low share no grid";
  } catch (const ref::Error& e) {
    EXPECT_NE(std::string(e.what()).find("range_bits differs"), std::string::npos) << e.what();
  }
  numbers.samples = 2;
  EXPECT_THROW(KernelUpConverter({160, 100, low, model::motion_configuration(low, numbers, 320, 200),
                                  ref::MotionMethod::kExact, true}),
               ref::Error);
  model::KernelUpConversion lit{160, 100, model::find_configuration(config_path("lit_low")), motion};
  lit.static_buffer = true;
  EXPECT_THROW(KernelUpConverter{lit}, ref::Error);
}

}  // namespace
}  // namespace halfspace
