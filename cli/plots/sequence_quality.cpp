// SPDX-License-Identifier: Apache-2.0
#include "cli/plots/sequence_quality.hpp"

#include <fmt/format.h>

#include <numeric>

#include "cli/plots/gnuplot.hpp"
#include "cli/plots/video.hpp"
#include "ref/error.hpp"

namespace halfspace::cli {
namespace {

constexpr const char* kColours[ref::kBlockClasses] = {"#8c2d2d", "#d9853b", "#e8d36b", "#8fbf8f", "#2a7d5c"};

Json quality_json(const ref::Quality& q) {
  Json blocks;
  for (int n = 0; n < ref::kBlockClasses; ++n) blocks[ref::name_of(ref::BlockClass(n))] = q.blocks[std::size_t(n)];
  return {{"psnr_y_db", q.psnr_y}, {"psnr_db", q.psnr}, {"ssim", q.ssim}, {"blocks", blocks}};
}

ref::Colours colours_of(const Picture& picture) {
  ref::Colours colours;
  for (const auto& p : picture.pixels) colours.push_back({p[0], p[1], p[2], 255});
  return colours;
}

// What the filter makes of the keys, for the frames in between that it reaches. Throws ref::Error where it makes none.
ref::Quality quality_of_minterpolate(const Sequence& sequence, const std::vector<ref::Colours>& rendered) {
  const std::size_t keys = sequence.keys.size();
  const int factor = keys < 2 ? 0 : sequence.keys[1] - sequence.keys[0];
  std::vector<Picture> shown;
  for (std::size_t k = 0; k < keys; ++k) {
    if (sequence.keys[k] != int(k) * factor) break;  // the last interval is shorter
    shown.push_back(picture_of(rendered[std::size_t(sequence.keys[k])], sequence.width, sequence.height));
  }
  if (shown.size() < 3 || factor < 2) throw ref::Error("it takes three keys or more, as far apart as each other");
  const std::vector<Picture> made = interpolated_by_ffmpeg(shown, factor);
  ref::MeanQuality mean;
  for (std::size_t n = 0; n < made.size() && n < rendered.size(); ++n) {
    if (n % std::size_t(factor) == 0) continue;
    mean.add(ref::quality(colours_of(made[n]), rendered[n], sequence.width, sequence.height));
  }
  if (mean.frames() == 0) throw ref::Error("ffmpeg makes no frame of pictures of this size");
  return mean.mean();
}

}  // namespace

SequenceQuality measure_sequence(const SequenceOptions& options, bool with_minterpolate) {
  SequenceQuality out;
  const FrameSize size = parse_size(options.size);
  std::vector<ref::Colours> rendered;
  ref::MeanQuality compensated, average, repeat;
  std::vector<double> alone;
  const auto begin = [&] {
    out = {}, rendered.clear(), alone.clear();
    compensated = average = repeat = {};
  };
  out.sequence = run_sequence(options, begin, [&](const SequenceFrame& frame) {
    if (with_minterpolate) rendered.push_back(frame.rendered);
    if (frame.is_key) return;
    const auto against = [&](const ref::Colours& picture) {
      return ref::quality(picture, frame.rendered, size.width, size.height);
    };
    const ref::Quality made = against(frame.shown), mean = against(frame.average);
    compensated.add(made), average.add(mean), repeat.add(against(frame.repeat));
    if (const auto psnr = ref::psnr_y_of(frame.shown, frame.rendered, frame.of_keys)) alone.push_back(*psnr);
    out.blocks.push_back(made.blocks), out.average_blocks.push_back(mean.blocks);
    add(out.shares, frame.shares);
    add(out.work, frame.work);
  });
  out.between = compensated.frames();
  if (out.between == 0) return out;
  out.compensated = compensated.mean(), out.average = average.mean(), out.repeat = repeat.mean();
  if (!alone.empty()) out.alone = std::accumulate(alone.begin(), alone.end(), 0.0) / double(alone.size());
  if (!with_minterpolate) return out;
  try {
    out.minterpolate = quality_of_minterpolate(out.sequence, rendered);
  } catch (const ref::Error& error) {  // as ffmpeg is not there, or does not take the size
    out.no_minterpolate = error.what();
  }
  return out;
}

Json to_json(const Work& work, int tile_bytes) {
  return {{"triangles", work.triangles},       {"static_triangles", work.static_triangles},
          {"motion_words", work.words},        {"second_words", work.second_words},
          {"cache_misses", work.tiles},        {"key_bytes", work.tiles * std::size_t(tile_bytes)},
          {"compensation_cycles", work.cycles}};
}

Json to_json(const SequenceQuality& q) {
  Json json = {{"config", q.sequence.colour},
               {"motion", q.sequence.motion},
               {"width", q.sequence.width},
               {"height", q.sequence.height},
               {"frames", q.sequence.frames},
               {"keys", q.sequence.keys},
               {"between", q.between},
               {"compensated", quality_json(q.compensated)},
               {"temporal_average", quality_json(q.average)},
               {"repeat", quality_json(q.repeat)},
               {"pixels",
                {{"background", q.shares.background},
                 {"blended", q.shares.blended},
                 {"copied", q.shares.copied},
                 {"rendered", q.shares.filled},
                 {"static", q.shares.still}}},
               {"picture_pixels", {{"covered", q.shares.pixels}, {"with_rendered", q.shares.rendered}}},
               {"rendered_share", q.rendered_share()}};
  if (q.alone) json["of_keys_alone_psnr_y_db"] = *q.alone;
  json.update(to_json(q.work, q.sequence.tile_bytes));
  if (q.minterpolate) json["minterpolate"] = quality_json(*q.minterpolate);
  return json;
}

void plot_blocks(const SequenceQuality& quality, const std::string& title, const std::string& picture) {
  std::string script = fmt::format(
      "set terminal pngcairo size 1000,640 noenhanced font 'sans,11' background rgb 'white'\nset "
      "multiplot layout 2,1 title {}\n"
      "set style data histograms\nset style histogram rowstacked\nset style fill solid 0.95 noborder\nset boxwidth 1\n"
      "set yrange [0:100]\nset ylabel 'blocks of 4x4, percent'\nset key outside right top\nunset xtics\nset grid "
      "ytics\n",
      gnuplot_quoted(title));
  const auto plot = [&](const char* name, const char* label,
                        const std::vector<std::array<double, ref::kBlockClasses>>& frames) {
    script += fmt::format("${} << EOD\n", name);
    for (const auto& frame : frames) {
      for (const double share : frame) script += fmt::format("{} ", 100 * share);
      script += "\n";
    }
    script += fmt::format("EOD\nset xlabel {}\nplot ", gnuplot_quoted(label));
    for (int n = 0; n < ref::kBlockClasses; ++n) {
      script += fmt::format("{}${} using {} lc rgb '{}' title '{}'", n ? ", " : "", name, n + 1, kColours[n],
                            ref::name_of(ref::BlockClass(n)));
    }
    script += "\n";
  };
  plot("average", "frames in between: temporal average of the keys", quality.average_blocks);
  plot("made", "frames in between: motion compensated", quality.blocks);
  run_gnuplot(script + "unset multiplot\n", picture);
}

}  // namespace halfspace::cli
