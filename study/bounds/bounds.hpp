// SPDX-License-Identifier: Apache-2.0
// Every kernel of a configuration: how far off it may be, by proof, and how far off it has been seen to be, and where.
#ifndef HALFSPACE_STUDY_BOUNDS_BOUNDS_HPP_
#define HALFSPACE_STUDY_BOUNDS_BOUNDS_HPP_

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "model/formats/configuration.hpp"
#include "study/bounds/bounds_triangles.hpp"

namespace halfspace::model {

// Where an error was seen, to look at again.
struct Witness {
  std::string kind;          // class of triangles; what else was looked at
  std::uint64_t number = 0;  // in its class, from 1; 0: no place to look at
  bool is_triangle = false;  // of which there is
  ref::SnappedTriangle triangle{};
  int x = -1, y = -1;  // pixel; −1 for what belongs to the triangle as a whole
};

// In the place of a script: of a table, of which every field is tried.
constexpr const char* kEveryField = "every field";

struct BoundRow {
  std::string kernel;  // empty: the configuration has no such quantity
  std::string quantity, unit;
  std::string proof;  // the script that proves it, or kEveryField; empty: exact, and `seen` counts what differs
  double proved = 0;  // largest |error|
  std::uint64_t compared = 0;
  double seen = 0;             // largest |error|
  std::uint64_t exceeded = 0;  // of the compared values: beyond the bound, for planes that of their very pixel
  Witness where{};

  bool present() const { return !kernel.empty(); }
  bool exact() const { return proof.empty(); }
  // Another value. True when it is the worst so far, or the first that differs: `where` is then to be set.
  bool see(double error, double bound);
  // One that lies outside the premises of `proved`, and has a bound of its own: the first that exceeds it is a place.
  bool hold(double error, double bound);
  bool count(std::uint64_t values, std::uint64_t differ);
};

// The rows of a report, in flow order.
enum Quantity {
  kSnap,
  kEdges,
  kReciprocal,
  kDepthGradient,
  kDepthPlane,
  kDepthPlaneInFrame,
  kCoverage,
  kDepthSteps,
  kDepthRounded,
  kZtest,
  kColourGradient,
  kColourPlane,
  kColourPlaneInFrame,
  kScan,
  kColourSteps,
  kColourRounded,
  kNormalGradient,
  kNormalPlane,
  kNormalPlaneInFrame,
  kNormalSteps,
  kNormalRounded,
  kLightCosine,
  kLightPower,
  kLightSum,
  kLightColour,
  kPhongColour,
  kCoordinateGradient,
  kCoordinatePlane,
  kCoordinatePlaneInFrame,
  kCoordinateSteps,
  kCoordinateRounded,
  kDifferenceGradient,
  kDifferencePlane,
  kDifferencePlaneInFrame,
  kDifferenceSteps,
  kDifferenceRounded,
  kInverse,
  kTexelPlace,
  kTexelFiltered,
  kTexelColour,
  kVector,
  kVectorFits,
  kKeyWeight,
  kKeysShown,
  kKeyColour,
  kCompensated,
  kEntry,
  kMerge,
  kMergeFound,
  kShown,
  kQuantities
};

// What there are planes of.
enum PlaneKind { kDepths, kColours, kNormals, kCoordinates, kDifferences, kPlaneKinds };
const char* plane_name(PlaneKind kind);
Quantity plane_row(PlaneKind kind);  // of the plane before rounding

// Planes before rounding by class of triangles: the largest errors in LSB, and in shares of the bound of the same
// pixel.
struct ClassRow {
  std::string name;
  std::uint64_t triangles = 0, pixels = 0;
  struct Largest {
    double error = 0, share = 0;
  };
  std::array<Largest, kPlaneKinds> planes{};
};

struct BoundsReport {
  std::vector<BoundRow> rows;  // by Quantity
  std::vector<ClassRow> classes;

  bool holds() const;  // nothing exceeded, and something compared in every row that is present
};

// The rows with nothing seen.
BoundsReport proved_bounds(const Config& config);

struct MeasureOptions {
  int triangles = 400;  // of each class
  std::uint64_t seed = 1;
  std::function<void(std::size_t done, std::size_t total)> progress;  // may be empty
};

// Runs the kernels of the configuration.
BoundsReport measured_bounds(const Configuration& configuration, const MeasureOptions& options);

}  // namespace halfspace::model

#endif  // HALFSPACE_STUDY_BOUNDS_BOUNDS_HPP_
