// SPDX-License-Identifier: Apache-2.0
#include "cli/motion/timeline.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/plots/gnuplot.hpp"

namespace halfspace::cli {
namespace {

constexpr Stage kOfKey[] = {Stage::kTriangles, Stage::kShading};
constexpr Stage kOfBetween[] = {Stage::kTriangles, Stage::kField, Stage::kCompensation};

// In the order of drawing: both keys of an interval, then what lies between them.
std::vector<int> drawing_order(int interval, int intervals) {
  std::vector<int> order{0};
  for (int n = 0; n < intervals; ++n) {
    order.push_back((n + 1) * interval);
    for (int k = 1; k < interval; ++k) order.push_back(n * interval + k);
  }
  return order;
}

double fewest_cycles(const std::vector<StageCycles>& frames, bool overlap) {
  StageCycles sum{};
  for (const StageCycles& frame : frames) {
    for (int s = 0; s < kStages; ++s) sum[std::size_t(s)] += frame[std::size_t(s)];
  }
  double all = 0;
  for (const double stage : sum) all += stage;
  return (overlap ? *std::max_element(sum.begin(), sum.end()) : all) / double(frames.size());
}

}  // namespace

const char* name_of(Stage stage) {
  constexpr const char* kNames[] = {"setup, rasterizer, Z-test", "shading", "motion_field", "motion_compensate"};
  return kNames[int(stage)];
}

Timeline timeline(const std::vector<StageCycles>& frames, int intervals, bool overlap, double period) {
  const int interval = int(frames.size());
  Timeline out;
  out.period = period > 0 ? period : fewest_cycles(frames, overlap);
  std::array<double, kStages> free{};
  std::vector<double> ready(std::size_t(intervals * interval + 1), 0);
  // When the frame two before it has been read out of the buffers of index and depth, of which there are two.
  double read_before = 0, read_last = 0, last_end = 0;
  for (const int frame : drawing_order(interval, intervals)) {
    const bool is_key = frame % interval == 0;
    const StageCycles& cycles = frames[std::size_t(frame % interval)];
    double at = std::max(frame * out.period, overlap ? read_before : last_end);
    if (!is_key && !overlap) at = std::max(at, ready[std::size_t(frame / interval + 1) * std::size_t(interval)]);
    const Stage* const stages = is_key ? kOfKey : kOfBetween;
    const int count = is_key ? int(std::size(kOfKey)) : int(std::size(kOfBetween));
    for (int n = 0; n < count; ++n) {
      const auto s = std::size_t(stages[n]);
      double start = std::max(at, free[s]);
      if (stages[n] == Stage::kCompensation)
        start = std::max(start, ready[std::size_t(frame / interval + 1) * std::size_t(interval)]);
      at = free[s] = start + cycles[s];
      out.work.push_back({stages[n], frame, start, at});
      if (n == 1) read_before = read_last, read_last = at;
    }
    ready[std::size_t(frame)] = last_end = at;
    out.delay = std::max(out.delay, at - frame * out.period);
  }
  return out;
}

void plot_timeline(const Timeline& in_turn, const Timeline& overlapped, int between, const std::string& title,
                   const std::string& picture) {
  constexpr const char* kColours[] = {"#2a7d5c", "#8fbf8f", "#e8d36b", "#d9853b", "#9aa5ad"};
  const double end = std::max(in_turn.work.back().end, overlapped.work.back().end);
  std::string script = fmt::format(
      "set terminal pngcairo size 1100,640 noenhanced font 'sans,11' background rgb 'white'\nset multiplot layout 2,1 "
      "title {}\nset style fill solid 0.95 border rgb 'white'\nset xrange [0:{}]\nset yrange [-0.6:{}.6]\n"
      "set xlabel 'thousands of cycles'\nset grid xtics\nset key off\nset lmargin 24\n",
      gnuplot_quoted(title), end / 1000, kStages - 1);
  script += "set ytics (";
  for (int s = 0; s < kStages; ++s)
    script += fmt::format("{}{} {}", s ? ", " : "", gnuplot_quoted(name_of(Stage(s))), kStages - 1 - s);
  script += ")\n";
  int number = 0;
  for (const Timeline* of : {&in_turn, &overlapped}) {
    script += "unset label\nunset object\n";
    int box = 0;
    for (const StageWork& w : of->work) {
      const int row = kStages - 1 - int(w.stage);
      script +=
          fmt::format("set object {} rectangle from {},{} to {},{} fc rgb '{}'\n", ++box, w.start / 1000, row - 0.4,
                      w.end / 1000, row + 0.4, kColours[w.frame % (between + 1) == 0 ? 0 : 1 + (w.frame - 1) % 4]);
      if (w.end - w.start > end / 60)
        script += fmt::format("set label {} '{}' at {},{} center front\n", box, w.frame, (w.start + w.end) / 2000, row);
    }
    script += fmt::format("set title {}\nplot -10 with lines\n",
                          gnuplot_quoted(fmt::format("{}: a frame in {:.0f} cycles, shown {:.1f} frames late",
                                                     number++ == 0 ? "a frame after the other" : "overlapped",
                                                     of->period, of->delay / of->period)));
  }
  run_gnuplot(script + "unset multiplot\n", picture);
}

}  // namespace halfspace::cli
