// SPDX-License-Identifier: Apache-2.0
// Frames of normals for the lighting kernels: as integers, from a scene or made to be awkward, and the kernels that
// light them.
#ifndef HALFSPACE_MODEL_SHADE_LIGHTING_HPP_
#define HALFSPACE_MODEL_SHADE_LIGHTING_HPP_

#include <array>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "hls/formats/formats.hpp"
#include "model/formats/configuration.hpp"
#include "model/formats/layout.hpp"

// So that whoever takes frames alone does not see how scenes are read.
namespace halfspace::ref {
struct DistantScene;
}

namespace halfspace::model {

// The raw bits of the records of the same names.
struct RawLight {
  std::array<int, 3> to_light, half;
};
struct RawReflection {  // an entry of the table of materials
  std::array<int, 3> base, diffuse, specular;
};
struct RawMaterial {
  int gloss = 0;
  std::vector<RawReflection> reflections;  // a light each
};
struct RawNormals {
  int index = 1, material = 0;
  std::array<std::array<int, 3>, 3> normals{};  // [vertex][component]
};

struct LightingFrame {
  std::string note;
  std::vector<RawLight> lights;  // as many as the configuration has, as have all materials
  std::vector<RawMaterial> materials;
  std::vector<RawNormals> triangles;
};

// log2 of the largest exponent of a configuration; −1 without highlights.
int most_squarings(const Config& config);

// Throws ref::Error where the scene has more lights or materials than the configuration. Coefficients beyond four times
// full scale are those four times.
LightingFrame quantized_lighting(const ref::DistantScene& scene, const Config& config);

// To the nearest that the configuration has.
std::array<int, 3> quantized_normal(const glm::dvec3& normal, const Config& config);

// Annotated corner cases, then random frames.
std::vector<LightingFrame> lighting_frames(const Config& config, std::uint64_t seed);

// The kernels of light_vertex.
class LightingEngine {
 public:
  virtual ~LightingEngine() = default;

  // The words of each stream of a frame: light, material, normals, colours.
  virtual void capture(const LightingFrame& frame,
                       const std::function<void(const Layout&, const Word*, std::size_t count)>& sink) = 0;
  // [triangle][vertex][channel] before rounding, as raw bits of light_sum; of a flat triangle, vertex 0 alone.
  virtual std::vector<std::array<std::array<std::uint64_t, 3>, 3>> sums(const LightingFrame& frame) = 0;
  // The colours that leave the unit.
  virtual std::vector<std::array<std::array<int, 3>, 3>> colours(const LightingFrame& frame) = 0;
};

// Null for a configuration without lighting. `table` may differ from the one that follows from the configuration.
std::unique_ptr<LightingEngine> make_lighting_engine(const Config& config);
std::unique_ptr<LightingEngine> make_lighting_engine(const Config& config, const FormatTable& table);

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_SHADE_LIGHTING_HPP_
