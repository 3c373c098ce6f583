// SPDX-License-Identifier: Apache-2.0
#include "cli/repro/repro_plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "cli/plots/gnuplot.hpp"

namespace halfspace::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kBuffers[][3] = {
    {"frame_buffer", "frame buffer", "#9aa5ad"},      {"depth_buffer", "Z-buffer", "#4d6a8a"},
    {"pixel_buffer", "wide pixel buffer", "#c0392b"}, {"index_buffer", "I-buffer", "#2a9d5c"},
    {"shading_database", "TdbS", "#e9a13b"},          {"visibility_database", "TdbV", "#8a4fa8"}};

std::string header(int width, int height, const std::string& title) {
  return fmt::format(
      "set terminal pngcairo size {},{} font 'sans,11' background rgb 'white'\nset title {}\n"
      "set style data histograms\nset style fill solid 0.9 border -1\nset grid ytics lt 1 lw 0.5 lc rgb '#cccccc'\n"
      "set key outside right top\nset boxwidth 0.8\nset xtics rotate by 35 right nomirror\nset yrange [0:*]\n",
      width, height, gnuplot_quoted(title));
}

std::string label(const Json& row) {
  return fmt::format("{} {}x{}", fs::path(row.value("scene", row["level"].get<std::string>())).stem().string(),
                     row["width"].get<int>(), row["height"].get<int>());
}

// Lightings of index rendering, of alpha's. Those with flat and Gouraud shading are the same share, and so are those of
// deferred shading and index rendering with Phong.
std::string plot_lightings(const Json& rows, const std::string& folder) {
  std::string picture = (fs::path(folder) / "lightings.png").string();
  std::vector<std::string> order;
  std::map<std::string, std::map<std::string, double>> share;  // label, shading
  for (const Json& row : rows) {
    const std::string name = label(row);
    if (std::find(order.begin(), order.end(), name) == order.end()) order.push_back(name);
    share[name][row["shading"].get<std::string>()] =
        100 * row["delta"]["lightings"].get<double>() / row["alpha"]["lightings"].get<double>();
  }
  std::string script = header(1100, 520, "Lightings, percent of the traditional pipeline's") + "$data << EOD\n";
  for (const std::string& name : order)
    script += fmt::format("\"{}\" {} {}\n", name, share[name]["gouraud"], share[name]["phong"]);
  script +=
      "EOD\nset ylabel 'percent of alpha'\nset yrange [0:110]\nset key outside top center horizontal\n"
      "plot $data using 2:xtic(1) lc rgb '#2a9d5c' title 'gamma, delta: flat, Gouraud (beta: 100)', "
      "$data using 3 lc rgb '#8a4fa8' title 'beta, gamma, delta: Phong'\n";
  run_gnuplot(script, picture);
  return picture;
}

// Stacked buffers of the four architectures, a group of bars a row.
std::string plot_stacks(const std::vector<Json>& rows, const std::string& picture, const std::string& title,
                        const char* unit, double scale) {
  std::string script = header(1200, 560, title) + "set style histogram rowstacked\nset bmargin 8\n$data << EOD\n";
  for (const Json& row : rows) {
    for (const char* architecture : {"alpha", "beta", "gamma", "delta"}) {
      script += fmt::format("\"{} {}\"", architecture, label(row));
      for (const auto& buffer : kBuffers)
        script += fmt::format(" {}", row[architecture][buffer[0]].get<double>() * scale);
      script += "\n";
    }
    script += "\"\" 0 0 0 0 0 0\n";
  }
  script += fmt::format("EOD\nset ylabel {}\nset xtics font ',8'\nplot ", gnuplot_quoted(unit));
  for (std::size_t n = 0; n < std::size(kBuffers); ++n) {
    script += fmt::format("{}$data using {}{} lc rgb '{}' title '{}'", n ? ", " : "", n + 2, n ? "" : ":xtic(1)",
                          kBuffers[n][2], kBuffers[n][1]);
  }
  run_gnuplot(script + "\n", picture);
  return picture;
}

// Rows of Gouraud shading with the paper's wide pixel.
std::vector<Json> chosen(const Json& rows, const std::string& scene) {
  std::vector<Json> out;
  for (const Json& row : rows) {
    if (row["shading"] == "gouraud" && row["wide_pixel"] == "planes" && (scene.empty() || row["scene"] == scene))
      out.push_back(row);
  }
  return out;
}

}  // namespace

std::vector<std::string> plot_index_rendering(const Json& numbers, const std::string& folder) {
  std::vector<std::string> pictures = {plot_lightings(numbers["lightings"], folder)};
  pictures.push_back(plot_stacks(chosen(numbers["sizes"], ""), (fs::path(folder) / "buffers.png").string(),
                                 "Buffers, Gouraud shading, a wide pixel with a copy of its planes", "MB", 1e-6));
  std::vector<Json> rows;
  for (const Json& row : numbers["bandwidth"]) {
    if (row["shading"] == "gouraud" && row["wide_pixel"] == "planes" && row["scene"] != "largest" &&
        row["width"] == 640)
      rows.push_back(row);
  }
  pictures.push_back(plot_stacks(rows, (fs::path(folder) / "bandwidth.png").string(),
                                 "Bandwidth at 640x480, Gouraud shading, 30 frames a second", "MB/s", 30e-6));
  return pictures;
}

std::vector<std::string> plot_lighting_cost(const Json& numbers, const std::string& folder) {
  const std::string picture = (fs::path(folder) / "lighting_cost.png").string();
  std::string script =
      header(900, 480, "Instructions of the geometry stage, percent of type II (cost model)") + "$data << EOD\n";
  const auto add = [&](const std::string& name, const Json& n) {
    const double all = n["type_2"].get<double>();
    script +=
        fmt::format("\"{}\" {} {}\n", name, 100 * n["type_1"].get<double>() / all, 100 * n["dual"].get<double>() / all);
  };
  for (const auto& item : numbers["printed"].items()) add(item.key() + ", printed", item.value());
  for (const Json& row : numbers["measured"]) add(fs::path(row["scene"].get<std::string>()).stem().string(), row);
  script +=
      "EOD\nset ylabel 'percent'\nset yrange [0:110]\nplot $data using 2:xtic(1) lc rgb '#4d6a8a' title 'type I', "
      "$data using 3 lc rgb '#2a9d5c' title 'deferred lighting'\n";
  run_gnuplot(script, picture);
  return {picture};
}

}  // namespace halfspace::cli
