// SPDX-License-Identifier: Apache-2.0
// What a unit of a film finds in memories that the passes before it left: key frames, the film buffer, marks of holes.
#ifndef HALFSPACE_TB_FILM_KEPT_HPP_
#define HALFSPACE_TB_FILM_KEPT_HPP_

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tb/harness/memory.hpp"
#include "tb/harness/model.hpp"
#include "tb/harness/vectors.hpp"

namespace halfspace::tb {

class Kept {
 public:
  Kept() = default;
  // Those that the unit has.
  Kept(Memory* marks, Memory* keys, Memory* film) : marks_(marks), keys_(keys), film_(film) {}

  // Before a pass: of hole_scan the marks that the pass before it set, of film_scan the pixels of the pass itself. The
  // first time, which may be before any pass, they are what all before it left; from then on what a unit clears is left
  // to it.
  void prepare(const Model& model, const Vectors& vectors, std::size_t frame);
  // The words of show for what comes out behind a pass.
  std::vector<std::uint32_t> shows(const Vectors& vectors, std::size_t frame) const;

 private:
  // The pixels of a pass.
  void store(const Model& model, const Vectors& vectors, std::size_t frame) const;

  Memory *marks_ = nullptr, *keys_ = nullptr, *film_ = nullptr;
  bool begun_ = false;
};

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_FILM_KEPT_HPP_
