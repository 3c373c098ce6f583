// SPDX-License-Identifier: Apache-2.0
#include "cli/common/fit_between.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "cli/commands.hpp"
#include "cli/common/cosim.hpp"
#include "cli/common/output.hpp"
#include "cli/common/progress.hpp"
#include "cli/common/scene_input.hpp"
#include "ref/error.hpp"
#include "study/fit/fit_motion.hpp"
#include "vectors/staging.hpp"

namespace halfspace::cli {
namespace {

model::MotionInput input_of(const BetweenOptions& options) {
  const FrameInput& in = options.input;
  if (ref::is_tri_file(in.scene) || in.views > 1)
    throw ref::Error(fmt::format("{}: --keys is of an animated scene, from one side: leave out --views", in.scene));
  const FrameSize size = parse_size(in.size);
  const auto source = std::make_shared<SceneSource>(in.scene, in.choice);
  const double duration = source->at(0).duration;
  if (duration <= 0) throw ref::Error(fmt::format("{}: nothing moves in it: take an animated scene", in.scene));
  std::pair<int, int> range{0, int(std::floor(duration * in.rate))};
  if (!in.frames.empty()) range = parse_range(in.frames);
  return {[source](double seconds) { return source->at(seconds); },
          in.rate,
          range.first,
          range.second,
          options.keys,
          size.width,
          size.height};
}

Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json json_of(const model::MotionTrade& t) {
  return {{"frames_between", t.frames},
          {"psnr_db", finite(t.psnr)},
          {"reference_psnr_db", finite(t.reference_psnr)},
          {"worst_reference_psnr_db", finite(t.worst_reference_psnr)},
          {"wrong_pixels", t.wrong_pixels},
          {"colour_largest_lsb", t.colour_largest}};
}

void print(const model::MotionTrade& t) {
  fmt::print(
      "{:.2f} dB against the reference's frames in between, the worst of {}; {} pixels off by more than {} LSB, the "
      "others by {} at most; {:.2f} dB against the frames as rendered\n",
      t.worst_reference_psnr, t.frames, t.wrong_pixels, model::kWrongLsb, t.colour_largest, t.psnr);
}

}  // namespace

void fit_between(const BetweenOptions& options) {
  std::optional<model::StagedFile> output;  // before the work: whether it can be written
  if (!options.output.empty()) output.emplace(options.output);
  const model::MotionInput input = input_of(options);
  const std::string name = "fit_motion";
  Config filter{};
  model::set_choice(filter, "filter", options.filter);
  Progress progress("fit " + options.input.scene + ": configurations tried");
  const model::MotionFit found = model::fit_motion(input, name, options.goal, filter.filter,
                                                   [&](std::uint64_t tried) { progress.tell(tried, tried); });
  fmt::print("{}: {} frames made for each key frame, what is to be least: {}\n", options.input.scene, options.keys,
             options.cost);
  fmt::print("{} configurations tried, {} from which nothing can be taken\n", found.tried, found.ends);
  print(found.outcome);
  const Config c = found.configuration.config();
  fmt::print("\n");
  for (const model::ConfigField& field : model::config_fields()) {
    if (has_part(field.part, c)) fmt::print("{:<20} {:>11}\n", field.name, field.text(c));
  }
  fmt::print("\na step less:\n");
  for (const auto& less : found.less) fmt::print("  {:<26} {}\n", less.change, less.result);

  // By other lanes, with the triangles that there are.
  const model::MotionTrade again = model::measure_motion(input, found.configuration, 4);
  Json proof = json_of(again);
  fmt::print("\nmade again with 4 lanes, beside the reference with the same features: ");
  print(again);
  if (options.cosim) {
    const std::string work = options.work.empty() ? "fit_" + name : options.work;
    const Cosimulation cosim =
        cosimulate(work, options.input.scene, found.configuration, 1, model::motion_frames(input, found.configuration));
    fmt::print("co-simulated: {} words of the field, {} mismatches\n", cosim.words, cosim.mismatches);
    if (cosim.mismatches)
      throw ref::Error(
          fmt::format("{}: the RTL differs from the kernels: read {}/cosim.log", options.input.scene, work));
    proof["cosim"] = {{"words", cosim.words}, {"mismatches", cosim.mismatches}};
  }
  if (output) output->write(model::configuration_toml(found.configuration)), output->commit();
  Json less = Json::array();
  for (const auto& one : found.less) less.push_back({{"change", one.change}, {"result", one.result}});
  write_json(options.json, {{"scene", options.input.scene},
                            {"keys", options.keys},
                            {"tried", found.tried},
                            {"ends", found.ends},
                            {"cost", found.cost},
                            {"configuration", to_json(c)},
                            {"outcome", json_of(found.outcome)},
                            {"one_bit_less", less},
                            {"proof", proof}});
}

}  // namespace halfspace::cli
