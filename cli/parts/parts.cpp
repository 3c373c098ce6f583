// SPDX-License-Identifier: Apache-2.0
#include "cli/parts/parts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "model/pipeline/memories.hpp"
#include "ref/error.hpp"

namespace halfspace::cli {
namespace {

constexpr Family kSeries7 = {"xilinx", "7-series", 18, "DSP48E1"};
constexpr Family kEcp5 = {"ecp5", "ECP5", 18, "MULT18X18D"};
constexpr Family kIce40 = {"ice40", "iCE40", 4, "SB_MAC16"};

struct Shape {
  int words, bits;
};
constexpr Shape kShapes18[] = {{512, 36}, {1024, 18}, {2048, 9}, {4096, 4}, {8192, 2}, {16384, 1}};
constexpr Shape kShapes4[] = {{256, 16}, {512, 8}, {1024, 4}, {2048, 2}};

std::uint64_t blocks(std::uint64_t words, int bits, const Family& family) {
  if (bits == 0) return 0;
  std::uint64_t fewest = ~std::uint64_t(0);
  const auto look = [&](const auto& shapes) {
    for (const Shape& shape : shapes) {
      fewest = std::min(fewest, (words + std::uint64_t(shape.words) - 1) / std::uint64_t(shape.words) *
                                    std::uint64_t((bits + shape.bits - 1) / shape.bits));
    }
  };
  if (family.block_kbit == 4) look(kShapes4);
  else look(kShapes18);
  return fewest;
}

std::uint64_t address(int entries) {
  std::uint64_t power = 1;
  while (power < std::uint64_t(entries)) power *= 2;
  return power;
}

}  // namespace

// Block RAMs of 36 kbit are two of 18 here.
const std::vector<Fpga>& parts() {
  static const std::vector<Fpga> list = {
      {"up5k", &kIce40, 5280, 8, 30, "4 single-port RAMs of 256 kbit", "Lattice FPGA-DS-02008"},
      {"hx8k", &kIce40, 7680, 0, 32, "", "Lattice FPGA-DS-02029"},
      {"ecp5-25", &kEcp5, 24288, 28, 56, "", "Lattice FPGA-DS-02012"},
      {"ecp5-45", &kEcp5, 43848, 72, 108, "", "Lattice FPGA-DS-02012"},
      {"ecp5-85", &kEcp5, 83640, 156, 208, "", "Lattice FPGA-DS-02012"},
      {"zynq-7010", &kSeries7, 17600, 80, 120, "", "AMD DS190"},
      {"zynq-7020", &kSeries7, 53200, 220, 280, "", "AMD DS190"},
      {"artix-35t", &kSeries7, 20800, 90, 100, "", "AMD DS180"},
      {"artix-100t", &kSeries7, 63400, 240, 270, "", "AMD DS180"},
      {"artix-200t", &kSeries7, 134600, 740, 730, "", "AMD DS180"}};
  return list;
}

const Fpga& find_part(const std::string& name) {
  std::string names;
  for (const Fpga& part : parts()) {
    if (name == part.name) return part;
    names += (names.empty() ? "" : ", ") + std::string(part.name);
  }
  throw ref::Error(fmt::format("there is no part {}: use one of {}", name, names));
}

std::uint64_t frame_blocks(const model::Configuration& configuration, const Family& family) {
  const Config c = configuration.config();
  const model::BufferBits entry = model::entry_bits(c);
  const std::uint64_t pixels = std::uint64_t(c.width) * std::uint64_t(c.height), entries = address(c.triangles);
  return 2 * blocks(pixels, entry.index, family) +
         std::uint64_t(has_objects(c) ? 2 : 1) * blocks(pixels, entry.depth, family) +
         blocks(2 * entries, entry.shading, family) + blocks(entries, entry.visibility, family) +
         blocks(2 * entries, entry.object, family) +
         (has_texture(c) ? blocks(2 * entries, model::coordinate_planes_bits(c), family) : 0);
}

std::optional<Circuit> known_circuit(const std::string& configuration, const Family& family) {
  struct Known {
    const char *configuration, *target;
    Circuit circuit;
  };
  static constexpr Known kKnown[] = {
      {"low", "xilinx", {3885, 11, 9}},     {"low", "ecp5", {6132, 19, 9}},     {"low", "ice40", {11716, 0, 39}},
      {"middle", "xilinx", {4649, 13, 11}}, {"middle", "ecp5", {7606, 23, 11}}, {"middle", "ice40", {15357, 0, 49}},
      {"high", "xilinx", {5364, 19, 13}},   {"high", "ecp5", {8342, 23, 13}},   {"high", "ice40", {17509, 0, 56}}};
  for (const Known& known : kKnown) {
    if (configuration == known.configuration && std::string(family.target) == known.target) return known.circuit;
  }
  return std::nullopt;
}

Circuit measured_circuit(const Json& area, const Family& family) {
  for (const Json& row : area["rows"]) {
    if (row["unit"] == "pipeline" && row["target"] == family.target)
      return {row["lut"].get<int>(), row["dsp"].get<int>(), row["bram"].get<int>()};
  }
  throw ref::Error("the area tool tells nothing of the pipeline: this is a fault of the program");
}

std::string holds(const Fpga& part, const std::optional<Circuit>& circuit, std::uint64_t frame_blocks) {
  const Circuit needs = circuit.value_or(Circuit{0, 0, 0});
  const char* unknown = circuit ? "" : "?";
  std::string lacks;
  const auto look = [&](std::uint64_t needed, int there, const char* what) {
    if (needed > std::uint64_t(there)) lacks += (lacks.empty() ? "" : ", ") + std::string(what);
  };
  look(std::uint64_t(needs.luts), part.luts, "LUTs");
  look(std::uint64_t(needs.multipliers), part.multipliers, "multipliers");
  look(std::uint64_t(needs.blocks), part.blocks, "blocks");
  if (!lacks.empty()) return "no: " + lacks;
  return (frame_blocks + std::uint64_t(needs.blocks) <= std::uint64_t(part.blocks) ? "inside" : "outside") +
         std::string(unknown);
}

}  // namespace halfspace::cli
