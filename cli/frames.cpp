// SPDX-License-Identifier: Apache-2.0
// halfspace frames
#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/common/output.hpp"
#include "cli/plots/sequence_quality.hpp"
#include "cli/plots/video.hpp"

namespace halfspace::cli {
namespace {

struct FramesOptions {
  SequenceOptions sequence;
  std::string output, difference, json;
  int gain = 4;
};

void frames(const FramesOptions& options) {
  const FrameSize size = parse_size(options.sequence.size);
  std::unique_ptr<FrameWriter> writer, differences;
  ref::Shares shares;
  Work work;
  int between = 0;
  const auto begin = [&] {
    const auto written = [&](const std::string& path) {
      return path.empty() ? nullptr : std::make_unique<FrameWriter>(path, size.width, size.height, kFramesASecond);
    };
    writer.reset(), differences.reset();
    writer = written(options.output), differences = written(options.difference);
    shares = {}, work = {}, between = 0;
  };
  const Sequence sequence = run_sequence(options.sequence, begin, [&](const SequenceFrame& frame) {
    const Picture shown = picture_of(frame.shown, size.width, size.height);
    writer->write(shown);
    if (differences)
      differences->write(difference_picture(shown, picture_of(frame.rendered, size.width, size.height), options.gain));
    if (frame.is_key) return;
    ++between;
    add(shares, frame.shares), add(work, frame.work);
  });
  writer->finish();
  if (differences) differences->finish();
  const double shown = std::max(1.0, double(shares.blended + shares.copied + shares.filled + shares.still));
  fmt::print(
      "{} {}: {} frames, {} keys, {} in between; of their covered pixels {:.2f} % blended, {:.2f} % copied, {:.2f} % "
      "rendered{}\n",
      options.sequence.engine, options.sequence.scene, sequence.frames, sequence.keys.size(), between,
      100 * double(shares.blended) / shown, 100 * double(shares.copied) / shown, 100 * double(shares.filled) / shown,
      options.sequence.static_buffer ? fmt::format(", {:.2f} % of the S-buffer", 100 * double(shares.still) / shown)
                                     : "");
  Json json = {{"scene", options.sequence.scene},
               {"engine", options.sequence.engine},
               {"config", sequence.colour},
               {"motion", sequence.motion},
               {"width", sequence.width},
               {"height", sequence.height},
               {"frames", sequence.frames},
               {"keys", sequence.keys},
               {"between", between},
               {"pixels",
                {{"background", shares.background},
                 {"blended", shares.blended},
                 {"copied", shares.copied},
                 {"rendered", shares.filled},
                 {"static", shares.still}}}};
  json.update(to_json(work, sequence.tile_bytes));
  write_json(options.json, json);
}

}  // namespace

void add_frames(CLI::App& app, int&) {
  auto options = std::make_shared<FramesOptions>();
  CLI::App* command =
      app.add_subcommand("frames", "an animation of which key frames are drawn and the rest is made from their motion");
  add_sequence_options(command, options->sequence);
  add_output_file(command, "-o,--output", options->output,
                  "a film (.mp4, .mkv, .webm, .gif) or pictures like frame_%04d.png")
      ->required();
  add_output_file(command, "--difference", options->difference,
                  "likewise: 128 + gain times what a frame differs by from the rendered one");
  command->add_option("--gain", options->gain, "of --difference")->capture_default_str()->check(CLI::Range(1, 128));
  add_json(command, options->json);
  command->footer(
      "  halfspace frames drone --keys 1:4 -o drone.mp4            one frame in five is drawn\n"
      "  halfspace frames drone --keys auto --psnr 50 -o auto.mp4  keys where the motion asks for them\n"
      "  halfspace frames court --frames 21 --static-buffer -o court_%02d.png  the castle is drawn once, the drone "
      "alone "
      "is compensated\n"
      "docs/frames.md says how frames are made.\n");
  command->callback([options] { frames(*options); });
}

}  // namespace halfspace::cli
