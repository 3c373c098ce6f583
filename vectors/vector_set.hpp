// SPDX-License-Identifier: Apache-2.0
// Vector sets: a folder with a text file a stream, for $readmemh, and manifest.json (see docs/vectors.md).
#ifndef HALFSPACE_VECTORS_VECTOR_SET_HPP_
#define HALFSPACE_VECTORS_VECTOR_SET_HPP_

#include <functional>
#include <string>
#include <vector>

#include "model/formats/configuration.hpp"
#include "model/pipeline/film_engine.hpp"
#include "model/pipeline/named_frame.hpp"
#include "vectors/frames/compensation_frames.hpp"
#include "vectors/frames/merge_frames.hpp"
#include "vectors/frames/static_sequence.hpp"

namespace halfspace::model {

struct VectorSetOptions {
  std::string scene;  // name in the manifest
  Configuration configuration = find_configuration("middle");
  int lanes = 4;
  std::uint64_t seed = 0;  // of the random frames; 0 if there are none
  int window = 0;          // of index reuse
  bool ports = false;      // the streams at the ports of hs_pipeline alone, and scan, which its frames end by
};

// Writes the streams of the frames to `folder`, which is made. The files appear there together, at the end, or not
// at all; `progress` hears (frames done, frames). Returns the manifest's text. Throws ref::Error.
std::string write_vector_set(const std::string& folder, const VectorSetOptions& options,
                             const std::vector<NamedFrame>& frames,
                             const std::function<void(std::size_t, std::size_t)>& progress);

// Those of motion_compensate alone, likewise; and of ztest_merge, a run a frame.
std::string write_compensation_set(const std::string& folder, const VectorSetOptions& options,
                                   const std::vector<NamedCompensation>& frames,
                                   const std::function<void(std::size_t, std::size_t)>& progress);
// Frames of a configuration with motion, and what motion_compensate makes of each in the order of scan, from key frames
// of `options.seed`: the streams of both.
std::string write_between_set(const std::string& folder, const VectorSetOptions& options,
                              const std::vector<NamedFrame>& frames,
                              const std::function<void(std::size_t, std::size_t)>& progress);
// The passes of a film, from its first key frame on, one a frame of the set.
std::string write_film_set(const std::string& folder, const VectorSetOptions& options,
                           const std::vector<FilmPass>& passes,
                           const std::function<void(std::size_t, std::size_t)>& progress);
std::string write_merge_set(const std::string& folder, const VectorSetOptions& options,
                            const std::vector<NamedMerge>& runs,
                            const std::function<void(std::size_t, std::size_t)>& progress);
// Those of hs_static_frames: of its passes and of its commands, frame by frame. Throws ref::Error if a frame that the
// commands show is not that of the sequence. The manifest tells the cycles of each by the model.
std::string write_static_set(const std::string& folder, const VectorSetOptions& options,
                             const std::vector<StaticSequenceFrame>& frames,
                             const std::function<void(std::size_t, std::size_t)>& progress);

}  // namespace halfspace::model

#endif  // HALFSPACE_VECTORS_VECTOR_SET_HPP_
