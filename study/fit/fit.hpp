// SPDX-License-Identifier: Apache-2.0
// The cheapest configuration that draws a scene as accurately as asked, with its lights and its textures.
//
// The search begins with a configuration that is more than enough and takes away: units that may not be there at all
// (the Z-buffer; planes of normals, of colours; weights of texels, the division a pixel), and then a step of each
// number as long as every frame keeps the goal, again until nothing more can go. It does so in several orders, and then
// tries whether a step more of one number saves more of the others; what costs least is taken. Type γ, which draws the
// same frames, takes the place of what needs a Z-buffer where it is smaller, unless pixels know their objects. The
// range, the frame, the numbers of triangles, lights, materials and textures follow from the scene. So a step less
// anywhere is refused or breaks the goal, which `less` shows for each number and each unit.
#ifndef HALFSPACE_STUDY_FIT_FIT_HPP_
#define HALFSPACE_STUDY_FIT_FIT_HPP_

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "model/formats/configuration.hpp"
#include "ref/scene/scene.hpp"
#include "study/trade/trade.hpp"

namespace halfspace::model {

// What is to be least: bits of the memories of a frame; LUTs or DSPs, of which the bits of all numbers in the circuit
// tell the search, and a synthesis the best of what it found; cycles or bytes of the frame that takes most.
enum class FitCost { kMemory, kLut, kDsp, kCycles, kBytes };
constexpr const char* kFitCosts[] = {"memory", "lut", "dsp", "cycles", "bytes"};

struct FitGoal {
  double psnr = 45;  // dB against the ideal picture, of each frame; 0: not asked
  double max_lsb =
      0;  // largest error of a colour against the ideal, LSB of 8 bits, where both show the same face; 0: not asked
  std::int64_t wrong_pixels = -1;  // of a frame, that show another face than the ideal; −1: not asked
  ref::IdealLook look = {};        // of the ideal picture. Distant: the hardware lights
  FitCost cost = FitCost::kMemory;
  // LUTs or DSPs of a configuration, by a synthesis; none: the bits of its numbers decide alone.
  std::function<double(const Configuration&)> measured = nullptr;
  std::uint64_t cycles = 0;     // a frame at most, by the model; 0: not asked
  bool static_objects = false;  // S-buffers for what stands still, where they save cycles
  bool z_buffer = false;        // type delta, whatever it takes
};

struct FitScene {
  std::string name;
  int width, height;
  std::vector<double> times;  // seconds, of the frames; all of a view, then all of the next
  std::vector<Subject> frames;
  std::size_t views = 1;

  std::size_t side(std::size_t frame) const { return frame / (frames.size() / views); }
  bool begins_view(std::size_t frame) const { return frame % (frames.size() / views) == 0; }
};

// What the scene asks for, over all frames.
struct Requirements {
  double x_low = 0, x_high = 0, y_low = 0, y_high = 0;  // of the vertices in view, pixels, unclipped
  std::size_t triangles = 0;                            // largest number in a frame
  double depth_gradient = 0;                            // largest, of full scale a pixel
  double colour_gradient = 0;                           // largest, LSB of 8 a pixel
  double depth_separation =
      1;  // smallest distance between the two nearest surfaces of a pixel, of full scale; 1: no pixel has two
  std::uint64_t overlapping = 0;  // pixels with two surfaces or more
  bool one_colour_each = true;    // no triangle has vertices of different colours
  double motion = 0;              // largest step of a vertex from frame to frame, pixels
};
Requirements requirements(const FitScene&);

struct FitOutcome {
  bool holds = false;
  std::string why;  // the goal that is missed, or the refusal
  double psnr = 0, largest_lsb = 0;
  std::uint64_t wrong_pixels = 0;
  std::size_t triangles = 0;
};

struct FitLess {
  std::string change;  // "depth_bits 16 -> 15", "shading phong -> gouraud"
  std::string result;  // why not
};

// Type γ beside type δ, where the scene needs depth: the memories in which they differ, and the cycles of the slowest
// frame by the model. γ is taken if TdbV has fewer bits than the Z-buffer, and a frame takes no more cycles than the
// goal allows or, where it asks for none, than kGammaCycles of δ's.
struct FitArchitecture {
  std::uint64_t z_buffer_bits = 0, tdbv_bits = 0, cycles_delta = 0, cycles_gamma = 0;  // 0: without depth
  std::string why;                                                                     // the one that is taken is
};
constexpr double kGammaCycles = 1.02;

// Static objects buffers, where they are asked for: pixels know their objects if some of a frame's move, some stand
// still, and what moves alone takes fewer cycles than all of it. Type γ has no depths to merge, and is not taken then.
struct FitObjects {
  std::size_t objects = 0, moving = 0, standing = 0;  // instances: all; most, and fewest, of a frame
  std::uint64_t cycles_all = 0, cycles_moving = 0;    // of the slowest frame by the model; 0: not looked at
  std::string why;                                    // they are there, or not; empty: not asked for
};
// Makes `c` have them. `cycles_of` are those of the slowest frame.
FitObjects choose_objects(Config& c, const FitScene&,
                          const std::function<std::uint64_t(const FitScene&, const Config&)>& cycles_of);

struct Fit {
  Configuration configuration;
  FitOutcome outcome;
  std::vector<FitLess> less;
  std::uint64_t tried = 0;  // configurations
  std::size_t ends = 1;     // of the search, where nothing could be taken away
  double cost = 0;          // as it was asked for; LUTs and DSPs that no synthesis counted: bits of numbers
  FitArchitecture architecture;
  FitObjects objects;
};

// `lanes` 0: the fewest that keep the goal's cycles. Throws ref::Error when no configuration reaches the goal, with the
// best that one does. `progress` hears how many configurations have been tried.
Fit fit_configuration(const FitScene&, const std::string& name, const FitGoal&, int lanes,
                      const std::function<void(std::uint64_t)>& progress);

// Renders every frame with `configuration` and holds it to the goal, by other means than the search: with the engine
// that the configuration has (compiled if it is a named one) and another number of lanes.
FitOutcome check_fit(const FitScene&, const Configuration&, const FitGoal&, int lanes);

}  // namespace halfspace::model

#endif  // HALFSPACE_STUDY_FIT_FIT_HPP_
