// SPDX-License-Identifier: Apache-2.0
#include "vectors/vector_set.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "model/pipeline/engine.hpp"
#include "ref/error.hpp"
#include "vectors/staging.hpp"

namespace halfspace::model {
namespace {

using Json = nlohmann::ordered_json;

struct Ends {
  const char *from, *to, *context;
};
const std::map<std::string, Ends> kEnds = {
    {"triangle", {"geometry", "triangle_setup", ""}},
    {"setup", {"triangle_setup", "raster_pineda", ""}},
    {"attributes", {"triangle_setup", "shade_setup", ""}},
    {"planes", {"shade_setup", "tdbs", ""}},
    {"triangle_depth", {"raster_pineda", "ztest_plane", ""}},
    {"stamp", {"raster_pineda", "ztest_index", ""}},
    {"update", {"ztest_index", "buffers", ""}},
    {"visible", {"ztest_index", "geometry", ""}},
    {"scan", {"scan_index", "shade_gouraud", ""}},
    {"pixel", {"shade_gouraud", "frame", "scan"}},
    {"light", {"host", "light_vertex", ""}},
    {"material", {"host", "light_vertex", ""}},
    {"normals", {"geometry", "light_vertex", ""}},
    {"colours", {"light_vertex", "shade_setup", ""}},
    {"visible_attributes", {"visible_select", "shade_setup", ""}},
    {"texture", {"host", "shade_texture", ""}},
    {"texel", {"host", "shade_texture", ""}},
    {"texture_coordinates", {"geometry", "texture_setup", ""}},
    {"key_weight", {"host", "motion_compensate", ""}},
    {"key_request_0", {"motion_compensate", "key_memory", ""}},
    {"key_request_1", {"motion_compensate", "key_memory", ""}},
    {"key_block_0", {"key_memory", "motion_compensate", ""}},
    {"key_block_1", {"key_memory", "motion_compensate", ""}},
    {"compensated", {"motion_compensate", "frame", ""}},
    {"texture_planes", {"texture_setup", "tdbs", ""}},
    {"lit", {"shade_gouraud", "shade_texture", "scan"}},
    {"motion_vectors", {"geometry", "motion_setup", ""}},
    {"motion_planes", {"motion_setup", "tdbs", ""}},
    {"motion", {"motion_field", "motion_compensate", ""}},
    {"entry", {"scan_object", "ztest_merge", "scan"}},
    {"merge", {"driver", "ztest_merge", ""}},
    {"stored", {"s_buffer", "ztest_merge", ""}},
    {"merged", {"ztest_merge", "frame", ""}},
    {"found", {"ztest_merge", "driver", ""}},
};

// A .hex file and the digest of its text.
class HexFile {
 public:
  HexFile(const std::string& path, const Layout& layout, const Config& config)
      : path_(path), layout_(layout), config_(config), file_(path, std::ios::binary) {
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
    if (!file_) throw ref::Error(fmt::format("{}: cannot write it: is the disk full?", path_));
    unsigned char bytes[EVP_MAX_MD_SIZE];
    unsigned size = 0;
    EVP_DigestFinal_ex(digest_.get(), bytes, &size);
    std::string sha256;
    for (unsigned i = 0; i < size; ++i) sha256 += fmt::format("{:02x}", bytes[i]);
    std::size_t total = 0;
    for (std::size_t n : frame_words_) total += n;
    Json fields = Json::array();
    for (const Field& field : layout_.fields) {
      fields.push_back({{"name", field.name},
                        {"lsb", field.lsb},
                        {"width", field.width},
                        {"count", field.count},
                        {"signed", field.is_signed},
                        {"fraction", field.fraction}});
    }
    Ends ends = kEnds.at(layout_.stream);
    // Units that stand where others do in kEnds.
    auto replace = [&](const char* unit, const char* by) {
      for (const char** end : {&ends.from, &ends.to}) *end = std::strcmp(*end, unit) ? *end : by;
    };
    if (is_deferred(config_)) {
      if (layout_.stream == "attributes") ends.to = "visible_select";
      if (layout_.stream == "visible") ends.from = "visible_select";
    }
    if (has_texture(config_) && layout_.stream == "pixel") ends.from = "shade_texture";
    if (has_motion(config_)) replace("shade_setup", "motion_setup"), replace("shade_gouraud", "motion_field");
    if (tests_planes(config_)) replace("ztest_index", "ztest_plane");
    if (is_phong(config_)) {
      replace("shade_setup", "phong_setup"), replace("shade_gouraud", "shade_phong");
      const bool of_frame = layout_.stream == "light" || layout_.stream == "material";
      replace("light_vertex", of_frame ? "shade_phong" : "phong_setup");
    }
    return {{"name", layout_.stream},
            {"from", ends.from},
            {"to", ends.to},
            {"file", layout_.stream + ".hex"},
            {"bits", layout_.bits},
            {"words", total},
            {"frame_words", frame_words_},
            {"sha256", sha256},
            {"context", ends.context},
            {"fields", fields}};
  }

 private:
  void put(const std::string& text) {
    file_ << text;
    EVP_DigestUpdate(digest_.get(), text.data(), text.size());
  }

  std::string path_;
  Layout layout_;
  Config config_;
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
    files.emplace(layout.stream, HexFile(staged.path(layout.stream + ".hex"), layout, configuration.config()));
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
  const std::string text = manifest.dump(1) + "\n";
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

// Whether a stream comes or goes at a port of hs_pipeline, or is the one that a frame's end is told by.
bool is_of_ports(const Layout& layout) {
  static const char* const kPorts[] = {
      "light",          "material", "texture", "texel",  "triangle", "normals", "texture_coordinates",
      "motion_vectors", "visible",  "scan",    "motion", "entry",    "pixel"};
  return std::any_of(std::begin(kPorts), std::end(kPorts), [&](const char* name) { return layout.stream == name; });
}

}  // namespace

std::string write_vector_set(const std::string& folder, const VectorSetOptions& options,
                             const std::vector<NamedFrame>& frames,
                             const std::function<void(std::size_t, std::size_t)>& progress) {
  if (frames.empty()) throw ref::Error("a vector set needs a frame at least: name a scene");
  const Configuration& configuration = options.configuration;
  const auto engine = make_engine(configuration, options.lanes);
  engine->reuse_indices(options.window);
  Json described = Json::array();
  for (const NamedFrame& frame : frames) {
    described.push_back({{"width", frame.scene.width},
                         {"height", frame.scene.height},
                         {"background", frame.scene.background},
                         {"triangles", frame.scene.triangles.size()},
                         {"note", frame.note}});
  }
  std::vector<Layout> layouts = engine->layouts();
  if (options.ports)
    layouts.erase(std::remove_if(layouts.begin(), layouts.end(), [](const Layout& l) { return !is_of_ports(l); }),
                  layouts.end());
  const auto capture = [&](std::size_t n, Json&, const WordSink& sink) {
    load_frame(*engine, configuration.config(), frames[n]);
    engine->capture(frames[n].scene, [&](const Layout& layout, const Word* words, std::size_t count) {
      if (!options.ports || is_of_ports(layout)) sink(layout, words, count);
    });
  };
  return write_streams(folder, options, engine->lanes_x(), engine->lanes_y(), layouts, std::move(described), capture,
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

}  // namespace halfspace::model
