// SPDX-License-Identifier: Apache-2.0
#include "cli/parts/fit_part.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "cli/common/area.hpp"
#include "cli/common/files.hpp"
#include "cli/common/program.hpp"
#include "cli/common/progress.hpp"
#include "model/pipeline/memories.hpp"
#include "ref/error.hpp"
#include "vectors/staging.hpp"

namespace halfspace::cli {
namespace {

constexpr double kLeastPsnr = 15, kStepPsnr = 5;

// The board of rtl/board/ that has the part, or "".
std::string board_of(const Fpga& part) {
  const std::string name = part.name;
  return name == "up5k" ? "icebreaker" : name == "hx8k" ? "hx8k" : "";
}

// Of 16,384 words of 16 bits; two entries of 8 bits share a word.
std::uint64_t single_port_rams(std::uint64_t entries, int bits) {
  if (bits == 0) return 0;
  const std::uint64_t words = bits <= 8 ? (entries + 1) / 2 : entries;
  return (words + 16383) / 16384 * std::uint64_t((bits + 15) / 16);
}

std::string program_itself() { return std::filesystem::read_symlink("/proc/self/exe").string(); }

}  // namespace

std::string lacks_memory(const Fpga& part, const model::Configuration& configuration) {
  if (*part.besides == '\0') {
    const std::uint64_t blocks = frame_blocks(configuration, *part.family);
    return blocks <= std::uint64_t(part.blocks)
               ? ""
               : fmt::format("{} blocks of {} for the memories of a frame", blocks, part.blocks);
  }
  const Config c = configuration.config();
  const model::BufferBits entry = model::entry_bits(c);
  const std::uint64_t pixels = std::uint64_t(c.width) * std::uint64_t(c.height);
  const std::uint64_t rams =
      2 * single_port_rams(pixels, entry.index) + (pixels + 16383) / 16384 * std::uint64_t((entry.depth + 15) / 16);
  return rams <= 4 ? "" : fmt::format("{} single-port RAMs of 4 for I-buffer and Z-buffer", rams);
}

std::string lacks_circuit(const Fpga& part, const model::Configuration& configuration, const std::string& scene,
                          const std::string& work) {
  const Waiting waiting(fmt::format("{} in {}, some minutes", configuration.name(), part.name));
  const std::string board = board_of(part);
  if (board.empty()) {
    const Circuit circuit = measured_circuit(measure_area(configuration, {part.family->target}, work), *part.family);
    const std::string verdict = holds(part, circuit, frame_blocks(configuration, *part.family));
    return verdict == "inside" ? "" : verdict == "outside" ? "blocks for pipeline and memories" : verdict.substr(4);
  }
  model::make_folder(work);
  const std::string toml = work + "/fit.toml";
  model::write_file(toml, model::configuration_toml(configuration));
  const ProgramEnd end =
      run_program({"python3", data_file("rtl/board/bitstream.py"), scene, "--board", board, "--config", toml,
                   "--halfspace", program_itself(), "--no-netlist", "--out", work});
  if (end.status == 0) {
    fmt::print("{}", end.output);
    return "";
  }
  const std::string said = end.said.substr(0, end.said.find_last_not_of('\n') + 1);
  return said.substr(said.find_last_of('\n') + 1);
}

model::Fit fit_in_part(const Fpga& part, const std::string& scene, model::FitGoal goal, bool circuit,
                       const std::string& work, const std::function<model::Fit(const model::FitGoal&)>& search) {
  goal.z_buffer = !board_of(part).empty();
  std::string lacks = "nothing was tried";
  for (; goal.psnr >= kLeastPsnr; goal.psnr -= kStepPsnr) {
    model::Fit found = search(goal);
    lacks = lacks_memory(part, found.configuration);
    if (lacks.empty() && circuit) lacks = lacks_circuit(part, found.configuration, scene, work + "/part");
    fmt::print("{} at {:.0f} dB: {}\n", part.name, goal.psnr,
               !lacks.empty() ? "no: " + lacks
               : circuit      ? "holds pipeline and memories"
                              : "holds the memories; the circuit was not looked at");
    if (lacks.empty()) return found;
  }
  throw ref::Error(fmt::format("{}: no configuration of {:.0f} dB or more fits {}: take a smaller --size", scene,
                               kLeastPsnr, part.name));
}

}  // namespace halfspace::cli
