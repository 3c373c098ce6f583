// SPDX-License-Identifier: Apache-2.0
// The kernels behind a plain interface: a configuration and a number of lanes are chosen at run time.
#ifndef HALFSPACE_VECTORS_ENGINE_HPP_
#define HALFSPACE_VECTORS_ENGINE_HPP_

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "ref/raster.hpp"
#include "ref/snap.hpp"
#include "vectors/layout.hpp"

namespace halfspace::vectors {

struct FormatConstant {
  std::string name;  // as in the RTL package
  int value;
};
struct FormatType {
  std::string name;
  int width;
  bool is_signed;
};

// Receives the words of one stream of one frame, in order.
using WordSink = std::function<void(const Layout&, const Word*, std::size_t count)>;

class Engine {
 public:
  virtual ~Engine() = default;

  virtual int lanes_x() const = 0;
  virtual int lanes_y() const = 0;
  // In flow order: triangle, setup, attributes, planes, stamp, update, visible, scan, pixel.
  virtual std::vector<Layout> layouts() const = 0;
  virtual std::vector<FormatConstant> constants() const = 0;
  virtual std::vector<FormatType> types() const = 0;

  // Renders with the kernels. exact_depth and exact_colour stay empty.
  virtual ref::Frame render(const ref::SnappedList& scene) = 0;
  // The picture alone.
  virtual void render_colour(const ref::SnappedList& scene, std::vector<std::array<std::uint8_t, 4>>& colour) = 0;
  // The same frame, each stream told to `sink` once, in flow order.
  virtual void capture(const ref::SnappedList& scene, const WordSink& sink) = 0;
};

// `lanes` is 1, 2, 4, 8 or 16. Throws ref::Error for a name or number that there is not.
std::unique_ptr<Engine> make_engine(const std::string& config, int lanes);

// The named configurations, smallest first.
std::vector<ref::RasterFormat> raster_formats();
ref::RasterFormat raster_format(const std::string& config);

}  // namespace halfspace::vectors

#endif  // HALFSPACE_VECTORS_ENGINE_HPP_
