// SPDX-License-Identifier: Apache-2.0
// halfspace repro
#include "cli/commands.hpp"
#include "cli/repro/repro_dual.hpp"
#include "cli/repro/repro_frames.hpp"
#include "cli/repro/repro_index.hpp"
#include "cli/repro/repro_morphing.hpp"
#include "cli/repro/repro_static.hpp"

namespace halfspace::cli {

void add_repro(CLI::App& app, int&) {
  CLI::App* command = app.add_subcommand("repro", "the tables of a paper, with our numbers beside the printed ones");
  command->require_subcommand(1);
  command->footer(
      "  halfspace repro A                     index rendering: lightings, buffers and bandwidth of four "
      "architectures\n"
      "  halfspace repro B castle teapot       dual pipeline: instructions and time that deferred lighting saves\n"
      "  halfspace repro C gouraud --frames 11 --size 160x120  frame-rate up-conversion: PSNR of frames that are made, "
      "ten animations\n"
      "  halfspace repro D --table time        bi-directional morphing: which unit works on which frame\n"
      "  halfspace repro E --objects 300 --moving 5 --frames 10 --full-frames 2 --width 160 --height 120  static "
      "objects "
      "buffer;\n"
      "                                        without these numbers 180 M triangles, and minutes\n"
      "docs/repro.md says what the numbers are.\n");
  add_repro_index(*command);
  add_repro_dual(*command);
  add_repro_frames(command);
  add_repro_morphing(*command);
  add_repro_static(*command);
}

}  // namespace halfspace::cli
