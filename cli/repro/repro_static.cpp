// SPDX-License-Identifier: Apache-2.0
#include "cli/repro/repro_static.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <filesystem>
#include <memory>

#include "cli/commands.hpp"
#include "cli/common/numbers.hpp"
#include "cli/common/output.hpp"
#include "cli/common/progress.hpp"
#include "cli/common/table.hpp"
#include "cli/plots/gnuplot.hpp"
#include "cli/plots/picture.hpp"
#include "study/papers/static_experiment.hpp"

namespace halfspace::cli {
namespace {

namespace fs = std::filesystem;
using model::MethodFrames;
using model::Spread;

struct ReproStaticOptions {
  model::StaticExperimentOptions experiment;
  std::string out, json;
  double clock = 100;  // MHz
  TableOptions tables;
};

struct MethodName {
  const char *key, *text, *colour;
};
constexpr MethodName kMethods[model::kStaticMethods] = {{"all", "everything drawn", "#c0392b"},
                                                        {"no_query", "S-buffer, no query", "#e9a13b"},
                                                        {"query", "S-buffer, query", "#4d6a8a"},
                                                        {"query_many", "S-buffers, query", "#2a9d5c"}};

std::string method_text(std::size_t m, int buffers) {
  return m + 1 == model::kStaticMethods ? fmt::format("{} {}", buffers, kMethods[m].text) : kMethods[m].text;
}

Json json_of(const Spread& s) {
  return {{"frames", s.count()}, {"mean", s.mean()}, {"deviation", s.deviation()}, {"largest", s.largest()}};
}

Json json_of(const MethodFrames& f) {
  return {{"objects_drawn", json_of(f.drawn)},
          {"redrawn", json_of(f.redrawn)},
          {"triangles", json_of(f.triangles)},
          {"cycles", json_of(f.cycles)},
          {"ms", json_of(f.milliseconds)},
          {"starts", f.starts},
          {"updates", f.updates}};
}

double largest_memory_mb() {
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  return double(use.ru_maxrss) / 1024;
}

Json all_json(const ReproStaticOptions& o, const model::StaticExperiment& e) {
  const auto& x = o.experiment;
  Json json = {{"paper", "static objects buffer"},
               {"seed", x.crowd.seed},
               {"objects", x.crowd.objects},
               {"layers", x.crowd.layers},
               {"interval", x.crowd.interval},
               {"config", x.config},
               {"lanes", x.lanes},
               {"width", x.width},
               {"height", x.height},
               {"buffers", x.buffers},
               {"clock_mhz", o.clock},
               {"triangles", e.triangles},
               {"handed", e.handed},
               {"compared_pixels", e.compared},
               {"first_frame_seconds", e.first_seconds[1]},
               {"memory_mb", largest_memory_mb()},
               {"steps", Json::array()}};
  for (const model::StaticStep& step : e.steps) {
    Json row = {{"moving", step.moving}};
    for (std::size_t m = 0; m < model::kStaticMethods; ++m) row[kMethods[m].key] = json_of(step.methods[m]);
    json["steps"].push_back(std::move(row));
  }
  return json;
}

// What the paper prints of 120 that move. With the query it has first one S-buffer, then "6 extra", and does not say of
// which its number is.
constexpr int kPrintedMoving = 120;
struct PrintedStatic {
  const char* method;
  double objects, frames_a_second;
};
constexpr PrintedStatic kPrintedStatic[] = {{"printed: S-buffer, no query", 460, 68},
                                            {"printed: query, one S-buffer or 7", 130, 140}};

Table table_of_objects(const ReproStaticOptions& o, const model::StaticExperiment& e) {
  const auto& x = o.experiment;
  Table table{
      "objects",
      fmt::format("{} objects, {} triangles, {} of them handed over in the first frame; {}x{} in {}, {} lanes; "
                  "seed {}\n"
                  "Mean and standard deviation of {} frames, of {} where everything is drawn. The paper: 40,000 "
                  "objects, 120 moving. Its 130 objects\n"
                  "a frame with the query are of one S-buffer, or of 7: its text allows either; both are here",
                  x.crowd.objects, e.triangles, e.handed, x.width, x.height, x.config, x.lanes, x.crowd.seed, x.frames,
                  x.full_frames),
      {{"moving", "method", "objects", "+-", "most", "starts", "updates", "Mtriangles", "Mcycles", "+-"}}};
  for (const PrintedStatic& p : kPrintedStatic)
    table.rows.push_back(
        {std::to_string(kPrintedMoving), p.method, fmt::format("{}", p.objects), "", "", "", "", "", "", ""});
  for (const model::StaticStep& step : e.steps) {
    for (std::size_t m = 0; m < model::kStaticMethods; ++m) {
      const MethodFrames& f = step.methods[m];
      if (f.drawn.count() == 0) continue;
      const bool updates = m != std::size_t(model::StaticMethod::kAll);
      table.rows.push_back(
          {fmt::format("{}", step.moving), method_text(m, x.buffers), fmt::format("{:.1f}", f.drawn.mean()),
           fmt::format("{:.1f}", f.drawn.deviation()), fmt::format("{:.0f}", f.drawn.largest()),
           updates ? fmt::format("{}", f.starts) : "", updates ? fmt::format("{}", f.updates) : "",
           fmt::format("{:.3f}", f.triangles.mean() / 1e6), fmt::format("{:.2f}", f.cycles.mean() / 1e6),
           fmt::format("{:.2f}", f.cycles.deviation() / 1e6)});
    }
  }
  return table;
}

Table table_of_frame_times(const ReproStaticOptions& o, const model::StaticExperiment& e) {
  Table table{
      "time",
      fmt::format("Time of a frame, ms, one thread of the reference; the first frame took {:.1f} s. Last, frames "
                  "a second of the RTL's\ncycles. Between machines the ratio of two methods compares",
                  e.first_seconds[1]),
      {{"moving", "method", "ms", "+-", "frames a second", fmt::format("RTL, {:g} MHz", o.clock)}}};
  for (const PrintedStatic& p : kPrintedStatic) {
    table.rows.push_back(
        {std::to_string(kPrintedMoving), p.method, "", "", fmt::format("{:.1f}", p.frames_a_second), ""});
  }
  for (const model::StaticStep& step : e.steps) {
    for (std::size_t m = 0; m < model::kStaticMethods; ++m) {
      const MethodFrames& f = step.methods[m];
      if (f.drawn.count() == 0) continue;
      table.rows.push_back({fmt::format("{}", step.moving), method_text(m, o.experiment.buffers),
                            fmt::format("{:.1f}", f.milliseconds.mean()),
                            fmt::format("{:.1f}", f.milliseconds.deviation()),
                            fmt::format("{:.1f}", 1000 / f.milliseconds.mean()),
                            fmt::format("{:.2f}", o.clock * 1e6 / f.cycles.mean())});
    }
  }
  return table;
}

void print(const ReproStaticOptions& o, const model::StaticExperiment& e) {
  print_tables({table_of_objects(o, e), table_of_frame_times(o, e)}, o.tables);
  if (!o.tables.only.empty()) return;
  fmt::print("\n{} pixels compared with those of drawing everything, none differs. {:.0f} MB of memory at most.\n",
             e.compared, largest_memory_mb());
}

// Objects drawn a frame and the deviation of cycles, by the number that moves.
std::string plot(const Json& json, const std::string& folder) {
  std::string picture = (fs::path(folder) / "static_objects.png").string();
  std::string script = fmt::format(
      "set terminal pngcairo size 1100,420 font 'sans,11' background rgb 'white'\n"
      "set grid lt 1 lw 0.5 lc rgb '#cccccc'\nset key left top\nset xlabel 'objects that move'\n"
      "set xrange [0:{}]\nset yrange [0:*]\n",
      json["steps"].back()["moving"].get<int>() * 1.05 + 1);
  script += "$printed << EOD\n";
  for (const PrintedStatic& p : kPrintedStatic) script += fmt::format("{} {}\n", kPrintedMoving, p.objects);
  script += "EOD\n";
  for (std::size_t m = 1; m < model::kStaticMethods; ++m) {
    script += fmt::format("$m{} << EOD\n", m);
    for (const Json& row : json["steps"]) {
      const Json& of = row[kMethods[m].key];
      script += fmt::format("{} {} {}\n", row["moving"].get<int>(), of["objects_drawn"]["mean"].get<double>(),
                            of["cycles"]["deviation"].get<double>() / 1e6);
    }
    script += "EOD\n";
  }
  script += "set multiplot layout 1,2\n";
  for (int column : {2, 3}) {
    script += column == 2 ? "set title 'objects drawn a frame'\nplot"
                          : "set title 'cycles of a frame: standard deviation, millions'\nplot";
    for (std::size_t m = 1; m < model::kStaticMethods; ++m) {
      script += fmt::format("{} $m{} using 1:{} with linespoints lw 2 pt 7 lc rgb '{}' title {}", m == 1 ? "" : ",", m,
                            column, kMethods[m].colour, gnuplot_quoted(method_text(m, json["buffers"].get<int>())));
    }
    if (column == 2 && json["steps"].back()["moving"] == kPrintedMoving)
      script += ", $printed using 1:2 with points pt 8 ps 2 lc rgb 'black' title 'printed'";
    script += "\n";
  }
  run_gnuplot(script + "unset multiplot\n", picture);
  return picture;
}

std::string write_last_picture(const ref::ObjectBuffer& from, const std::string& folder) {
  Picture picture{from.width(), from.height(), {}};
  for (int y = 0; y < from.height(); ++y) {
    for (int x = 0; x < from.width(); ++x) {
      const auto& c = from.at(x, y).colour;
      picture.pixels.push_back({c[0], c[1], c[2]});
    }
  }
  std::string path = (fs::path(folder) / "crowd.png").string();
  write_picture(path, picture);
  return path;
}

void run(const ReproStaticOptions& options) {
  std::unique_ptr<Progress> progress;
  std::string phase;
  const auto tell = [&](const char* now, std::size_t done, std::size_t total) {
    if (phase != now) progress = std::make_unique<Progress>("repro E: " + (phase = now));
    progress->tell(done, total);
  };
  const model::StaticExperiment result = model::run_static_experiment(options.experiment, tell);
  progress.reset();
  print(options, result);
  const Json json = all_json(options, result);
  write_json(options.json, json);
  if (!options.out.empty())
    fmt::print("{}\n{}\n", plot(json, options.out), write_last_picture(result.picture, options.out));
}

}  // namespace

void add_repro_static(CLI::App& repro) {
  auto options = std::make_shared<ReproStaticOptions>();
  auto& x = options->experiment;
  CLI::App* paper = repro.add_subcommand("E", "static objects buffer");
  paper->add_option("--objects", x.crowd.objects, "of 4,512 triangles each")->capture_default_str();
  paper->add_option("--moving", x.moving, "objects that move, each number in turn")->capture_default_str();
  paper->add_option("--frames", x.frames, "of each number")->capture_default_str()->check(above_zero());
  paper->add_option("--full-frames", x.full_frames, "of these, drawn as a whole too, and compared")
      ->capture_default_str();
  paper->add_option("--layers", x.crowd.layers, "objects that a line of sight meets, about")->capture_default_str();
  paper->add_option("--interval", x.crowd.interval, "frames that an object moves, on average")->capture_default_str();
  paper->add_option("--buffers", x.buffers, "S-buffers of the last method")->capture_default_str();
  paper->add_option("--seed", x.crowd.seed, "of places and motion")->capture_default_str();
  paper->add_option("--width", x.width, "of the frame")->capture_default_str();
  paper->add_option("--height", x.height, "of the frame")->capture_default_str();
  paper->add_option("--config", x.config, "number formats")->capture_default_str();
  paper->add_option("--lanes", x.lanes, "of the Z-test and the merge")
      ->capture_default_str()
      ->check(CLI::IsMember({1, 2, 4, 8, 16}));
  paper->add_option("--clock", options->clock, "MHz, for frames a second of the RTL")
      ->capture_default_str()
      ->check(above_zero());
  add_output_folder(paper, "--out", options->out, "folder for the plot and the last picture");
  add_json(paper, options->json);
  add_table_options(paper, options->tables, {"objects", "time"});
  paper->callback([options] {
    if (!options->out.empty()) model::make_folder(options->out);
    run(*options);
  });
}

}  // namespace halfspace::cli
