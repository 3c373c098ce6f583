// SPDX-License-Identifier: Apache-2.0
#include "cli/repro/repro_morphing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "cli/common/numbers.hpp"
#include "cli/common/output.hpp"
#include "cli/common/progress.hpp"
#include "cli/common/table.hpp"
#include "cli/motion/frame_cost.hpp"
#include "cli/motion/timeline.hpp"
#include "cli/plots/sequence_quality.hpp"
#include "cli/repro/repro_frames.hpp"
#include "ref/error.hpp"

namespace halfspace::cli {
namespace {

struct MorphingOptions {
  std::vector<std::string> scenes = paper_animations();
  std::vector<int> between = {1, 2, 4};
  std::string size = "320x240", out, json;
  int frames = 21, lanes = 4, lights = 4;
  TableOptions tables;
};

SequenceOptions sequence_of(const MorphingOptions& options, const std::string& scene) {
  SequenceOptions sequence;
  sequence.scene = scene, sequence.size = options.size, sequence.frames = options.frames;
  sequence.relight = false;
  return sequence;
}

std::string percent(double share) { return fmt::format("{:.2f} %", 100 * share); }

// How the paper has vectors, and what its test of the primitive is worth.
struct Form {
  const char* name;
  const char* engine;
  const char* method;
  bool index_test, relight;
};
constexpr Form kForms[] = {{"the vector from key to key, cut in two", "hls", "straight", true, false},
                           {"cut in two, without the test of the primitive", "ref", "straight", false, false},
                           {"a vector to each key", "hls", "exact", true, false},
                           {"a vector to each key, relit", "hls", "exact", true, true}};

Table vectors(const MorphingOptions& options, Json& json) {
  Table table{"vectors",
              fmt::format("{}, {} frames of each of {} scenes; PSNR_Y in dB, mean. alone: of pixels that are made of "
                          "keys alone.\nOf covered pixels: blended of both keys, copied from the one that shows it, "
                          "rendered as neither does",
                          options.size, options.frames, options.scenes.size()),
              {{"drawn", "vectors", "PSNR_Y", "alone", "blended", "copied", "rendered", "temporal average"}}};
  Progress progress("repro D: vectors");
  std::size_t done = 0;
  for (const int between : options.between) {
    for (const Form& form : kForms) {
      progress.tell(done++, options.between.size() * std::size(kForms));
      double psnr = 0, alone = 0, average = 0;
      ref::Shares shares;
      for (const std::string& scene : options.scenes) {
        SequenceOptions sequence = sequence_of(options, scene);
        sequence.keys = fmt::format("1:{}", between);
        sequence.engine = form.engine, sequence.method = form.method;
        sequence.index_test = form.index_test, sequence.relight = form.relight;
        const SequenceQuality q = measure_sequence(sequence, false);
        psnr += q.compensated.psnr_y / double(options.scenes.size());
        alone += q.alone.value_or(ref::kMostDecibels) / double(options.scenes.size());
        average += q.average.psnr_y / double(options.scenes.size());
        add(shares, q.shares);
      }
      const double covered = std::max(1.0, double(shares.blended + shares.copied + shares.filled));
      const double blended = double(shares.blended) / covered, copied = double(shares.copied) / covered,
                   filled = double(shares.filled) / covered;
      table.rows.push_back({fmt::format("1 in {}", between + 1), form.name, fmt::format("{:.2f}", psnr),
                            fmt::format("{:.2f}", alone), percent(blended), percent(copied), percent(filled),
                            fmt::format("{:.2f}", average)});
      json["vectors"].push_back({{"between", between},
                                 {"form", form.name},
                                 {"psnr_y_db", psnr},
                                 {"of_keys_alone_psnr_y_db", alone},
                                 {"blended", blended},
                                 {"copied", copied},
                                 {"rendered", filled},
                                 {"temporal_average_db", average}});
    }
  }
  return table;
}

// Keys at frames `first` and five later, at which much moves.
constexpr int kFirst = 25, kBetween = 4;

std::vector<Table> half_fields(const MorphingOptions& options, Json& json) {
  const FrameSize size = parse_size(options.size);
  std::vector<Table> tables;
  for (const char* scene : {"cube_fast", "wheel_turn", "drone"}) {
    const SceneSource source(scene, {});
    const auto at = [&](int n) { return source.at(double(kFirst + n) / kFramesASecond); };
    const HalfField halves =
        half_field(at(0), at(2), at(5), size.width, size.height, model::find_configuration("middle"), options.lanes);
    tables.push_back(table_of(halves, scene));
    if (tables.size() == 1)
      tables[0].heading = "A frame between two keys, of a motion vector a pixel and of one for 2x2";
    json["half"].push_back(to_json(halves, scene));
  }
  return tables;
}

// A key that is seen at another scale.
Table footprints(const MorphingOptions& options, Json& json) {
  Table table{
      "footprint",
      "Reference, bricks, first key to second: PSNR_Y in dB. Footprint: over the pixel as the motion stretches it",
      {{"scene", "speed", "samples", "vectors", "bilinear", "bicubic", "footprint"}}};
  struct Row {
    const char* scene;
    double speed;
    int samples;
    bool pixel_vectors;
  };
  for (const Row& row : {Row{"cube_zoom", 1, 1, false}, Row{"cube_zoom", 3, 1, false}, Row{"cube_zoom", 3, 4, true},
                         Row{"cube_zoom", 3, 4, false}, Row{"jet", 3, 4, true}, Row{"cube_fast", 2, 4, true},
                         Row{"cube_fast", 2, 4, false}}) {
    std::vector<std::string> cells = {row.scene, fmt::format("{}", row.speed), fmt::format("{0}x{0}", row.samples),
                                      row.pixel_vectors || row.samples == 1 ? "a pixel" : "a sample"};
    Json numbers;
    for (const char* filter : {"bilinear", "bicubic", "footprint"}) {
      SequenceOptions sequence = sequence_of(options, row.scene);
      sequence.engine = "ref", sequence.texture = "bilinear", sequence.filter = filter, sequence.relight = true;
      sequence.samples = row.samples, sequence.pixel_vectors = row.pixel_vectors, sequence.speed = row.speed;
      sequence.frames = std::min(options.frames, int(60 / row.speed) - 1);
      const double psnr = measure_sequence(sequence, false).compensated.psnr_y;
      cells.push_back(fmt::format("{:.2f}", psnr));
      numbers[filter] = psnr;
    }
    table.rows.push_back(cells);
    json["footprint"].push_back({{"scene", row.scene},
                                 {"speed", row.speed},
                                 {"samples", row.samples},
                                 {"vector_a_pixel", row.pixel_vectors || row.samples == 1},
                                 {"psnr_y_db", numbers}});
  }
  return table;
}

double cycles_of(const Cost& cost, const std::string& unit) {
  double most = 0;
  for (const auto& [name, cycles] : cost.units) {
    if (unit == name) most = std::max(most, cycles);
  }
  return most;
}

// Cycles of the stages of the frames from a key to before the next.
std::vector<StageCycles> stages_of(const MorphingOptions& options, const std::string& name, int lights) {
  const FrameSize size = parse_size(options.size);
  const SceneSource source(name, {});
  const auto at = [&](int n) { return source.at(double(kFirst + n) / kFramesASecond); };
  const model::Configuration colour = model::find_configuration("middle");
  const ref::Scene first = at(0), second = at(kBetween + 1);
  const Config numbers = model::default_motion(colour.config(), &first);
  const model::KernelUpConversion mode{size.width, size.height, colour,
                                       model::motion_configuration(colour, numbers, size.width, size.height)};
  model::KernelUpConverter converter(mode);
  converter.set_keys(first, second);
  const ref::View view{size.width, size.height, colour.config().range_bits, colour.config().subpixel_bits};
  std::vector<StageCycles> frames;
  for (int n = 0; n <= kBetween; ++n) {
    const ref::Scene scene = at(n);
    const ref::TriangleList drawn = ref::project(scene, view);
    const FrontEnd front = front_end(colour, drawn, options.lanes);
    StageCycles& stages = frames.emplace_back(StageCycles{});
    const auto stage = [&](Stage s) -> double& { return stages[std::size_t(s)]; };
    Cost cost = rendered("", front, front.pixels, false, lights);
    if (n != 0) {
      const model::KernelFrameBetween frame = converter.at(scene, double(n) / (kBetween + 1));
      cost = made("", front, holes_end(drawn, frame, mode, options.lanes), front.pixels, frame, mode);
    }
    for (const char* unit : {"triangle_setup", "plane setup", "raster_pineda"})
      stage(Stage::kTriangles) = std::max(stage(Stage::kTriangles), cycles_of(cost, unit));
    stage(Stage::kShading) = std::max(cycles_of(cost, "shade_gouraud"), cycles_of(cost, "shade_phong"));
    stage(Stage::kField) = cycles_of(cost, "motion_field");
    stage(Stage::kCompensation) = cycles_of(cost, "motion_compensate");
  }
  return frames;
}

Table time_lines(const MorphingOptions& options, Json& json) {
  Table table{
      "time",
      fmt::format("One frame in {} drawn, {}, {} lanes; cycles of the model, a frame, mean. Late: from when the "
                  "triangles of a frame are there until it is shown",
                  kBetween + 1, options.size, options.lanes),
      {{"scene", "keys", "triangles", "shading", "field", "compensation", "in turn: cycles", "frames late",
        "overlapped, as often: frames late", "overlapped: cycles", "frames late", "drawn all"}}};
  for (const char* scene : {"cube_fast", "wheel_turn", "drone"}) {
    for (const int lights : {0, options.lights}) {
      const std::vector<StageCycles> frames = stages_of(options, scene, lights);
      constexpr int kIntervals = 3;
      const Timeline in_turn = timeline(frames, kIntervals, false), overlapped = timeline(frames, kIntervals, true);
      const Timeline as_often = timeline(frames, kIntervals, true, in_turn.period);
      const double all = std::max(frames[0][0], frames[0][1]);  // each frame drawn, setup and shading overlapped
      std::vector<std::string> cells = {scene, lights ? fmt::format("Phong, {} lights", lights) : "Gouraud"};
      Json stages;
      for (int s = 0; s < kStages; ++s) {
        double sum = 0;
        for (const StageCycles& frame : frames) sum += frame[std::size_t(s)];
        cells.push_back(fmt::format("{:.0f}", sum / double(frames.size())));
        stages[name_of(Stage(s))] = sum / double(frames.size());
      }
      for (const Timeline* of : {&in_turn, &overlapped}) {
        cells.push_back(fmt::format("{:.0f}", of->period));
        cells.push_back(fmt::format("{:.1f}", of->delay / of->period));
        if (of == &in_turn) cells.push_back(fmt::format("{:.1f}", as_often.delay / as_often.period));
      }
      cells.push_back(fmt::format("{:.0f}", all));
      table.rows.push_back(cells);
      Json work = Json::array();
      for (const StageWork& w : overlapped.work)
        work.push_back({{"unit", name_of(w.stage)}, {"frame", w.frame}, {"start", w.start}, {"end", w.end}});
      json["time"].push_back({{"scene", scene},
                              {"lights", lights},
                              {"cycles", stages},
                              {"in_turn", {{"period", in_turn.period}, {"delay", in_turn.delay}}},
                              {"as_often", {{"period", as_often.period}, {"delay", as_often.delay}}},
                              {"overlapped", {{"period", overlapped.period}, {"delay", overlapped.delay}}},
                              {"drawn_all", all},
                              {"work", work}});
      if (options.out.empty()) continue;
      const std::string shading = lights ? "phong" : "gouraud";
      plot_timeline(in_turn, overlapped, kBetween,
                    fmt::format("{}, {}: numbers of frames; cycles of the model", scene,
                                lights ? fmt::format("Phong shading of {} lights", lights) : "Gouraud shading"),
                    (std::filesystem::path(options.out) / fmt::format("time_{}_{}.png", scene, shading)).string());
    }
  }
  return table;
}

void repro_d(const MorphingOptions& options) {
  Json json = {{"paper", "bi-directional morphing"}};
  if (!options.out.empty()) model::make_folder(options.out);
  const auto wanted = [&](const char* name) { return options.tables.only.empty() || options.tables.only == name; };
  std::vector<Table> tables;
  if (wanted("vectors")) tables.push_back(vectors(options, json));
  if (wanted("half")) {
    for (Table& table : half_fields(options, json)) tables.push_back(std::move(table));
  }
  if (wanted("footprint")) tables.push_back(footprints(options, json));
  if (wanted("time")) tables.push_back(time_lines(options, json));
  print_tables(tables, options.tables);
  write_json(options.json, json);
}

}  // namespace

void add_repro_morphing(CLI::App& repro) {
  auto options = std::make_shared<MorphingOptions>();
  CLI::App* paper = repro.add_subcommand("D", "bi-directional morphing");
  paper->add_option("--scene", options->scenes, "animated scenes of the table of vectors")->capture_default_str();
  paper->add_option("--between", options->between, "frames between two that are drawn")
      ->capture_default_str()
      ->check(CLI::Range(1, 9));
  paper->add_option("--frames", options->frames, "of each scene")->capture_default_str()->check(CLI::Range(3, 1000));
  paper->add_option("--size", options->size, "frame, WxH")->capture_default_str();
  paper->add_option("--lanes", options->lanes, "pixels a stamp: 1, 2, 4, 8, 16")->capture_default_str();
  paper->add_option("--lights", options->lights, "of Phong shading, 1 to 4")
      ->capture_default_str()
      ->check(CLI::Range(1, 4));
  add_output_folder(paper, "--out", options->out, "folder for the pictures of which unit works on which frame");
  add_json(paper, options->json);
  add_table_options(paper, options->tables, {"vectors", "half", "footprint", "time"});
  paper->footer(
      "  halfspace repro D --table time --out build/D      the time line alone, and its pictures\n"
      "  halfspace repro D --scene jet --frames 11 --table vectors\n");
  paper->callback([options] { repro_d(*options); });
}

}  // namespace halfspace::cli
