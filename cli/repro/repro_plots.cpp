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
      "set terminal pngcairo size {},{} noenhanced font 'sans,11' background rgb 'white'\nset title {}\n"
      "set style data histograms\nset style fill solid 0.9 border -1\nset grid ytics lt 1 lw 0.5 lc rgb '#cccccc'\n"
      "set key outside right top\nset boxwidth 0.8\nset xtics rotate by 35 right nomirror\nset yrange [0:*]\n",
      width, height, gnuplot_quoted(title));
}

std::string frame_of(const Json& row) {
  return fmt::format("{}x{}", row["width"].get<int>(), row["height"].get<int>());
}

std::string model_of(const Json& row) { return fs::path(row["scene"].get<std::string>()).stem().string(); }

// Lightings of index rendering, of alpha's. Those with flat and Gouraud shading are the same share, and so are those of
// deferred shading and index rendering with Phong.
std::string plot_lightings(const Json& rows, const std::string& folder) {
  std::string picture = (fs::path(folder) / "lightings.png").string();
  std::vector<std::string> order;
  std::map<std::string, std::map<std::string, double>> share;  // label, shading
  for (const Json& row : rows) {
    const std::string name =
        fmt::format("{}{} {}", model_of(row), row["culled"].get<bool>() ? "" : ", not culled", frame_of(row));
    if (std::find(order.begin(), order.end(), name) == order.end()) order.push_back(name);
    share[name][row["shading"].get<std::string>()] =
        100 * row["delta"]["lightings"].get<double>() / row["alpha"]["lightings"].get<double>();
  }
  std::string script = header(1300, 560, "Lightings, percent of the traditional pipeline's") +
                       "set xtics rotate by 50 right font ',8'\n$data << EOD\n";
  for (const std::string& name : order)
    script += fmt::format("\"{}\" {} {}\n", name, share[name]["gouraud"], share[name]["phong"]);
  script +=
      "EOD\nset ylabel 'percent of alpha'\nset yrange [0:110]\nset key outside top center horizontal\n"
      "plot $data using 2:xtic(1) lc rgb '#2a9d5c' title 'gamma, delta: flat, Gouraud (beta: 100)', "
      "$data using 3 lc rgb '#8a4fa8' title 'beta, gamma, delta: Phong'\n";
  run_gnuplot(script, picture);
  return picture;
}

constexpr const char* kArchitectures[][2] = {
    {"alpha", "#9aa5ad"}, {"beta", "#c0392b"}, {"gamma", "#2a9d5c"}, {"delta", "#4d6a8a"}};

std::vector<Json> rows_of(const Json& rows, const char* shading, const std::string& level) {
  std::vector<Json> out;
  for (const Json& row : rows) {
    if (row["shading"] == shading && row["level"] == level) out.push_back(row);
  }
  return out;
}

struct Grid {
  const char *file, *title, *unit;
  double scale;
  bool a_second;  // times the frames of the level
};

// A panel for each shading, below each other, and each level, beside each other, as it has a scale of its own. `bars`
// writes the data of a panel and how it is drawn.
template <class Bars>
std::string plot_grid(const Json& rows, const Grid& grid, const std::string& folder, int width, const Bars& bars) {
  const std::string picture = (fs::path(folder) / grid.file).string();
  std::string script =
      header(width, 1150, "") + fmt::format(
                                    "unset title\nset xtics font ',8'\nset label 1 {} at screen 0.01,0.985 left\n"
                                    "set multiplot layout 3,3 margins 0.045,0.99,0.085,0.915 spacing 0.045,0.12\n",
                                    gnuplot_quoted(fmt::format("{}, {}", grid.title, grid.unit)));
  int panel = 0;
  for (const char* shading : {"flat", "gouraud", "phong"}) {
    for (const char* level : {"high", "middle", "low"}) {
      const std::vector<Json> of = rows_of(rows, shading, level);
      const double scale = grid.a_second ? grid.scale * of[0]["frames"].get<double>() : grid.scale;
      script += fmt::format(
          "set title '{}, {}'\n{}\n", level, shading,
          ++panel == 3 ? "set key at screen 0.99,0.995 right top vertical maxrows 2 samplen 2 width 2" : "unset key");
      script += bars(of, fmt::format("$p{}", panel), scale);
    }
  }
  run_gnuplot(script + "unset multiplot\n", picture);
  return picture;
}

// The four architectures side by side in each frame, buffers stacked.
std::string stacked(const std::vector<Json>& rows, const std::string& data, double scale) {
  std::string script = "set style histogram rowstacked\n" + data + " << EOD\n";
  for (const Json& row : rows) {
    for (const auto& architecture : kArchitectures) {
      script += fmt::format("\"{} {}\"", architecture[0], frame_of(row));
      for (const auto& buffer : kBuffers)
        script += fmt::format(" {}", row[architecture[0]][buffer[0]].get<double>() * scale);
      script += "\n";
    }
    if (&row != &rows.back()) script += "\"\" 0 0 0 0 0 0\n";
  }
  script += "EOD\nplot ";
  for (std::size_t n = 0; n < std::size(kBuffers); ++n) {
    script += fmt::format("{}{} using {}{} lc rgb '{}' title '{}'", n ? ", " : "", data, n + 2, n ? "" : ":xtic(1)",
                          kBuffers[n][2], kBuffers[n][1]);
  }
  return script + "\n";
}

// Sums alone, as the paper has them of its models.
std::string clustered(const std::vector<Json>& rows, const std::string& data, double scale) {
  std::string script = "set style histogram clustered gap 1\n" + data + " << EOD\n";
  for (const Json& row : rows) {
    script += fmt::format("\"{} {}\"", model_of(row), frame_of(row));
    for (const auto& architecture : kArchitectures)
      script += fmt::format(" {}", row[architecture[0]]["total"].get<double>() * scale);
    script += "\n";
  }
  script += "EOD\nplot ";
  for (std::size_t n = 0; n < std::size(kArchitectures); ++n) {
    script += fmt::format("{}{} using {}{} lc rgb '{}' title '{}'", n ? ", " : "", data, n + 2, n ? "" : ":xtic(1)",
                          kArchitectures[n][1], kArchitectures[n][0]);
  }
  return script + "\n";
}

Json with_culling(const Json& rows, bool culled) {
  Json out = Json::array();
  for (const Json& row : rows) {
    if (row["culled"] == culled) out.push_back(row);
  }
  return out;
}

}  // namespace

std::vector<std::string> plot_index_rendering(const Json& numbers, const std::string& folder) {
  return {
      plot_lightings(numbers["lightings"], folder),
      plot_grid(numbers["sizes"], {"buffers.png", "Buffers, a wide pixel with a copy of its planes", "MB", 1e-6, false},
                folder, 1300, stacked),
      plot_grid(
          numbers["worst"],
          {"worst.png", "Bandwidth of the worst frame, a wide pixel with a copy of its planes", "MB/s", 1e-6, true},
          folder, 1300, stacked),
      plot_grid(with_culling(numbers["simulated"], true),
                {"models.png", "Bandwidth of the models, culled", "MB/s", 1e-6, true}, folder, 1300, clustered),
      plot_grid(with_culling(numbers["simulated"], false),
                {"models_not_culled.png", "Bandwidth of the models, not culled", "MB/s", 1e-6, true}, folder, 1300,
                clustered)};
}

std::vector<std::string> plot_lighting_cost(const Json& numbers, const std::string& folder) {
  const std::string picture = (fs::path(folder) / "lighting_cost.png").string();
  std::string script =
      header(1000, 480, "Instructions of the geometry stage, percent of type II (cost model)") + "$data << EOD\n";
  const auto add = [&](const std::string& name, const Json& seen, const Json* passed) {
    const double all = seen["type_2"]["instructions"].get<double>();
    const auto percent = [&](const Json& type) { return 100 * type["instructions"].get<double>() / all; };
    script += fmt::format("\"{}\" {} {} {}\n", name, percent(seen["type_1"]), percent(seen["dual"]),
                          passed == nullptr ? "NaN" : fmt::format("{}", percent((*passed)["dual"])));
  };
  for (const auto& item : numbers["printed"].items()) add(item.key() + ", printed", item.value(), nullptr);
  for (const Json& row : numbers["measured"])
    add(fs::path(row["scene"].get<std::string>()).stem().string(), row["seen"], &row["passed"]);
  script +=
      "EOD\nset ylabel 'percent'\nset yrange [0:110]\nplot $data using 2:xtic(1) lc rgb '#4d6a8a' title 'type I', "
      "$data using 3 lc rgb '#2a9d5c' title 'dual, c: seen in the end', "
      "$data using 4 lc rgb '#e9a13b' title 'dual, c: a fragment passed'\n";
  run_gnuplot(script, picture);
  return {picture};
}

}  // namespace halfspace::cli
