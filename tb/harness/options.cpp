// SPDX-License-Identifier: Apache-2.0
#include "tb/harness/options.hpp"

#include <CLI/CLI.hpp>
#include <cstdlib>

namespace halfspace::tb {
namespace {

constexpr const char* kUnitHelp =
    "Drives a unit of the RTL alone with the words of a vector set and holds every word that comes out against\n"
    "the set, to the bit. Both sides stall at random. The exit status is 0 only if every word agreed, none was\n"
    "missing or too many, and every stream had words to compare.\n\n"
    "  halfspace vectors teapot --config middle --lanes 4 --out v\n"
    "  tb_ztest_index_middle_4 v\n"
    "  tb_ztest_index_middle_4 v --stall 60 --seed 7\n";

constexpr const char* kPipelineHelp =
    "Runs the whole pipeline of the RTL on the triangles of a vector set and holds every word of every stream\n"
    "between two units against the set, to the bit. The exit status is 0 only if every word agreed, none was missing\n"
    "or too many, and every stream had words to compare.\n\n"
    "  halfspace vectors teapot --config middle --lanes 4 --out v\n"
    "  tb_pipeline_middle_4 v                         cycles a frame, without stalls\n"
    "  tb_pipeline_middle_4 v --stall 30 --seed 7     random stalls on both sides\n"
    "  tb_pipeline_middle_4 v --dump frame.rgba8      the picture that the RTL drew\n";

constexpr const char* kSystemHelp =
    "Draws the frames of a vector set with hs_system: the driver writes triangles and commands into a memory and into\n"
    "registers, through the simulated bus. Holds every stream inside and every pixel of the video against the set, "
    "and\n"
    "each channel against its rules. Prints cycles, and the bytes that each client moved.\n\n"
    "  halfspace vectors teapot --config middle --lanes 4 --no-corners --out v\n"
    "  tb_system_middle_4 v --latency 100\n"
    "  tb_system_middle_4 v --stall 30 --seed 7 --break-read 12   first a frame that an error ends\n";

}  // namespace

Options parse_options(int argc, char** argv, const std::string& top) {
  const bool system = top == "hs_system";
  const bool unit = top != "hs_pipeline" && !system;
  Options options;
  if (unit) options.stall = 30;
  CLI::App app(unit ? kUnitHelp : system ? kSystemHelp : kPipelineHelp);
  app.add_option("vectors", options.vectors, "Folder with manifest.json and the .hex files")->required();
  app.add_option("--seed", options.seed, "Seed of the stalls and of memories without a reset (default 1)");
  app.add_option("--stall", options.stall,
                 std::string("Percent of the cycles in which a partner is not ready, 0 … 90 (default ") +
                     (unit ? "30" : "0") + ")")
      ->check(CLI::Range(0, 90));
  app.add_option("--hang", options.hang, "Cycles without a word that count as a hang (default 20000)")
      ->check(CLI::Range(std::uint64_t(100), std::uint64_t(1) << 40));
  app.add_option("--mutant", options.mutant,
                 "Of a model that tb/mutation.py made: the fault to take (default 0: none)");
  app.add_option("--json", options.json, "Write the report to this file as well; - is standard output");
  app.add_option("--wave", options.wave,
                 "If it fails, repeat it with a model that writes waves, and write those around the first failure to "
                 "this .fst file. The model is built then, once, into FILE.model");
  app.add_option("--around", options.around, "Cycles of --wave before the failure and behind it (default 200)")
      ->check(CLI::Range(1, 1000000));
  app.add_flag("--only-wave", options.only_wave)->group("");
  if (system) {
    app.add_option("--latency", options.latency, "Cycles of the memory to its first word (default 40)")
        ->check(CLI::Range(1, 10000));
    app.add_flag("--refresh,!--no-refresh", options.refresh, "The memory rests 32 cycles of 1024 (default), or not");
    app.add_option("--stop-at", options.stop_at, "First a list that is stopped after so many cycles");
    app.add_option("--reset-at", options.reset_at, "First a list in whose midst all is reset");
    app.add_option("--break-read", options.break_read, "First a list in which this burst that reads has an error");
    app.add_option("--break-write", options.break_write, "First a list in which this burst that writes has one");
  }
  if (system) {
    app.add_option("--pictures", options.pictures, "Folder for frame_rtl.png, the last frame of the video");
  }
  if (!unit) {
    app.add_option("--frames", options.frames,
                   "Draw the last frame of the set N times, back to back (default 2: the second one gives the "
                   "cycles of a frame)")
        ->check(CLI::Range(1, 1000000));
  }
  if (!unit && !system) {
    app.add_option(
           "--outside-latency", options.outside_latency,
           "Of memory outside: cycles from a request to its first word, and then a word a cycle (default: random "
           "latencies, waits and order, from the seed)")
        ->check(CLI::Range(1, 10000));
    app.add_option("--setup-interval", options.setup_interval,
                   "Cycles that triangle_setup takes for a triangle, for the bound (default: SetupInterval of the "
                   "package)")
        ->check(CLI::Range(1, 1000000));
    app.add_option("--dump", options.dump, "Write the last frame that the RTL drew: rgba8, row 0 on top");
    app.add_option("--pictures", options.pictures,
                   "Folder for frame_rtl.png, the last frame as the RTL drew it, and wrong_pixels.png if some are: "
                   "wrong ones red, those that never came blue");
    app.add_option("--dump-index", options.dump_index, "Write its index buffer: u32, little endian, row 0 on top");
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    const int code = app.exit(e);
    std::exit(code == 0 ? 0 : 2);
  }
  return options;
}

}  // namespace halfspace::tb
