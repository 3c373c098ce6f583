// SPDX-License-Identifier: Apache-2.0
// halfspace inspect: a frame of a vector set, and what the co-simulation said of it, as one page.
#include <fmt/format.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

#include "cli/commands.hpp"
#include "inspect_page.hpp"  // made of cli/inspect/ by the build
#include "ref/error.hpp"
#include "ref/raster/raster.hpp"
#include "tb/harness/vectors.hpp"
#include "vectors/staging.hpp"

namespace halfspace::cli {
namespace {

namespace fs = std::filesystem;

struct InspectOptions {
  std::string folder, out;
  int frame = 0;  // from 1; 0: the last one
};

std::string base64(const std::string& bytes) {
  static const char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve(bytes.size() * 4 / 3 + 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::uint32_t group = 0;
    for (std::size_t n = 0; n < 3; ++n) group = group << 8 | (at + n < bytes.size() ? std::uint8_t(bytes[at + n]) : 0);
    for (std::size_t n = 0; n < 4; ++n) {
      text += at + n > bytes.size() ? '=' : kDigits[group >> (18 - 6 * n) & 63];
    }
  }
  return text;
}

std::string whole_file(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return bytes.str();
}

Json json_file(const fs::path& path) {
  Json json = Json::parse(whole_file(path), nullptr, false);
  if (json.is_discarded()) throw ref::Error(fmt::format("{}: not JSON: run what wrote it again", path.string()));
  return json;
}

// The stream's entry of the manifest, and its words of a frame, as bytes, least significant first.
Json inspected_stream(const Json& entry, const tb::Stream& stream, std::size_t frame) {
  std::size_t begin = 0;
  for (std::size_t f = 0; f < frame; ++f) begin += stream.frame_words[f];
  const std::size_t bytes = std::size_t(stream.bits + 7) / 8, count = stream.frame_words[frame];
  std::string data;
  for (std::size_t n = begin; n < begin + count; ++n) {
    data.append(reinterpret_cast<const char*>(stream.words[n]), bytes);
  }
  return {{"name", stream.name},
          {"from", stream.from},
          {"to", stream.to},
          {"what", entry.value("what", "")},
          {"order", entry.value("order", "")},
          {"fields", entry.at("fields")},
          {"bytes", bytes},
          {"begin", begin},
          {"words", count},
          {"data", base64(data)}};
}

// The triangles of a frame as the words have them; none if they have no colour, as where light is a thing of the RTL.
ref::SnappedList inspected_triangles(const tb::Vectors& vectors, std::size_t frame) {
  const tb::Stream& stream = *vectors.find("triangle");
  const tb::Frame& of = vectors.frames[frame];
  const auto value = [&](const std::uint32_t* word, const std::string& name) -> std::int64_t {
    const tb::Field* const field = stream.find(name);
    if (!field) return 0;
    const std::uint64_t raw = field->raw(word);
    const int unused = 64 - field->width;
    return field->is_signed ? std::int64_t(raw << unused) >> unused : std::int64_t(raw);
  };
  const bool flat = stream.find("r") != nullptr;
  const tb::Field &x0 = stream.need("x0", "inspect"), *const depth = stream.find("depth0");
  ref::SnappedList list{};
  list.format.name = vectors.config;
  list.format.width = list.width = int(of.width);
  list.format.height = list.height = int(of.height);
  list.format.subpixel_bits = x0.fraction;
  list.format.range_bits = x0.width - x0.fraction;
  list.format.depth_bits = depth ? depth->width : 0;
  list.format.flat = flat;
  if (const tb::Field* const red = stream.find(flat ? "r" : "r0")) list.format.colour_bits = red->width;
  for (int c = 0; c < 3; ++c) list.background[std::size_t(c)] = std::uint8_t(of.background[c]);
  std::size_t n = 0;
  for (std::size_t f = 0; f < frame; ++f) n += stream.frame_words[f];
  for (const std::size_t end = n + stream.frame_words[frame]; n < end; ++n) {
    const std::uint32_t* const word = stream.words[n];
    if (value(word, "index") == 0) continue;
    ref::SnappedTriangle t{};
    for (std::size_t v = 0; v < 3; ++v) {
      const std::string number = std::to_string(v);
      t.x[v] = std::int32_t(value(word, "x" + number));
      t.y[v] = std::int32_t(value(word, "y" + number));
      t.depth[v] = std::uint32_t(value(word, "depth" + number));
      for (std::size_t c = 0; c < 3; ++c) {
        t.rgb[v][c] = std::uint8_t(value(word, std::string(1, "rgb"[c]) + (flat ? "" : number)));
      }
    }
    list.triangles.push_back(t);
  }
  list.format.triangles = int(list.triangles.size());
  return list;
}

template <class T>
std::string base64_of(const std::vector<T>& values) {
  return base64(std::string(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)));
}

// What the floating-point reference makes of the same triangles; null where the words do not tell: colours that light
// or texture make, and indices that are used again.
Json inspected_reference(const tb::Vectors& vectors, std::size_t frame) {
  const tb::Stream* const stream = vectors.find("triangle");
  const bool coloured = stream && (stream->find("r0") || stream->find("r"));
  if (!coloured || vectors.find("texture") || vectors.window != 0) return nullptr;
  const ref::Frame drawn = ref::render(inspected_triangles(vectors, frame));
  return {{"index", base64_of(drawn.index)}, {"depth", base64_of(drawn.depth)}, {"rgba", base64_of(drawn.colour)}};
}

Json inspected_data(const InspectOptions& options, const fs::path& set) {
  tb::Vectors vectors = tb::load_manifest(set.string());
  const Json manifest = json_file(set / "manifest.json");
  const std::size_t frame = options.frame == 0 ? vectors.frames.size() - 1 : std::size_t(options.frame - 1);
  if (frame >= vectors.frames.size()) {
    throw ref::Error(fmt::format("--frame {}: the set has {} frames", options.frame, vectors.frames.size()));
  }
  Json streams = Json::array();
  for (std::size_t n = 0; n < vectors.streams.size(); ++n) {
    tb::load_words(set.string(), &vectors.streams[n]);
    streams.push_back(inspected_stream(manifest["streams"][n], vectors.streams[n], frame));
  }
  Json data = {{"scene", vectors.scene},
               {"config", vectors.config},
               {"lanes_x", vectors.lanes_x},
               {"lanes_y", vectors.lanes_y},
               {"width", vectors.frames[frame].width},
               {"height", vectors.frames[frame].height},
               {"note", vectors.frames[frame].note},
               {"frame", frame},
               {"frames", vectors.frames.size()},
               {"reference", inspected_reference(vectors, frame)},
               {"streams", std::move(streams)}};
  const fs::path folder(options.folder);
  if (fs::exists(folder / "cosim.json")) {
    const Json cosim = json_file(folder / "cosim.json");
    if (cosim.contains("runs") && !cosim["runs"].empty()) data["cosim"] = cosim["runs"][0];
  }
  // The picture of the RTL is of the last frame.
  if (frame + 1 == vectors.frames.size() && fs::exists(folder / "frame_rtl.png")) {
    data["rtl_png"] = base64(whole_file(folder / "frame_rtl.png"));
  }
  return data;
}

std::string filled(std::string text, const std::string& name, const std::string& value) {
  const std::size_t at = text.find("@" + name + "@");
  return text.replace(at, name.size() + 2, value);
}

void inspect(const InspectOptions& options) {
  const fs::path folder(options.folder), inner = folder / "vectors";
  const fs::path set = fs::exists(folder / "manifest.json") ? folder : inner;
  if (!fs::exists(set / "manifest.json")) {
    throw ref::Error(
        fmt::format("{}: there is no vector set in it: give a folder that `make demo`, `make cosim` or "
                    "`halfspace vectors` has left",
                    options.folder));
  }
  Json data;
  try {
    data = inspected_data(options, set);
  } catch (const tb::Error& error) {
    throw ref::Error(error.what());
  }
  // No text of the data may end the element that it stands in.
  std::string text = data.dump();
  for (std::size_t at = 0; (at = text.find("</", at)) != std::string::npos;) text.replace(at, 2, "<\\/");
  const std::string title =
      fmt::format("halfspace: {} {}", short_name(data["scene"]), data["config"].get<std::string>());
  const std::string page = filled(filled(filled(kInspectHtml, "SCRIPT", kInspectScript), "DATA", text), "TITLE", title);
  model::write_file(options.out, page);
  fmt::print("{}: {} MB, a page for any browser\n", options.out, (page.size() + 500000) / 1000000);
}

}  // namespace

void add_inspect(CLI::App& app, int&) {
  auto options = std::make_shared<InspectOptions>();
  CLI::App* command = app.add_subcommand("inspect", "a frame, its words and its co-simulation as one page to look at");
  command->footer(
      "Of a set that `halfspace vectors` wrote, or of what `make cosim` or `make demo` left. Point at a pixel: what "
      "it\n"
      "shows in reference, kernels and RTL, and its words on every stream. Click it, or name a triangle: its setup, "
      "its\n"
      "stamps, and why it is seen or not. Of a co-simulation besides: what is wrong, as places to jump to, and when\n"
      "streams moved and waited. One file, which needs no server.\n");
  command->add_option("DIR", options->folder, "what `make demo`, `make cosim` or `halfspace vectors` left")->required();
  command->add_option("-o,--out", options->out, "the page, .html")->required();
  command->add_option("--frame", options->frame, "of the set, from 1 (default: the last one)")
      ->check(CLI::Range(1, 1000000));
  command->callback([options] { inspect(*options); });
}

}  // namespace halfspace::cli
