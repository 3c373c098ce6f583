// SPDX-License-Identifier: Apache-2.0
#include "cli/repro/index_tables.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/commands.hpp"

namespace halfspace::cli {
namespace {

using model::BufferBits;
using model::BufferBytes;
using model::HardwareLevel;
using model::WidePixel;
using ref::Architecture;
using ref::ShadingMode;

constexpr std::size_t kAlpha = 0, kBeta = 1, kGamma = 2, kDelta = 3;

std::string size_name(int width, int height) { return fmt::format("{}x{}", width, height); }
std::string culling(bool culled) { return culled ? "yes" : "no"; }
// Less, or more.
std::string against(double part, double whole) { return fmt::format("{:+.0f} %", 100 * part / whole - 100); }

template <class Visit>
void each_frame(const Visit& visit) {
  for (const HardwareLevel& level : model::hardware_levels()) {
    for (const auto& [width, height] : level.sizes) {
      for (const ShadingMode mode : ref::kShadingModes) visit(level, width, height, mode);
    }
  }
}

BufferRow moved(BufferRow row, const std::array<ref::BufferUses, 4>& uses) {
  const BufferBits planes = model::buffer_bits(*row.level, row.mode, WidePixel::kPlanes);
  for (std::size_t n = 0; n < 4; ++n) row.bytes[n] = model::buffer_traffic(uses[n], planes);
  row.beta_colour =
      model::buffer_traffic(uses[kBeta], model::buffer_bits(*row.level, row.mode, WidePixel::kInterpolated));
  row.wide_bits = planes.pixel;
  row.even_bits = model::even_pixel_bits(row.bytes[kBeta], row.bytes[kGamma], uses[kBeta].pixel);
  return row;
}

double without_tdbv(const BufferRow& r) { return r.bytes[kGamma].total() - r.bytes[kGamma].visibility; }
double delta_every_pixel(const BufferRow& r) {
  return r.bytes[kDelta].total() - r.bytes[kDelta].shading + r.shading_every_pixel;
}

std::vector<std::string> heading(std::vector<std::string> first, const std::vector<std::string>& more) {
  first.insert(first.end(), more.begin(), more.end());
  return first;
}

std::vector<std::string> frame_cells(const BufferRow& r) {
  return {r.level->config, size_name(r.width, r.height), name_of(r.mode)};
}

std::vector<std::string> moved_cells(const BufferRow& r) {
  const double mb = r.level->frames / 1e6;
  const auto rate = [&](double bytes) { return fmt::format("{:.1f}", bytes * mb); };
  const double beta = r.bytes[kBeta].total();
  return {rate(r.bytes[kAlpha].total()),
          rate(beta),
          rate(r.beta_colour.total()),
          rate(r.bytes[kGamma].total()),
          rate(without_tdbv(r)),
          rate(r.bytes[kDelta].total()),
          against(without_tdbv(r), beta),
          against(r.bytes[kDelta].total(), beta),
          fmt::format("{:.0f} of {}", r.even_bits, r.wide_bits)};
}

const std::vector<std::string> kMovedColumns = {"alpha",        "beta",  "beta, colour",        "gamma",
                                                "gamma - TdbV", "delta", "gamma - TdbV / beta", "delta / beta",
                                                "even at bits"};

}  // namespace

std::vector<BufferRow> size_rows() {
  std::vector<BufferRow> rows;
  each_frame([&](const HardwareLevel& level, int width, int height, ShadingMode mode) {
    BufferRow& row = rows.emplace_back(BufferRow{"", true, &level, width, height, mode, {}, {}});
    for (std::size_t n = 0; n < 4; ++n)
      row.bytes[n] = model::buffer_sizes(level, width, height, ref::kArchitectures[n], mode, WidePixel::kPlanes);
    row.beta_colour = model::buffer_sizes(level, width, height, Architecture::kBeta, mode, WidePixel::kInterpolated);
    row.wide_bits = model::buffer_bits(level, mode, WidePixel::kPlanes).pixel;
  });
  return rows;
}

std::vector<BufferRow> worst_rows() {
  std::vector<BufferRow> rows;
  each_frame([&](const HardwareLevel& level, int width, int height, ShadingMode mode) {
    std::array<ref::BufferUses, 4> uses;
    for (std::size_t n = 0; n < 4; ++n) uses[n] = model::largest_uses(level, width, height, ref::kArchitectures[n]);
    rows.push_back(moved({"", true, &level, width, height, mode, {}, {}}, uses));
    rows.back().shading_every_pixel = rows.back().bytes[kDelta].shading;
  });
  return rows;
}

std::vector<BufferRow> simulated_rows(const std::vector<DrawnModel>& drawn) {
  std::vector<BufferRow> rows;
  for (const DrawnModel& m : drawn) {
    std::array<ref::BufferUses, 4> uses;
    for (std::size_t n = 0; n < 4; ++n) uses[n] = m.rates[n].uses;
    rows.push_back(moved({m.scene, m.culled, m.level, m.width, m.height, m.mode, {}, {}}, uses));
    ref::BufferUses every;
    every.shading = uses[kDelta].shading;
    every.shading.read = m.rates[kDelta].rates.visible_pixels;
    rows.back().shading_every_pixel =
        model::buffer_traffic(every, model::buffer_bits(*m.level, m.mode, WidePixel::kPlanes)).shading;
  }
  return rows;
}

Table lightings_table(const std::vector<DrawnModel>& drawn) {
  Table table{"lightings",
              "Lightings and texture operations, in percent of alpha's; beta saves no lighting with flat and Gouraud "
              "shading.\n"
              "The paper: index rendering saves 10–70 % of them with flat and Gouraud; with Phong it and beta save "
              "30–95 %,\n"
              "and of texture operations the same as with Phong. The paper culls all models but the polyhedron",
              {{"scene", "culled", "level", "frame", "triangles", "flat, Gouraud: gamma, delta", "fragments that pass",
                "Phong: beta, gamma, delta", "texels", "texture: beta, gamma, delta"}}};
  const auto of_alpha = [](const DrawnModel& m, std::uint64_t ref::Rates::*count) {
    return share(double(m.rates[kDelta].rates.*count), double(m.rates[kAlpha].rates.*count));
  };
  for (std::size_t n = 0; n + 2 < drawn.size(); n += std::size(ref::kShadingModes)) {
    const DrawnModel &flat = drawn[n], &gouraud = drawn[n + 1], &phong = drawn[n + 2];
    table.rows.push_back({short_name(flat.scene), culling(flat.culled), flat.level->config,
                          size_name(flat.width, flat.height), grouped(flat.rates[kAlpha].rates.lightings),
                          of_alpha(gouraud, &ref::Rates::lightings), grouped(phong.rates[kAlpha].rates.lightings),
                          of_alpha(phong, &ref::Rates::lightings), grouped(gouraud.rates[kAlpha].rates.texture_fetches),
                          of_alpha(gouraud, &ref::Rates::texture_fetches)});
  }
  return table;
}

Table sizes_table(const std::vector<BufferRow>& rows) {
  Table table{
      "sizes",
      "Buffers, kB. A wide pixel of beta has a copy of the planes, the paper's direct method, or (beta, colour) "
      "what shading needs at the pixel alone.\n"
      "The paper: index rendering takes 70 % less than beta; 130–224 kB at the low end. Of its frames it "
      "names 800x600, 640x480 and 320x200;\n"
      "1024x768 and 160x100 are ours",
      {{"level", "frame", "shading", "alpha", "beta", "beta, colour", "gamma", "delta", "gamma / beta", "delta / beta",
        "gamma / beta, colour", "delta / beta, colour"}}};
  for (const BufferRow& r : rows) {
    std::vector<std::string> cells = frame_cells(r);
    const double beta = r.bytes[kBeta].total(), colour = r.beta_colour.total(), gamma = r.bytes[kGamma].total(),
                 delta = r.bytes[kDelta].total();
    for (const double bytes : {r.bytes[kAlpha].total(), beta, colour, gamma, delta})
      cells.push_back(grouped(std::uint64_t(bytes / 1e3 + 0.5)));
    for (const double whole : {beta, colour})
      cells.push_back(against(gamma, whole)), cells.push_back(against(delta, whole));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

Table worst_table(const std::vector<BufferRow>& rows) {
  Table table{"worst",
              fmt::format("Bandwidth of the worst frame, MB/s: all triangles of the level visible, {} fragments each "
                          "(ours: the paper does not print it), all of which pass,\n"
                          "and each pixel reads TdbS. TdbV can be on chip, so gamma stands without it as well. Even: "
                          "with fewer bits in beta's wide pixel gamma moves more\n"
                          "than beta; the paper's have 100–200. The paper: gamma - TdbV and delta move 50–70 % less "
                          "than beta; 15–81 MB/s at the low end",
                          model::kTrianglePixels),
              {heading({"level", "frame", "shading"}, kMovedColumns)}};
  for (const BufferRow& r : rows) table.rows.push_back(heading(frame_cells(r), moved_cells(r)));
  return table;
}

Table simulated_table(const std::vector<BufferRow>& rows) {
  Table table{
      "simulated",
      "Bandwidth of the models, MB/s. The shader keeps the planes of a triangle over a run of its pixels; "
      "delta, every pixel: it reads TdbS anew for each",
      {heading({"scene", "culled", "level", "frame", "shading"}, heading(kMovedColumns, {"delta, every pixel"}))}};
  for (const BufferRow& r : rows) {
    std::vector<std::string> cells =
        heading({short_name(r.scene), culling(r.culled)}, heading(frame_cells(r), moved_cells(r)));
    cells.push_back(fmt::format("{:.1f}", delta_every_pixel(r) * r.level->frames / 1e6));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

Table claims_table(const std::vector<BufferRow>& worst, const std::vector<BufferRow>& simulated) {
  // What a row moves: alpha, beta, gamma, delta.
  using Moved = std::array<double, 4>;
  const auto as_counted = [](const BufferRow& r) {
    return Moved{r.bytes[0].total(), r.bytes[1].total(), r.bytes[2].total(), r.bytes[3].total()};
  };
  const auto every_pixel = [](const BufferRow& r) {
    const double more = r.shading_every_pixel - r.bytes[kDelta].shading;
    return Moved{r.bytes[0].total(), r.bytes[1].total(), r.bytes[2].total() + more, r.bytes[3].total() + more};
  };
  struct Claim {
    const char* text;
    bool (*holds)(const Moved&);
  };
  constexpr Claim kClaims[] = {{"alpha moves the least",
                                [](const Moved& m) {
                                  return m[0] < std::min({m[1], m[2], m[3]});
                                }},
                               {"beta moves the most",
                                [](const Moved& m) {
                                  return m[1] > std::max({m[0], m[2], m[3]});
                                }},
                               {"gamma moves more than beta", [](const Moved& m) { return m[2] > m[1]; }},
                               {"delta moves half of beta's or less", [](const Moved& m) { return m[3] <= m[1] / 2; }}};
  Table table{
      "claims",
      "In how many frames it is so. The paper has alpha the least in the worst case and of the models, beta the "
      "most of the models,\ngamma more than beta in some, delta at least half less than beta",
      {{"", "worst: flat", "Gouraud", "Phong", "models: flat", "Gouraud", "Phong", "every pixel: flat", "Gouraud",
        "Phong"}}};
  for (const Claim& claim : kClaims) {
    std::vector<std::string> cells = {claim.text};
    const auto add = [&](const std::vector<BufferRow>& rows, const auto& moved_by) {
      for (const ShadingMode mode : ref::kShadingModes) {
        int so = 0, all = 0;
        for (const BufferRow& r : rows) {
          if (r.mode == mode) ++all, so += claim.holds(moved_by(r));
        }
        cells.push_back(fmt::format("{} of {}", so, all));
      }
    };
    add(worst, as_counted), add(simulated, as_counted), add(simulated, every_pixel);
    table.rows.push_back(std::move(cells));
  }
  return table;
}

}  // namespace halfspace::cli
