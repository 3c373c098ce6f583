// SPDX-License-Identifier: Apache-2.0
// Lists of triangles through the OpenGL of the machine, exact arithmetic and the kernels. Coverage of every fragment
// has to be that of exact arithmetic; where depths decide, it is told how many pixels show another triangle, and how
// far off depths are. docs/gpu.md tells what came of it on a GPU.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "model/pipeline/engine.hpp"
#include "ref/error.hpp"
#include "ref/geometry/geometry.hpp"
#include "ref/geometry/triangle_list.hpp"
#include "ref/scene/scene.hpp"
#include "study/bounds/bounds_triangles.hpp"
#include "tests/raster/opengl.hpp"

namespace halfspace::tests {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string config = "middle", json;
  std::vector<std::string> files;
  int lists = 1, triangles = 500;
  std::uint64_t seed = 1;
  bool nudge = false;
};

struct NamedList {
  std::string name;
  ref::SnappedList scene;
};

// The sums that OpenGl::coverage makes, by the top-left rule in integers.
OpenGl::Coverage exact_coverage(const ref::SnappedList& scene) {
  OpenGl::Coverage out;
  out.sum.resize(std::size_t(scene.width) * scene.height);
  const int f = scene.format.subpixel_bits;
  for (std::size_t k = 0; k < scene.triangles.size(); ++k) {
    ref::SnappedTriangle t = scene.triangles[k];
    const auto area = [&] {
      return std::int64_t(t.x[1] - t.x[0]) * (t.y[2] - t.y[0]) - std::int64_t(t.y[1] - t.y[0]) * (t.x[2] - t.x[0]);
    };
    if (area() < 0) std::swap(t.x[1], t.x[2]), std::swap(t.y[1], t.y[2]);
    if (area() == 0) continue;
    const auto [left, right] = std::minmax({t.x[0], t.x[1], t.x[2]});
    const auto [top, bottom] = std::minmax({t.y[0], t.y[1], t.y[2]});
    for (int y = std::max(0, top >> f); y <= std::min(scene.height - 1, bottom >> f); ++y) {
      for (int x = std::max(0, left >> f); x <= std::min(scene.width - 1, right >> f); ++x) {
        bool inside = true;
        for (std::size_t i = 0; i < 3; ++i) {
          const std::size_t j = (i + 1) % 3;
          const std::int64_t dx = t.x[j] - t.x[i], dy = t.y[j] - t.y[i];
          const std::int64_t half = std::int64_t(1) << f >> 1;
          const std::int64_t e =
              dx * ((std::int64_t(y) << f) + half - t.y[i]) - dy * ((std::int64_t(x) << f) + half - t.x[i]);
          inside = inside && (e > 0 || (e == 0 && (dy < 0 || (dy == 0 && dx > 0))));
        }
        if (!inside) continue;
        out.sum[std::size_t(y) * scene.width + x] += fragment_hash(std::uint32_t(k));
        ++out.fragments;
      }
    }
  }
  return out;
}

// What is told of a list.
struct Row {
  std::string name;
  std::size_t triangles = 0;
  std::uint64_t fragments = 0, coverage_differs = 0, shown = 0, gpu_differs = 0, kernels_differ = 0;
  double gpu_depth = 0, kernel_depth = 0;  // largest errors in LSB; the kernels' after they rounded
};

Row compared(OpenGl& gpu, model::Engine& engine, const NamedList& list, bool nudge) {
  const ref::SnappedList& scene = list.scene;
  ref::SnappedList drawn = scene;
  for (ref::SnappedTriangle& t : drawn.triangles) t.x[0] += nudge;
  Row row;
  row.name = list.name;
  row.triangles = scene.triangles.size();
  const OpenGl::Coverage exact = exact_coverage(scene), covered = gpu.coverage(drawn);
  row.fragments = exact.fragments;
  for (std::size_t at = 0; at < exact.sum.size(); ++at) row.coverage_differs += exact.sum[at] != covered.sum[at];
  if (exact.fragments != covered.fragments && row.coverage_differs == 0) row.coverage_differs = 1;

  const ref::Frame expected = ref::render(scene), kernels = engine.render(scene);
  const OpenGl::Visible visible = gpu.visible(drawn);
  const double scale = double(std::uint64_t(1) << scene.format.depth_bits);
  for (std::size_t at = 0; at < expected.index.size(); ++at) {
    const std::uint32_t shown = expected.index[at];
    row.shown += shown != 0;
    row.gpu_differs += visible.index[at] != shown;
    row.kernels_differ += kernels.index[at] != shown;
    if (shown == 0) continue;
    if (visible.index[at] == shown)
      row.gpu_depth = std::max(row.gpu_depth, std::abs(double(visible.depth[at]) * scale - expected.exact_depth[at]));
    if (kernels.index[at] == shown)
      row.kernel_depth = std::max(row.kernel_depth, std::abs(double(kernels.depth[at]) - expected.exact_depth[at]));
  }
  return row;
}

// Of each class a list: with depths as they come, and with one a triangle, a multiple of a LSB, where nothing is left
// to round.
std::vector<NamedList> made_lists(const Options& options, const Config& config, const ref::RasterFormat& format) {
  std::vector<NamedList> out;
  for (int n = 0; n < options.lists; ++n) {
    for (const model::TriangleClass kind : model::kTriangleClasses) {
      model::TriangleSource source(config, options.seed + std::uint64_t(n));
      NamedList list;
      list.name = model::class_name(kind);
      list.scene.format = format;
      list.scene.width = config.width, list.scene.height = config.height;
      for (int k = 0; k < options.triangles; ++k) list.scene.triangles.push_back(source.next(kind));
      out.push_back(list);
      list.name += ", constant depths";
      for (ref::SnappedTriangle& t : list.scene.triangles) t.depth.fill(t.depth[0]);
      out.push_back(std::move(list));
    }
  }
  return out;
}

NamedList list_of(const std::string& name, const Config& config, const ref::RasterFormat& format) {
  if (ref::is_tri_file(name)) return {name, ref::snap(ref::read_tri(name), format)};
  return {name, ref::snap(ref::project(ref::load_scene(name),
                                       {config.width, config.height, format.range_bits, format.subpixel_bits}),
                          format)};
}

void print(const std::vector<Row>& rows, const Options& options, const std::string& renderer) {
  fmt::print("{}\n\n", renderer);
  fmt::print(
      "| list | triangles | fragments | coverage differs | pixels shown | index: GPU differs | kernels ({}) | "
      "depth: GPU, LSB | kernels, rounded |\n|---|---|---|---|---|---|---|---|---|\n",
      options.config);
  for (const Row& r : rows) {
    fmt::print("| {} | {} | {} | {} | {} | {} | {} | {:.4g} | {:.4g} |\n", r.name, r.triangles, r.fragments,
               r.coverage_differs, r.shown, r.gpu_differs, r.kernels_differ, r.gpu_depth, r.kernel_depth);
  }
}

int run(const Options& options) {
  const model::Configuration configuration = model::find_configuration(options.config);
  const Config config = configuration.config();
  const ref::RasterFormat format = model::raster_format(configuration);
  if (config.subpixel_bits != 8 || config.range_bits > 14 || config.depth_bits < 1 || config.depth_bits > 24) {
    throw ref::Error(
        fmt::format("configuration {}: OpenGL draws on a grid of 8 sub-pixel bits in ±8192 pixels, with 24 "
                    "bits of depth exactly: take middle or high",
                    configuration.name()));
  }
  std::vector<NamedList> lists;
  for (const std::string& file : options.files) lists.push_back(list_of(file, config, format));
  if (lists.empty()) lists = made_lists(options, config, format);
  const auto engine = model::make_engine(configuration, 16);
  std::vector<Row> rows;
  std::string renderer;
  for (const NamedList& list : lists) {
    OpenGl gpu(list.scene.width, list.scene.height);
    renderer = fmt::format("{}; {} sub-pixel bits", gpu.renderer(), gpu.subpixel_bits());
    if (gpu.subpixel_bits() != 8) {
      throw ref::Error(
          fmt::format("{}: its positions would be snapped again: take a driver of 8 sub-pixel bits", renderer));
    }
    rows.push_back(compared(gpu, *engine, list, options.nudge));
  }
  print(rows, options, renderer);
  std::uint64_t wrong = 0;
  Json json = {{"renderer", renderer}, {"config", options.config}, {"lists", Json::array()}};
  for (const Row& r : rows) {
    wrong += r.coverage_differs + r.kernels_differ;
    json["lists"].push_back({{"name", r.name},
                             {"triangles", r.triangles},
                             {"fragments", r.fragments},
                             {"coverage_differs", r.coverage_differs},
                             {"shown", r.shown},
                             {"gpu_index_differs", r.gpu_differs},
                             {"kernels_index_differs", r.kernels_differ},
                             {"gpu_depth_error", r.gpu_depth},
                             {"kernels_depth_error", r.kernel_depth}});
  }
  if (!options.json.empty()) std::ofstream(options.json) << json.dump(1) << "\n";
  return wrong == 0 ? 0 : 1;
}

}  // namespace
}  // namespace halfspace::tests

int main(int argc, char** argv) {
  halfspace::tests::Options options;
  CLI::App app{"Lists of triangles through the OpenGL of this machine, exact arithmetic and the kernels."};
  app.footer(
      "  opengl_compare                          made lists of all shapes, with depths and with constant ones\n"
      "  opengl_compare --config high a.tri      lists of triangles, as --dump of render writes them\n"
      "  opengl_compare teapot castle            scenes\n"
      "Fails where coverage differs from exact arithmetic, or the kernels' index from an exact Z-buffer.\n");
  app.add_option("LIST", options.files, "screen-space *.tri, or scenes; default: made lists");
  app.add_option("--config", options.config, "of 8 sub-pixel bits")->capture_default_str();
  app.add_option("--lists", options.lists, "of each class")->capture_default_str();
  app.add_option("--triangles", options.triangles, "of a list")->capture_default_str();
  app.add_option("--seed", options.seed, "of the lists")->capture_default_str();
  app.add_flag("--nudge", options.nudge, "OpenGL alone gets vertex 0 one unit to the right: to see it fail");
  app.add_option("--json", options.json, "the figures, to a file");
  CLI11_PARSE(app, argc, argv);
  try {
    return halfspace::tests::run(options);
  } catch (const std::exception& error) {
    fmt::print(stderr, "opengl_compare: {}\n", error.what());
    return 1;
  }
}
