// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <malloc.h>

#include <cmath>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <limits>

#include "cli/commands.hpp"
#include "cli/common/files.hpp"
#include "ref/error.hpp"
#include "vectors/staging.hpp"

namespace halfspace::cli {

void write_json(const std::string& path, const Json& json) {
  if (!path.empty()) model::write_file(path, json.dump(1) + "\n");
}

std::string short_name(const std::string& scene) { return std::filesystem::path(scene).stem().string(); }

std::string decibels(double psnr) { return std::isinf(psnr) ? "∞" : fmt::format("{:.2f}", psnr); }

namespace {

// JSON has no infinity: two equal frames give null.
Json finite(double value) { return std::isinf(value) ? Json(nullptr) : Json(value); }

}  // namespace

Json to_json(const model::Accuracy& a) {
  return {{"pixels", a.pixels},
          {"covered_differ", a.covered_differ},
          {"index_differ", a.index_differ},
          {"compared", a.compared},
          {"depth_largest_lsb", a.depth_largest},
          {"depth_differ", a.depth_differ},
          {"colour_largest_lsb", a.colour_largest},
          {"colour_differ", a.colour_differ},
          {"depth_psnr_db", finite(a.depth_psnr)},
          {"psnr_db", finite(a.psnr)}};
}

Json to_json(const Config& config) {
  Json json;
  for (const model::ConfigField& field : model::config_fields()) {
    if (field.is_number()) json[field.name] = field.get(config);
    else json[field.name] = field.text(config);
  }
  return json;
}

Json to_json(const ref::Rates& rates) {
  return {{"triangles", rates.triangles},
          {"reduced_triangles", rates.reduced_triangles},
          {"culled", rates.culled},
          {"fragments", rates.fragments},
          {"reduced_fragments", rates.reduced_fragments},
          {"visible_pixels", rates.visible_pixels},
          {"lightings", rates.lightings},
          {"texture_fetches", rates.texture_fetches}};
}

Json all_rates(const ref::Rates& rates) {
  Json json = to_json(rates);
  json.update({{"runs", rates.runs}, {"largest_index", rates.largest_index}});
  return json;
}

Json to_json(const ref::BufferUses& needed, const model::BufferBits& bits, const ref::BufferUses* words) {
  Json json = Json::object();
  for (const model::NamedBuffer& buffer : model::kBuffers) {
    const int entry = bits.*buffer.bits;
    if (entry == 0) continue;
    const ref::BufferUse& use = needed.*buffer.use;
    Json& of = json[buffer.name] = {{"entry_bits", entry},
                                    {"read", use.read},
                                    {"written", use.written},
                                    {"bytes_read", model::bytes_of(use.read, entry)},
                                    {"bytes_written", model::bytes_of(use.written, entry)}};
    if (words == nullptr) continue;
    of["word_bytes_read"] = model::bytes_of((words->*buffer.use).read, entry);
    of["word_bytes_written"] = model::bytes_of((words->*buffer.use).written, entry);
  }
  return json;
}

Json to_json(const model::MemoryBits& bits) {
  return {{"index_buffer", bits.index},       {"depth_buffer", bits.depth},
          {"shading_database", bits.shading}, {"visibility_database", bits.visibility},
          {"object_table", bits.object},      {"total", bits.total()}};
}

}  // namespace halfspace::cli

namespace {

int run(int argc, char** argv) {
  CLI::App app{
      "halfspace: 3-D raster kernels for FPGA. A scene is rendered by the floating-point reference (ref) and by the\n"
      "fixed-point kernels (hls); vector files carry every stream between two units to the co-simulation of the RTL.",
      "halfspace"};
  app.set_version_flag(
      "--version",
      [] { return fmt::format("halfspace {}\nfiles: {}", HALFSPACE_VERSION, halfspace::cli::data_folder()); },
      "the version, and the folder of the RTL and the bench that commands build");
  app.require_subcommand(1);
  app.failure_message([](const CLI::App*, const CLI::Error& error) {
    return fmt::format("halfspace: {}: --help tells the options\n", error.what());
  });
  app.footer(
      "examples\n"
      "  halfspace render teapot -o teapot.png                         a picture by the kernels\n"
      "  halfspace render castle --engine ref --dump ref               index, depth and colour of the reference\n"
      "  halfspace render castle --dump hls                            those of the kernels\n"
      "  halfspace compare ref hls                                     what differs, and where first: then status 1\n"
      "  halfspace vectors teapot --config low --lanes 4 --out vectors  words for a test bench of your own\n"
      "  halfspace compare vectors vectors/stamp.hex --stream stamp     words of your own in the place of the file\n"
      "  halfspace inspect vectors -o report.html                      its last frame, as a page to point at\n"
      "halfspace COMMAND --help tells the options of a command.\n");
  int status = 0;
  halfspace::cli::add_render(app, status);
  halfspace::cli::add_vectors(app, status);
  halfspace::cli::add_compare(app, status);
  halfspace::cli::add_inspect(app, status);
  halfspace::cli::add_shrink(app, status);
  halfspace::cli::add_config(app, status);
  halfspace::cli::add_streams(app, status);
  halfspace::cli::add_fit(app, status);
  halfspace::cli::add_package(app, status);
  halfspace::cli::add_bounds(app, status);
  halfspace::cli::add_report(app, status);
  halfspace::cli::add_repro(app, status);
  halfspace::cli::add_stability(app, status);
  halfspace::cli::add_sweep(app, status);
  halfspace::cli::add_frames(app, status);
  halfspace::cli::add_static(app, status);
  halfspace::cli::add_foresee(app, status);
  halfspace::cli::add_holes(app, status);
  halfspace::cli::add_quality(app, status);
  halfspace::cli::add_cost(app, status);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  } catch (const halfspace::ref::Error& error) {
    std::fprintf(stderr, "halfspace: %s\n", error.what());
    return 1;
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "halfspace: out of memory: use a smaller scene or frame\n");
    return 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "halfspace: %s\n", error.what());
    return 1;
  }
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  // Memory that is given back is kept: scenes of a million triangles pass through lists that are as long.
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
  std::signal(SIGXFSZ, SIG_IGN);  // a file beyond a limit is an error of its write
  const int status = run(argc, argv);
  if (!std::cout.flush() || std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    std::fprintf(stderr, "halfspace: standard output: cannot write it: is the disk full?\n");
    return 1;
  }
  return status;
}
