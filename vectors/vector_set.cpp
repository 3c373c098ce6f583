// SPDX-License-Identifier: Apache-2.0
#include "vectors/vector_set.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "model/formats/field_meanings.hpp"
#include "model/formats/field_value.hpp"
#include "model/formats/stream_list.hpp"
#include "model/pipeline/cycles.hpp"
#include "model/pipeline/engine.hpp"
#include "ref/error.hpp"
#include "vectors/staging.hpp"

namespace halfspace::model {
namespace {

using Json = nlohmann::ordered_json;

// A .hex file and the digest of its text.
class HexFile {
 public:
  // At `path` until the set is whole.
  HexFile(const std::string& path, std::string name, const Layout& layout)
      : name_(std::move(name)), layout_(layout), file_(path, std::ios::binary) {
    EVP_DigestInit_ex(digest_.get(), EVP_sha256(), nullptr);
  }

  void comment(const std::string& text) { put("// " + text + "\n"); }

  void words(const Word* words, std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) {
      append_hex(text, words[i], layout_.bits);
      text += '\n';
      if (text.size() > 1 << 16) put(text), text.clear();
    }
    put(text);
    frame_words_.push_back(count);
  }

  // The stream's entry in the manifest.
  Json close() {
    file_.close();
    if (!file_)
      throw ref::Error(fmt::format("{}: cannot write it: the disk is full, or a limit (ulimit -f) is too low", name_));
    unsigned char bytes[EVP_MAX_MD_SIZE];
    unsigned size = 0;
    EVP_DigestFinal_ex(digest_.get(), bytes, &size);
    std::string sha256;
    for (unsigned i = 0; i < size; ++i) sha256 += fmt::format("{:02x}", bytes[i]);
    std::size_t total = 0;
    for (std::size_t n : frame_words_) total += n;
    const std::string record = record_name(layout_.row);
    const RecordOrder order = record_order(record);
    Json fields = Json::array();
    for (const Field& field : layout_.fields) {
      const FieldMeaning meaning = field_meaning(record, field.name);
      fields.push_back({{"name", field.name},
                        {"lsb", field.lsb},
                        {"width", field.width},
                        {"count", field.count},
                        {"signed", field.is_signed},
                        {"fraction", field.fraction},
                        {"meaning", meaning.meaning},
                        {"unit", meaning.unit},
                        {"valid_if", meaning.valid_if}});
    }
    return {{"name", layout_.stream},
            {"from", layout_.row.from},
            {"to", layout_.row.to},
            {"file", layout_.stream + ".hex"},
            {"bits", layout_.bits},
            {"words", total},
            {"frame_words", frame_words_},
            {"sha256", sha256},
            {"context", layout_.row.place},
            {"what", layout_.row.what},
            {"order", order.order},
            {"any_order_within", order.any_order_within},
            {"fields", fields}};
  }

 private:
  void put(const std::string& text) {
    file_ << text;
    EVP_DigestUpdate(digest_.get(), text.data(), text.size());
  }

  std::string name_;
  Layout layout_;
  std::ofstream file_;
  std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)> digest_{EVP_MD_CTX_new(), EVP_MD_CTX_free};
  std::vector<std::size_t> frame_words_;
};

// The files of a set. `described` are the frames' entries in the manifest; `capture` gives the words of frame n to its
// sink, and adds to its entry what is known only then.
std::string write_streams(const std::string& folder, const VectorSetOptions& options, int lanes_x, int lanes_y,
                          const std::vector<Layout>& layouts, Json described,
                          const std::function<void(std::size_t n, Json& entry, const WordSink&)>& capture,
                          const std::function<void(std::size_t, std::size_t)>& progress) {
  const Configuration& configuration = options.configuration;
  StagedFolder staged(folder);
  std::map<std::string, HexFile> files;
  for (const Layout& layout : layouts) {
    const std::string name = layout.stream + ".hex";
    files.emplace(layout.stream, HexFile(staged.path(name), folder + "/" + name, layout));
    files.at(layout.stream)
        .comment(fmt::format("{} {} lanes {}: {} bits a word", layout.stream, configuration.name(), options.lanes,
                             layout.bits));
  }
  const WordSink sink = [&](const Layout& layout, const Word* words, std::size_t count) {
    files.at(layout.stream).words(words, count);
  };
  for (std::size_t n = 0; n < described.size(); ++n) {
    for (auto& [name, file] : files) {
      file.comment(fmt::format("frame {}: {}, {}x{}", n, described[n]["note"].get<std::string>(),
                               described[n]["width"].get<int>(), described[n]["height"].get<int>()));
    }
    capture(n, described[n], sink);
    if (progress) progress(n + 1, described.size());
  }

  Json streams = Json::array();
  for (const Layout& layout : layouts) streams.push_back(files.at(layout.stream).close());
  Json manifest = {{"format", "halfspace-vectors 1"},
                   {"scene", options.scene},
                   {"config", configuration.name()},
                   {"lanes_x", lanes_x},
                   {"lanes_y", lanes_y},
                   {"seed", options.seed},
                   {"frames", described},
                   {"streams", streams}};
  if (options.window != 0) manifest["window"] = options.window;
  std::string text = manifest.dump(1) + "\n";
  staged.write("manifest.json", text);
  staged.commit();
  return text;
}

// The set of a unit that stands alone. describe(json, result) adds what else is told of a frame.
template <class Unit, class Frame, class Describe>
std::string write_unit_set(const std::string& folder, const VectorSetOptions& options, const Unit& unit,
                           const std::vector<Frame>& frames,
                           const std::function<void(std::size_t, std::size_t)>& progress, Describe describe) {
  Json described = Json::array();
  for (const Frame& frame : frames) {
    described.push_back({{"width", frame.width},
                         {"height", frame.height},
                         {"background", {0, 0, 0}},
                         {"triangles", 0},
                         {"note", frame.note}});
  }
  const auto capture = [&](std::size_t n, Json& json, const WordSink& sink) {
    std::vector<StreamWords> streams;
    const auto done = unit.capture(frames[n].input(), streams);
    for (const StreamWords& stream : streams) sink(stream.layout, stream.words.data(), stream.words.size());
    describe(json, done);
    json["cycles"] = done.cycles;
  };
  const StampSize stamp = stamp_size(options.lanes);
  return write_streams(folder, options, stamp.x, stamp.y, unit.layouts(), std::move(described), capture, progress);
}

Json described_frames(const std::vector<NamedFrame>& frames) {
  Json described = Json::array();
  for (const NamedFrame& frame : frames) {
    described.push_back({{"width", frame.scene.width},
                         {"height", frame.scene.height},
                         {"background", frame.scene.background},
                         {"triangles", frame.scene.triangles.size()},
                         {"note", frame.note}});
  }
  return described;
}

// Counts the stamps that the rasterizer visits in each frame, an empty triangle as one. It draws the frame with an
// engine of its own, as the other one has to see each frame once; not where a frame is drawn only with indices given.
class VisitCounter {
 public:
  explicit VisitCounter(const VectorSetOptions& options)
      : config_(options.configuration.config()), engine_(make_engine(options.configuration, options.lanes)) {
    engine_->reuse_indices(options.window);
  }
  std::uint64_t operator()(const NamedFrame& frame) {
    load_frame(*engine_, config_, frame);
    std::uint64_t sum = 0;
    for (const int visits : engine_->visits(frame.scene)) sum += std::uint64_t(std::max(visits, 1));
    return sum;
  }

 private:
  const Config config_;
  const std::unique_ptr<Engine> engine_;
};

// A word of `motion` that shows no face: it ends a frame whose last stamp is empty.
RawMotion ending_word(const Layout& layout, const Word& word) {
  RawMotion out;
  out.x = int(field_value(word, field_named(layout, "x")));
  out.y = int(field_value(word, field_named(layout, "y")));
  return out;
}

// Whether a stream comes or goes at a port of hs_pipeline, or is the one that a frame's end is told by.
bool is_of_ports(const Layout& layout) { return is_port(layout.row) || layout.stream == "scan"; }

}  // namespace

std::string write_vector_set(const std::string& folder, const VectorSetOptions& options,
                             const std::vector<NamedFrame>& frames,
                             const std::function<void(std::size_t, std::size_t)>& progress) {
  if (frames.empty()) throw ref::Error("a vector set needs a frame at least: name a scene");
  const Configuration& configuration = options.configuration;
  const auto engine = make_engine(configuration, options.lanes);
  engine->reuse_indices(options.window);
  VisitCounter visits_of(options);
  std::vector<Layout> layouts = engine->layouts();
  if (options.ports)
    layouts.erase(std::remove_if(layouts.begin(), layouts.end(), [](const Layout& l) { return !is_of_ports(l); }),
                  layouts.end());
  const auto capture = [&](std::size_t n, Json& frame, const WordSink& sink) {
    load_frame(*engine, configuration.config(), frames[n]);
    if (!gives_indices(configuration.config())) frame["visits"] = visits_of(frames[n]);
    engine->capture(frames[n].scene, [&](const Layout& layout, const Word* words, std::size_t count) {
      if (!options.ports || is_of_ports(layout)) sink(layout, words, count);
    });
  };
  return write_streams(folder, options, engine->lanes_x(), engine->lanes_y(), layouts, described_frames(frames),
                       capture, progress);
}

std::string write_between_set(const std::string& folder, const VectorSetOptions& options,
                              const std::vector<NamedFrame>& frames,
                              const std::function<void(std::size_t, std::size_t)>& progress) {
  const Configuration& configuration = options.configuration;
  const Compensator compensator(configuration);
  const auto engine = make_engine(configuration, options.lanes);
  VisitCounter visits_of(options);
  std::vector<Layout> layouts = engine->layouts();
  for (const Layout& layout : compensator.layouts()) {
    if (layout.stream != "motion") layouts.push_back(layout);
  }
  const auto capture = [&](std::size_t n, Json& frame, const WordSink& sink) {
    const ref::SnappedList& scene = frames[n].scene;
    load_frame(*engine, configuration.config(), frames[n]);
    frame["visits"] = visits_of(frames[n]);
    std::vector<RawMotion> motion = engine->motion(scene, nullptr);
    engine->capture(scene, [&](const Layout& layout, const Word* words, std::size_t count) {
      sink(layout, words, count);
      if (layout.stream == "motion" && count > motion.size()) motion.push_back(ending_word(layout, words[count - 1]));
    });
    std::vector<StreamWords> streams;
    const NamedCompensation between =
        between_frame(configuration.config(), scene.width, scene.height, std::move(motion), options.seed + n);
    compensator.capture(between.input(), streams);
    for (const StreamWords& stream : streams) {
      if (stream.layout.stream != "motion") sink(stream.layout, stream.words.data(), stream.words.size());
    }
  };
  return write_streams(folder, options, engine->lanes_x(), engine->lanes_y(), layouts, described_frames(frames),
                       capture, progress);
}

std::string write_film_set(const std::string& folder, const VectorSetOptions& options,
                           const std::vector<FilmPass>& passes,
                           const std::function<void(std::size_t, std::size_t)>& progress) {
  const auto engine = make_film_engine(options.configuration, options.lanes);
  static const char* const kNames[] = {"key", "between", "fill"};
  Json described = Json::array();
  for (const FilmPass& pass : passes) {
    Json frame = described_frames({pass.frame})[0];
    frame["pass"] = kNames[int(pass.pass)];
    frame["interval"] = pass.pass == Pass::kKey ? std::max(pass.key - 1, 0) : pass.key;
    if (pass.field != 0) {
      frame["field"] = pass.field;
      frame["weight"] = field_weight(options.configuration.config(), pass.field);
    }
    described.push_back(std::move(frame));
  }
  const auto capture = [&](std::size_t n, Json& frame, const WordSink& sink) {
    const FilmDrawn drawn = engine->run(passes[n], sink);
    frame["film"] = drawn.shown.size();
    frame["answers"] = drawn.answers;
    if (passes[n].pass == Pass::kBetween) frame["holes"] = drawn.holes;
    if (passes[n].pass == Pass::kFill) frame["filled"] = drawn.filled;
  };
  return write_streams(folder, options, engine->lanes_x(), engine->lanes_y(), engine->layouts(), described, capture,
                       progress);
}

std::string write_compensation_set(const std::string& folder, const VectorSetOptions& options,
                                   const std::vector<NamedCompensation>& frames,
                                   const std::function<void(std::size_t, std::size_t)>& progress) {
  return write_unit_set(folder, options, Compensator(options.configuration), frames, progress,
                        [](Json& json, const CompensatedFrame& done) { json["misses"] = done.misses; });
}

std::string write_merge_set(const std::string& folder, const VectorSetOptions& options,
                            const std::vector<NamedMerge>& runs,
                            const std::function<void(std::size_t, std::size_t)>& progress) {
  return write_unit_set(folder, options, Merger(options.configuration, options.lanes), runs, progress,
                        [](Json&, const MergeResult&) {});
}

std::string write_static_set(const std::string& folder, const VectorSetOptions& options,
                             const std::vector<StaticSequenceFrame>& frames,
                             const std::function<void(std::size_t, std::size_t)>& progress) {
  const Configuration& configuration = options.configuration;
  if (frames.empty() || frames[0].passes.empty()) throw ref::Error("a sequence needs a frame at least, with triangles");
  const ref::SnappedList& any = frames[0].passes[0].scene;
  const auto engine = make_engine(configuration, options.lanes);
  engine->reuse_indices(options.window);
  StaticRuns runs(configuration, options.lanes, any.width, any.height);
  std::vector<Layout> layouts = engine->layouts();
  for (const Layout& layout : runs.layouts()) {
    if (layout.stream != "entry") layouts.push_back(layout);
  }
  Json described = Json::array();
  for (const StaticSequenceFrame& frame : frames) {
    std::size_t triangles = 0;
    for (const NamedFrame& pass : frame.passes) triangles += pass.scene.triangles.size();
    described.push_back({{"width", any.width},
                         {"height", any.height},
                         {"background", any.background},
                         {"triangles", triangles},
                         {"note", frame.note}});
  }
  const auto capture = [&](std::size_t n, Json& entry, const WordSink& sink) {
    std::map<std::string, std::vector<Word>> words;
    std::vector<std::vector<RawEntry>> passes;
    std::uint64_t cycles = frames[n].run_cycles;
    for (const NamedFrame& pass : frames[n].passes) {
      load_frame(*engine, configuration.config(), pass);
      engine->capture(pass.scene, [&](const Layout& layout, const Word* of_pass, std::size_t count) {
        // What all passes of a frame find in the registers of hs_pipeline is sent once.
        if (layout.row.kind == StreamKind::kLoaded && !passes.empty()) return;
        std::vector<Word>& all = words[layout.stream];
        all.insert(all.end(), of_pass, of_pass + count);
      });
      cycles += model_cycles(configuration.config(), *engine, pass.scene, engine->render(pass.scene)).frame;
      passes.push_back(StaticFrames::entries(*engine, configuration, pass));
    }
    entry["cycles"] = cycles;
    std::size_t taken = 0;
    std::vector<RawEntry> shown;
    for (const RawCommand& command : frames[n].commands) {
      std::vector<StreamWords> streams;
      StaticRunResult result = runs.run(command, command.passes ? &passes.at(taken) : nullptr, &streams);
      taken += command.passes;
      if (command.shows) shown = std::move(result.shown);
      for (const StreamWords& stream : streams) {
        if (stream.layout.stream == "entry") continue;
        std::vector<Word>& all = words[stream.layout.stream];
        all.insert(all.end(), stream.words.begin(), stream.words.end());
      }
    }
    if (taken != passes.size() || !(shown == frames[n].picture))
      throw ref::Error(fmt::format("frame {}: its commands do not show it: please report it with the command line", n));
    for (const Layout& layout : layouts) sink(layout, words[layout.stream].data(), words[layout.stream].size());
  };
  const StampSize stamp = stamp_size(options.lanes);
  return write_streams(folder, options, stamp.x, stamp.y, layouts, std::move(described), capture, progress);
}

}  // namespace halfspace::model
