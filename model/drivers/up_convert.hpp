// SPDX-License-Identifier: Apache-2.0
// Frame-rate up-conversion by the kernels: what ref/motion/up_convert.hpp is by the reference.
#ifndef HALFSPACE_MODEL_DRIVERS_UP_CONVERT_HPP_
#define HALFSPACE_MODEL_DRIVERS_UP_CONVERT_HPP_

#include <array>
#include <memory>
#include <optional>

#include "model/drivers/static_buffer.hpp"
#include "model/formats/configuration.hpp"
#include "model/motion/compensation.hpp"
#include "model/pipeline/engine.hpp"
#include "ref/motion/up_convert.hpp"

namespace halfspace::model {

// Numbers of motion that cost hardly any quality: docs/frames.md shows what fewer bits cost.
Config default_motion(const Config& colour, const ref::Scene* numbered = nullptr);
// The bits that number each face of the scene.
int face_bits_of(const ref::Scene& scene);

// The numbers of motion of `motion` on the triangles of `colour`: the same grid of vertices and the same depths,
// without which field and frames disagree at every edge. `width` and `height` are of the field. A vector_range of 0
// becomes one that spans the frame, a coordinate_fraction of 0, and colour_fraction, the least that is accepted. Throws
// ref::Error for numbers that are refused.
Configuration motion_configuration(const Configuration& colour, const Config& motion, int width, int height);

// What draws the key frames of a motion configuration: Gouraud shading on the same triangles.
Configuration colour_configuration(const Configuration& motion);

// What draws the triangles of a configuration that lights, come lit: Gouraud shading.
Configuration unlit_configuration(const Configuration& lit);

// What draws the frames of `colour` with textures: a memory of 65,536 texels, in perspective.
Configuration textured_configuration(const Configuration& colour, TextureFilter filter);

// Of the triangles that `between` has in a view, from each key, in frames of configuration `colour`: as it lights, or
// in the colours of triangles that come lit.
ref::OfKeys<ref::LightChange> light_changes(const ref::Scene& between, const ref::OfKeys<const ref::Scene*>& keys,
                                            const ref::View& view, const Config& colour);

struct KernelUpConversion {
  int width, height;     // of a frame; even for half a field
  Configuration colour;  // of frames as they are drawn, motion.samples times as large each way
  Configuration motion;  // of the field, on the same triangles
  ref::MotionMethod method = ref::MotionMethod::kExact;
  bool half_field = false;  // a vector for 2 × 2 pixels; of motion.samples = 1
  int lanes = 16;
  // What stands still between the keys comes from an S-buffer, and only what moves is drawn and compensated. Of exact
  // motion, a whole field, and configurations with a Z-buffer; depths compare where Scene::depth_planes is held.
  bool static_buffer = false;
  int samples = 0;  // of a pixel of a frame, each way; 0: motion.samples times key_scale
  // Pixels of a key frame for one of a frame, each way; motion.samples is of a key frame's pixel. More than the
  // samples, motion.samples 1: keys are drawn for themselves, so much larger, and words and vectors are led to them.
  int key_scale = 1;
  ref::KeyFaces key_faces = ref::KeyFaces::kTwo;
};

struct KernelFrameBetween : ref::FrameBetween {
  std::size_t triangles = 0;         // handed to the pipeline for the field
  std::size_t static_triangles = 0;  // and for the S-buffer: 0 where it showed what stands still already
  std::size_t static_instances = 0;  // that the S-buffer shows; 0: the ordinary method
  std::size_t words = 0;         // of motion: pixels of the field that show a face, and that the S-buffer does not hide
  std::size_t second_words = 0;  // of these, sent once more for the second faces of key pixels
  std::vector<std::uint32_t> hole_faces{};  // numbers of faces that have a pixel which no key shows, in rising order
  // Of both times that words are sent.
  std::array<std::size_t, 2> misses{};  // of each key's cache
  std::size_t cycles = 0;               // that hs_motion_compensate takes where nothing makes it wait
};

// Two key frames at a time, and what lies between them.
class KernelUpConverter {
 public:
  // Throws ref::Error if the two configurations do not draw the same triangles.
  explicit KernelUpConverter(const KernelUpConversion&);

  void set_keys(const ref::Scene& first, const ref::Scene& second);
  const KeyFrame& key(int k) const { return keys_[std::size_t(k)]; }
  const ref::Colours& key_colour(int k) const { return key_colours_[std::size_t(k)]; }
  // `between` is the scene at `a` of the way from the first key to the second. Throws ref::Error where ref::follow
  // does.
  KernelFrameBetween at(const ref::Scene& between, double a);
  // What its compensation was last given, for the faces that key pixels show most.
  const CompensationInput& input() const { return input_; }

 private:
  // Of the kernels, a face of the scene a pixel.
  ref::DrawnFrame drawn(ref::Geometry&);
  ref::View view(int scale) const;
  bool two_faces() const { return mode_.key_faces == ref::KeyFaces::kTwo && motion_.samples > 1; }
  // Of the instances that are not `still`, as far as the S-buffer does not hide them; of all if there are none.
  std::vector<RawMotion> field(const ref::Scene& between, double a, const std::vector<bool>& still);
  // `frame` is what the words were read from, `face` that of each of its indices.
  void drop_hidden(const ref::Scene& between, const std::vector<std::uint32_t>& face, const ref::Frame& frame,
                   std::vector<RawMotion>& words) const;
  // What the S-buffer shows, where no word is, in a picture so wide; how many pixels show an object.
  std::uint64_t show_static(const std::vector<RawMotion>& words, int width, ref::Colours& colour) const;
  // Of the colours and faces of `drawn`, in the key's format.
  KeyFrame stored(const ref::KeyFrame& drawn) const;
  // Words and vectors as keys see them that are finer than samples.
  std::vector<RawMotion> led_to_keys(std::vector<RawMotion> words) const;

  const KernelUpConversion mode_;
  const Config motion_;
  const int samples_;  // of a pixel of a frame
  const int finer_;    // pixels of a key frame for a sample; 1 unless there are more
  std::unique_ptr<Engine> colour_engine_, motion_engine_;
  Compensator compensator_;
  StaticBuffer static_buffer_;
  std::array<std::optional<ref::Scene>, 2> scenes_;
  std::array<KeyFrame, 2> keys_, second_keys_;
  std::array<ref::Colours, 2> key_colours_;
  CompensationInput input_;
  ref::SnappedList list_;  // what the field was last drawn of
};

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_DRIVERS_UP_CONVERT_HPP_
