// SPDX-License-Identifier: Apache-2.0
// The co-simulation of hs_up_convert: the triangles of all passes of a film in, every stream held against the vectors.
#ifndef HALFSPACE_TB_FILM_FILM_HPP_
#define HALFSPACE_TB_FILM_FILM_HPP_

#include "tb/harness/bench.hpp"

namespace halfspace::tb {

// Passes follow each other at once; before one that loads other words than there are the design runs empty (busy_o).
Result run_film(Model* model, const Vectors& vectors, const Options& options);

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_FILM_FILM_HPP_
