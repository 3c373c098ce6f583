// SPDX-License-Identifier: Apache-2.0
// The kernels behind a plain interface: a configuration and a number of lanes are chosen at run time.
#ifndef HALFSPACE_MODEL_PIPELINE_ENGINE_HPP_
#define HALFSPACE_MODEL_PIPELINE_ENGINE_HPP_

#include <memory>
#include <string>
#include <vector>

#include "hls/formats/records.hpp"
#include "model/formats/configuration.hpp"
#include "model/formats/layout.hpp"
#include "model/formats/stamps.hpp"
#include "model/motion/motion.hpp"
#include "model/motion/motion_words.hpp"
#include "model/objects/object_words.hpp"
#include "model/shade/lighting.hpp"
#include "model/texture/texture.hpp"
#include "ref/geometry/snap.hpp"
#include "ref/raster/raster.hpp"

namespace halfspace::model {

class Engine {
 public:
  virtual ~Engine() = default;

  virtual int lanes_x() const = 0;
  virtual int lanes_y() const = 0;
  // Of the streams that the configuration has, in flow order: those of hls/formats/streams.hpp.
  virtual std::vector<Layout> layouts() const = 0;

  // Of a configuration with lighting, before a frame is drawn: its lights, its materials, and the normals of its
  // triangles.
  virtual void light(const LightingFrame& frame) = 0;

  // Of a configuration with texture, before a frame is drawn: its textures, and the coordinates of its triangles.
  virtual void texture(const TextureFrame& frame) = 0;

  // Of a motion configuration, before a frame is drawn: where its triangles are in the key frames.
  virtual void move(const MotionFrame& frame) = 0;
  // Of a configuration with objects, before a frame is drawn: the number of the object of each triangle, 1 …
  // 2^object_bits − 1; none: all are of object 1.
  virtual void number(const std::vector<std::uint32_t>& objects) = 0;
  // Not 0: from now on indices of invisible triangles are used again, by the rule of ref::IndexReuse with this window,
  // and a frame may have more triangles than there are indices. render() throws ref::Error when they are used up. A
  // configuration with an index_window has that one, whatever is said here.
  virtual void reuse_indices(int window) = 0;
  // How many of its triangles, from the first on, there are indices for.
  virtual std::size_t fits(const ref::SnappedList& scene) = 0;

  // Renders with the kernels. exact_depth and exact_colour stay empty; of a motion configuration colour too.
  virtual ref::Frame render(const ref::SnappedList& scene) = 0;
  // The picture alone.
  virtual void render_colour(const ref::SnappedList& scene, std::vector<std::array<std::uint8_t, 4>>& colour) = 0;
  // Of a motion configuration the motion field: the words of `motion`, one a pixel that shows a face. `frame`, unless
  // it is null, takes the index and the depth of each pixel.
  virtual std::vector<RawMotion> motion(const ref::SnappedList& scene, ref::Frame* frame) = 0;
  // Of a configuration with objects the frame as `entry` has it, row by row.
  virtual std::vector<RawEntry> entries(const ref::SnappedList& scene) = 0;
  // How many stamps the rasterizer visits for each triangle, covered or not: its cycles.
  virtual std::vector<int> visits(const ref::SnappedList& scene) = 0;
  // What the stamps of each triangle cost ztest_plane; of type δ, nothing.
  virtual std::vector<PlaneTests> plane_tests(const ref::SnappedList& scene) = 0;
  // The same frame, each stream told to `sink` once, in flow order. With an index_window triangles that there is no
  // index for are not drawn, as in hardware; their words of `visible` have index 0.
  virtual void capture(const ref::SnappedList& scene, const WordSink& sink) = 0;
};

// Are its kernels compiled? Those of the named configurations are, with any number of lanes.
bool is_compiled(const Configuration& configuration);

// `lanes` is 1, 2, 4, 8 or 16. Throws ref::Error for a name or number that there is not. Named configurations are
// compiled; any other is simulated with formats read at run time, several times slower and equal to the bit.
std::unique_ptr<Engine> make_engine(const Configuration& configuration, int lanes);
std::unique_ptr<Engine> make_engine(const std::string& name_or_path, int lanes);
// With formats read at run time whatever the name; `table` may differ from the one that follows from the configuration.
std::unique_ptr<Engine> make_runtime_engine(const Config& config, const FormatTable& table, int lanes);

// The named configurations, smallest first.
std::vector<ref::RasterFormat> raster_formats();
ref::RasterFormat raster_format(const std::string& name_or_path);

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_PIPELINE_ENGINE_HPP_
