// SPDX-License-Identifier: Apache-2.0
// Which unit works on which frame, where some frames are rendered and those between them made, from the cycles of each.
#ifndef HALFSPACE_CLI_MOTION_TIMELINE_HPP_
#define HALFSPACE_CLI_MOTION_TIMELINE_HPP_

#include <array>
#include <string>
#include <vector>

#include "cli/commands.hpp"

namespace halfspace::cli {

enum class Stage { kTriangles, kShading, kField, kCompensation };
constexpr int kStages = 4;
const char* name_of(Stage);

// Cycles of the frames from a key, number 0, to before the next: key frames are drawn and shaded, the others drawn,
// scanned out as motion, and compensated.
using StageCycles = std::array<double, kStages>;

struct StageWork {
  Stage stage;
  int frame;
  double start, end;
};
struct Timeline {
  std::vector<StageWork> work;
  double period = 0;  // cycles from a frame that is shown to the next
  double delay = 0;   // cycles from when a frame's triangles are there until it is shown, of all frames the same
};

// Of so many intervals, and the key that ends the last. Triangles of frame n are there at n periods; the keys on either
// side of a frame are drawn before it. With `overlap` a unit goes on with the next frame while the one behind it is at
// work, by two buffers between them; else a frame is finished before the next begins. A period of 0 is the shortest
// that the units keep up with.
Timeline timeline(const std::vector<StageCycles>& frames, int intervals, bool overlap, double period = 0);

// A row a unit, a colour a frame, both below each other.
void plot_timeline(const Timeline& in_turn, const Timeline& overlapped, int between, const std::string& title,
                   const std::string& picture);

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_MOTION_TIMELINE_HPP_
