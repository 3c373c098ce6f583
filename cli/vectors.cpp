// SPDX-License-Identifier: Apache-2.0
// halfspace vectors
#include <fmt/format.h>

#include <cctype>
#include <memory>

#include "cli/commands.hpp"
#include "cli/common/numbers.hpp"
#include "cli/common/output.hpp"
#include "cli/common/progress.hpp"
#include "cli/common/scene_input.hpp"
#include "cli/common/sequence.hpp"
#include "model/drivers/film.hpp"
#include "model/drivers/up_convert.hpp"
#include "model/pipeline/engine.hpp"
#include "ref/error.hpp"
#include "vectors/frames/extremes.hpp"
#include "vectors/frames/features/feature_extremes.hpp"
#include "vectors/frames/rare_frames.hpp"
#include "vectors/frames/static_sequence.hpp"
#include "vectors/staging.hpp"
#include "vectors/standard_set.hpp"
#include "vectors/vector_set.hpp"

namespace halfspace::cli {
namespace {

// A film whose frames have holes, in a configuration that makes films.
constexpr const char *kFilm = "film", *kFilmScene = "wheel_turn", *kFilmSize = "45x37";
constexpr int kFilmFirst = 10;
constexpr const char *kExtremes = "extremes", *kCompensationExtremes = "compensation_extremes",
                     *kMergeExtremes = "merge_extremes";

struct VectorsOptions {
  SceneInput input;
  int lanes = 0;  // 0: those of the configuration
  std::string out, json;
  std::uint64_t seed = 1;
  bool corners = true, compensation = false, sv = false;
  int random = 4, random_triangles = 60;
  int frames = 20;
  int objects = 0, buffers = 0;  // 0: those of the kind of sequence
  int first = 0, intervals = 2;  // of a film
  bool query = true;
};

// "two_words" is TwoWords.
std::string camel(const std::string& snake) {
  std::string out;
  bool begins = true;
  for (const char c : snake) {
    if (c == '_' || c == '.') {
      begins = true;
      continue;
    }
    out += begins ? char(std::toupper(static_cast<unsigned char>(c))) : c;
    begins = false;
  }
  return out;
}

// Constants of a set for a bench without a harness, to be included in a module: of each stream the bits of a word, how
// many words, and where those of a frame begin; of each field where it lies in a word.
void write_sv(const std::string& path, const Json& manifest) {
  std::string text = fmt::format(
      "// Of the vectors of scene {}, configuration {}: words of {} frames.\nlocalparam integer Frames = {};\n",
      manifest["scene"].get<std::string>(), manifest["config"].get<std::string>(), manifest["frames"].size(),
      manifest["frames"].size());
  for (const Json& stream : manifest["streams"]) {
    const std::string name = stream["name"], prefix = camel(name);
    text += fmt::format("\n// {}: {} to {}\nlocalparam integer {}Bits = {}, {}Words = {};\n", name,
                        stream["from"].get<std::string>(), stream["to"].get<std::string>(), prefix,
                        stream["bits"].get<int>(), prefix, stream["words"].get<std::size_t>());
    for (const Json& field : stream["fields"]) {
      const std::string of_field = prefix + camel(field["name"]);
      text +=
          fmt::format("localparam integer {}Lsb = {}, {}Width = {}, {}Count = {};\n", of_field, field["lsb"].get<int>(),
                      of_field, field["width"].get<int>(), of_field, field["count"].get<int>());
    }
    text += fmt::format(
        "// Its first word of a frame; of frame Frames how many there are.\nfunction integer {}_begin(input integer "
        "frame);\n  case (frame)\n",
        name);
    std::size_t begin = 0;
    int frame = 0;
    for (const Json& words : stream["frame_words"]) {
      text += fmt::format("    {}: {}_begin = {};\n", frame++, name, begin);
      begin += words.get<std::size_t>();
    }
    text += fmt::format("    default: {}_begin = {};\n  endcase\nendfunction\n", name, begin);
  }
  model::write_file(path, text);
}

void tell(const VectorsOptions& options, const model::Configuration& configuration, const std::string& manifest) {
  const Json json = Json::parse(manifest);
  std::size_t words = 0;
  for (const auto& stream : json["streams"]) words += stream["words"].get<std::size_t>();
  fmt::print("vectors {} {}: {} frames, {} streams, {} words in {}\n", options.input.scene, configuration.name(),
             json["frames"].size(), json["streams"].size(), words, options.out);
  write_json(options.json, json);
  if (options.sv) write_sv(options.out + "/vectors.svh", json);
}

// A frame between two keys of a scene, as the kernels draw these.
model::NamedCompensation compensation_of(const VectorsOptions& options, const model::Configuration& configuration) {
  const Config config = configuration.config();
  const auto times = interval_of(options.input);
  const FrameSize size =
      options.input.size.empty() ? FrameSize{config.width, config.height} : parse_size(options.input.size);
  if (size.width % config.samples != 0 || size.height % config.samples != 0) {
    throw ref::Error(fmt::format("--size {}: a pixel of a key frame is {} each way of those: take multiples",
                                 options.input.size, config.samples));
  }
  model::KernelUpConverter converter({size.width / config.samples, size.height / config.samples,
                                      model::colour_configuration(configuration), configuration});
  const SceneSource source(options.input.scene, options.input.choice);
  const ref::Scene between = source.at(options.input.time);
  tell_if_faces_share(between, config);
  converter.set_keys(source.at(times[0]), source.at(times[1]));
  converter.at(between, (options.input.time - times[0]) / (times[1] - times[0]));
  const model::CompensationInput& in = converter.input();
  return {options.input.scene, in.width, in.height, {*in.key[0], *in.key[1]}, in.motion, in.weight};
}

model::VectorSetOptions set_of(const VectorsOptions& options, const model::Configuration& configuration) {
  model::VectorSetOptions set;
  set.scene = options.input.scene;
  set.configuration = configuration;
  set.lanes = options.lanes ? options.lanes : configuration.config().lanes;
  set.seed = options.seed;
  return set;
}

void write_compensation(const VectorsOptions& options, const model::Configuration& configuration) {
  const model::VectorSetOptions set = set_of(options, configuration);
  model::Compensator{configuration};  // refuses a configuration without motion
  Progress progress("vectors " + set.scene);
  tell(options, configuration,
       model::write_compensation_set(
           options.out, set,
           options.compensation ? std::vector<model::NamedCompensation>{compensation_of(options, configuration)}
           : options.input.scene == kCompensationExtremes
               ? model::compensation_extremes(configuration.config())
               : model::compensation_frames(configuration.config(), options.seed),
           [&](std::size_t done, std::size_t total) { progress.tell(done, total); }));
}

void write_merge(const VectorsOptions& options, const model::Configuration& configuration) {
  const model::VectorSetOptions set = set_of(options, configuration);
  model::Merger(configuration, set.lanes);  // refuses a configuration without objects
  Progress progress("vectors merge");
  tell(options, configuration,
       model::write_merge_set(options.out, set,
                              options.input.scene == kMergeExtremes
                                  ? model::merge_extremes(configuration.config())
                                  : model::merge_frames(configuration.config(), options.seed),
                              [&](std::size_t done, std::size_t total) { progress.tell(done, total); }));
}

// Two sets: the passes of a sequence at the ports of hs_pipeline, and the runs of ztest_merge.
void write_static(const VectorsOptions& options, const model::Configuration& configuration) {
  const model::VectorSetOptions of_runs = set_of(options, configuration);
  model::VectorSetOptions of_passes = of_runs;
  of_passes.ports = true;
  of_passes.window = options.input.window;
  const FrameSize size = parse_size(options.input.size.empty() ? "20x16" : options.input.size);
  const int buffers = options.buffers ? options.buffers : 1;
  const model::StaticSequence sequence = model::static_sequence(
      {configuration, of_passes.lanes, size.width, size.height, buffers, options.query, of_passes.window},
      options.objects ? options.objects : 8, options.frames, options.seed);
  model::make_folder(options.out);
  Progress progress("vectors static");
  const auto told = [&](std::size_t done, std::size_t total) { progress.tell(done, total); };
  VectorsOptions part = options;
  part.out = options.out + "/pipeline";
  tell(part, configuration, model::write_vector_set(part.out, of_passes, sequence.passes, told));
  part.out = options.out + "/merge", part.json.clear();
  tell(part, configuration, model::write_merge_set(part.out, of_runs, sequence.runs, told));
}

void write_film(const VectorsOptions& options, const model::Configuration& configuration) {
  const Config config = configuration.config();
  const bool own = options.input.scene == kFilm;
  const FrameSize size = parse_size(!options.input.size.empty() ? options.input.size
                                    : own                       ? kFilmSize
                                                                : fmt::format("{}x{}", config.width, config.height));
  const SceneSource source(own ? kFilmScene : options.input.scene, options.input.choice, has_texture(config));
  const int step = config.frames_between + 1, first = own ? kFilmFirst : options.first;
  std::vector<ref::Scene> frames;
  for (int n = 0; n <= options.intervals * step; ++n) {
    frames.push_back(source.at(double(first + n) / kFramesASecond));
    if (has_texture(config)) model::fit_textures(frames.back(), config);
  }
  tell_if_faces_share(frames.front(), config);
  const model::VectorSetOptions set = set_of(options, configuration);
  const std::vector<model::FilmPass> passes =
      model::film_passes(configuration, size.width, size.height, set.lanes, frames);
  Progress progress("vectors " + set.scene);
  tell(options, configuration,
       model::write_film_set(options.out, set, passes,
                             [&](std::size_t done, std::size_t total) { progress.tell(done, total); }));
}

// Of a sequence as hs_static_frames draws it.
void write_static_frames(const VectorsOptions& options, const model::Configuration& configuration) {
  model::VectorSetOptions set = set_of(options, configuration);
  set.window = options.input.window;
  const FrameSize size = parse_size(options.input.size.empty() ? "20x16" : options.input.size);
  const int some = has_lighting(configuration.config()) ? 8 : 14;  // an object has a material or more
  const int buffers = options.buffers ? options.buffers : 3, objects = options.objects ? options.objects : some;
  const auto frames = model::static_sequence_frames(
      {configuration, set.lanes, size.width, size.height, buffers, options.query, set.window}, objects, options.frames,
      options.seed);
  Progress progress("vectors static_frames");
  tell(options, configuration,
       model::write_static_set(options.out, set, frames,
                               [&](std::size_t done, std::size_t total) { progress.tell(done, total); }));
}

void write_vectors(const VectorsOptions& options) {
  std::vector<model::NamedFrame> frames;
  model::Configuration configuration =
      model::find_configuration(options.input.config.empty() ? "middle" : options.input.config);
  if (options.input.scene == "merge" || options.input.scene == kMergeExtremes)
    return write_merge(options, configuration);
  if (options.input.scene == "static") return write_static(options, configuration);
  if (options.input.scene == "static_frames") return write_static_frames(options, configuration);
  if (up_converts(configuration.config()) && options.input.scene != "compensation" &&
      options.input.scene != kCompensationExtremes)
    return write_film(options, configuration);
  if (options.input.scene == "compensation" || options.input.scene == kCompensationExtremes || options.compensation)
    return write_compensation(options, configuration);
  const bool between = options.input.scene == "between", extremes = options.input.scene == kExtremes,
             rare = options.input.scene == "rare";
  const bool standard = between || options.input.scene == "standard", largest = options.input.scene == "largest";
  const bool corners = standard || (options.corners && !largest && !extremes && !rare);
  if (!standard && !largest && !extremes && !rare) {
    LoadedScene scene = load_snapped(options.input);
    configuration = scene.configuration;
    tell_if_unseen(scene, !scene.list.triangles.empty());
    frames.push_back({options.input.scene, scene.list});
    if (has_lighting(configuration.config())) frames.back().lighting = lighting_of(scene);
    if (has_texture(configuration.config())) frames.back().texture = texture_of(scene);
    if (has_motion(configuration.config())) frames.back().motion = motion_of(scene);
  }
  const ref::RasterFormat format = model::raster_format(configuration);
  if (largest) frames = model::largest_frames(format);
  if (rare) frames = model::rare_frames(format, configuration.config());
  if (extremes) {
    frames = model::feature_extremes(format, configuration.config());
    if (frames.empty()) frames = model::extreme_frames(format);
  }
  if (corners) {
    frames = model::standard_frames(configuration, options.seed, options.random, options.random_triangles,
                                    std::move(frames));
  } else {
    model::add_awkward(configuration, options.seed, frames);
  }

  model::VectorSetOptions set = set_of(options, configuration);
  if (!corners) set.seed = 0;
  set.window = options.input.window;
  Progress progress("vectors " + set.scene);
  const auto write = between ? model::write_between_set : model::write_vector_set;
  const std::string manifest =
      write(options.out, set, frames, [&](std::size_t done, std::size_t total) { progress.tell(done, total); });
  tell(options, configuration, manifest);
}

}  // namespace

void add_vectors(CLI::App& app, int&) {
  auto options = std::make_shared<VectorsOptions>();
  CLI::App* command = app.add_subcommand("vectors", "write the words of every stream between two units");
  command->footer(
      "  halfspace vectors teapot --config low --lanes 4 --out vectors    one scene, and corner cases before it\n"
      "  halfspace vectors standard --config low --out standard           the corner cases alone\n"
      "Annotated corner cases come first, then random frames, then the frame of SCENE; `standard` as SCENE stands\n"
      "for the first two alone, `largest` for the largest frame and the last index. In a configuration with motion\n"
      "`between` stands for those of `standard`, compensated, and `compensation` for the unit of that name; `merge`\n"
      "in one with objects for the unit that merges buffers. `extremes` stands for the numerical extremes of light,\n"
      "texture, motion and objects, of what the configuration has; `compensation_extremes` and `merge_extremes` for\n"
      "those of the two units; `rare` for orders of events that faults between frames need.\n"
      "`static` writes two sets, OUT/pipeline and OUT/merge: a random sequence of the\n"
      "static objects buffer, of 20x16 pixels if no size is given; `static_frames` one of all streams of such a\n"
      "sequence, for hs_static_frames. In a configuration with frames_between SCENE is animated, and the set is a "
      "film\n"
      "of it, a pass of triangles a frame; `film` stands for one of some. Each stream is a text file that $readmemh "
      "reads;\n"
      "manifest.json tells the fields.\n");
  add_scene_options(command, options->input);
  command->add_option("--lanes", options->lanes, "pixels a stamp: 1, 2, 4, 8, 16; default: the configuration's");
  add_output_folder(command, "--out", options->out, "folder to write")->required();
  command->add_option("--seed", options->seed, "of the random frames")->capture_default_str();
  command->add_flag("--corners,!--no-corners", options->corners, "corner cases and random frames before the scene");
  command->add_option("--random", options->random, "random frames")->capture_default_str()->check(zero_or_more());
  command->add_option("--random-triangles", options->random_triangles, "triangles of a random frame")
      ->capture_default_str()
      ->check(zero_or_more());
  command
      ->add_option("--window", options->input.window,
                   "use indices of invisible triangles again: a triangle takes that of the one so many before it")
      ->check(zero_or_more());
  command
      ->add_option("--first", options->first, "of a film: the frame of the animation, 30 a second, that it begins with")
      ->capture_default_str()
      ->check(zero_or_more());
  command->add_option("--intervals", options->intervals, "of a film: key frames after the first")
      ->capture_default_str()
      ->check(CLI::Range(1, 100000));
  command->add_flag("--compensation", options->compensation,
                    "the streams of motion_compensate, for a frame of SCENE between the keys of --interval");
  command->add_option("--frames", options->frames, "of `static`")->capture_default_str()->check(above_zero());
  command->add_option("--objects", options->objects, "of `static`, and one more; default: 8, of `static_frames` 14")
      ->check(CLI::Range(1, 16));
  command->add_option("--buffers", options->buffers, "of `static`: S-buffers; default: 1, of `static_frames` 3")
      ->check(CLI::Range(1, model::kMostBuffers - 2));
  command->add_flag("--query,!--no-query", options->query, "of `static`: an S-buffer is asked before it is changed");
  command->add_flag("--sv", options->sv,
                    "OUT/vectors.svh as well, constants for a bench of your own: bits, words, frames, fields");
  add_json(command, options->json, "a copy of the manifest");
  command->callback([options] { write_vectors(*options); });
}

}  // namespace halfspace::cli
