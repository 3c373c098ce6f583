// SPDX-License-Identifier: Apache-2.0
// A frame as an engine draws it: its triangles, and what goes with them.
#ifndef HALFSPACE_MODEL_PIPELINE_NAMED_FRAME_HPP_
#define HALFSPACE_MODEL_PIPELINE_NAMED_FRAME_HPP_

#include <cstdint>
#include <string>
#include <vector>

#include "model/formats/configuration.hpp"
#include "model/motion/motion.hpp"
#include "model/shade/lighting.hpp"
#include "model/texture/texture.hpp"
#include "ref/geometry/snap.hpp"

namespace halfspace::model {

class Engine;

struct NamedFrame {
  std::string note;  // what the frame is for
  ref::SnappedList scene;
  LightingFrame lighting = {};  // with lighting: the normals of its triangles, and what they are lit with
  TextureFrame texture = {};    // with texture: their coordinates, and the textures
  MotionFrame motion = {};      // of a motion configuration: where they are in the key frames
  std::vector<std::uint32_t> objects =
      {};  // of one with objects: theirs; if there are none, four triangles make an object
};

// Gives the engine what goes with the triangles of a frame, before it is drawn.
void load_frame(Engine&, const Config&, const NamedFrame&);

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_PIPELINE_NAMED_FRAME_HPP_
