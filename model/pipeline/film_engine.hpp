// SPDX-License-Identifier: Apache-2.0
// The kernels of a film: a pass of triangles after the other, and the frames that come of them.
#ifndef HALFSPACE_MODEL_PIPELINE_FILM_ENGINE_HPP_
#define HALFSPACE_MODEL_PIPELINE_FILM_ENGINE_HPP_

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "hls/formats/film_records.hpp"
#include "model/formats/layout.hpp"
#include "model/pipeline/named_frame.hpp"

namespace halfspace::model {

// A frame of triangles of a film. Key frames are numbered from 0 on, and the fields between two of them from 1 on; a
// film goes key 0, key 1, fields of these, key 2, fields of keys 1 and 2, and so on.
struct FilmPass {
  Pass pass = Pass::kKey;
  int key = 0;                       // its number; of a frame in between, that of the key before it
  int field = 0;                     // of a frame in between; 0 of a key
  NamedFrame frame;                  // with what its triangles need in that pass
  std::vector<std::uint32_t> faces;  // of its triangles, as key pixels have them
};

// What came of a pass.
struct FilmDrawn {
  std::vector<std::uint32_t> asked;  // faces that have holes; some may come twice. None: there is nothing to fill
  std::size_t answers = 0;           // triangles that were visible, so that geometry answered
  std::size_t words = 0;             // of motion: pixels in between that show a face
  std::size_t holes = 0;             // of those, that no key shows
  std::size_t filled = 0;            // pixels that were shaded for holes
  // Frames of the film that came out, in their order, RGBA row by row.
  std::vector<std::vector<std::array<std::uint8_t, 4>>> shown;
};

class FilmEngine {
 public:
  virtual ~FilmEngine() = default;

  virtual int lanes_x() const = 0;
  virtual int lanes_y() const = 0;
  // Of the streams of the pipeline and of those behind it, each once.
  virtual std::vector<Layout> layouts() const = 0;
  // The next pass. Throws ref::Error for one that does not come next, or that the configuration cannot draw. `sink`,
  // unless it is empty, is told the words of each stream once.
  virtual FilmDrawn run(const FilmPass& pass, const WordSink& sink = {}) = 0;
};

// Throws ref::Error for a configuration without frames_between. A film begins with it.
std::unique_ptr<FilmEngine> make_film_engine(const Configuration& configuration, int lanes);

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_PIPELINE_FILM_ENGINE_HPP_
