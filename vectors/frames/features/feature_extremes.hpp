// SPDX-License-Identifier: Apache-2.0
// The numerical extremes of what a configuration has besides the base pipeline: lights, normals, textures, motion,
// objects, and the units that stand alone. They need every bit of the widths of these, for any configuration, and the
// note of a frame says which number it drives to its end. Those of the base pipeline: vectors/frames/extremes.hpp.
#ifndef HALFSPACE_VECTORS_FRAMES_FEATURES_FEATURE_EXTREMES_HPP_
#define HALFSPACE_VECTORS_FRAMES_FEATURES_FEATURE_EXTREMES_HPP_

#include <vector>

#include "model/pipeline/named_frame.hpp"
#include "vectors/frames/compensation_frames.hpp"
#include "vectors/frames/merge_frames.hpp"

namespace halfspace::model {

// Lights and the normals of vertices: vectors/frames/features/light_extremes.cpp
std::vector<NamedFrame> normal_extremes(const ref::RasterFormat&, const Config&);
std::vector<NamedFrame> light_extremes(const ref::RasterFormat&, const Config&);
std::vector<NamedFrame> material_extremes(const ref::RasterFormat&, const Config&);
// Planes of normals, of Phong shading alone: vectors/frames/features/phong_extremes.cpp
std::vector<NamedFrame> opposite_normal_extremes(const ref::RasterFormat&, const Config&);
std::vector<NamedFrame> normal_plane_extremes(const ref::RasterFormat&, const Config&);
// Textures: vectors/frames/features/texture_extremes.cpp
std::vector<NamedFrame> texel_border_extremes(const ref::RasterFormat&, const Config&);
std::vector<NamedFrame> horizon_extremes(const ref::RasterFormat&, const Config&);
std::vector<NamedFrame> repetition_extremes(const ref::RasterFormat&, const Config&);
std::vector<NamedFrame> texture_size_extremes(const ref::RasterFormat&, const Config&);
std::vector<NamedFrame> coordinate_plane_extremes(const ref::RasterFormat&, const Config&);
// Places in key frames: vectors/frames/features/motion_extremes.cpp
std::vector<NamedFrame> vector_extremes(const ref::RasterFormat&, const Config&);
// Of the set `rare`: ways that one bit alone puts out of the range of vectors.
std::vector<NamedFrame> far_ways(const ref::RasterFormat&, const Config&);
std::vector<NamedFrame> place_extremes(const ref::RasterFormat&, const Config&);
std::vector<NamedFrame> place_plane_extremes(const ref::RasterFormat&, const Config&);
// Numbers of objects: vectors/frames/features/objects_extremes.cpp
std::vector<NamedFrame> object_extremes(const ref::RasterFormat&, const Config&);

struct FeatureExtremeClass {
  const char* name;
  bool (*is_there)(const Config&);
  std::vector<NamedFrame> (*frames)(const ref::RasterFormat&, const Config&);
};
const std::vector<FeatureExtremeClass>& feature_extreme_classes();

// Of a class, each frame with what the configuration has besides: white light, no texture, objects in turn.
std::vector<NamedFrame> frames_of(const FeatureExtremeClass&, const ref::RasterFormat&, const Config&);
// Of all classes that the configuration has.
std::vector<NamedFrame> feature_extremes(const ref::RasterFormat&, const Config&);

// Of motion_compensate and of ztest_merge: vectors/frames/features/compensation_extremes.cpp, objects_extremes.cpp
std::vector<NamedCompensation> compensation_extremes(const Config&);
std::vector<NamedMerge> merge_extremes(const Config&);
// A whole buffer of one object, which a set of files has no room for where frames are large.
NamedMerge largest_merge(const Config&);

}  // namespace halfspace::model

#endif  // HALFSPACE_VECTORS_FRAMES_FEATURES_FEATURE_EXTREMES_HPP_
