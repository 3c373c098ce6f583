// SPDX-License-Identifier: Apache-2.0
// The stream `between` of the RTL, which no vector set has: what hole_find sends to the film buffer and to the marks of
// holes follows from its two inputs, word for word.
#ifndef HALFSPACE_TB_FILM_BETWEEN_HPP_
#define HALFSPACE_TB_FILM_BETWEEN_HPP_

#include "tb/harness/vectors.hpp"

namespace halfspace::tb {

// Adds it, without words, to a film.
void add_between(Vectors* vectors);
// Its words, where those of `ordered` and `compensated` are loaded.
void fill_between(Vectors* vectors);

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_FILM_BETWEEN_HPP_
