// SPDX-License-Identifier: Apache-2.0
// Which unit stands in a place of the composition. A configuration that has no use for a unit need not compile it, as
// refusal() does not hold its words; one that is read at run time compiles all and asks.
#ifndef HALFSPACE_HLS_PIPELINE_CHOOSE_HPP_
#define HALFSPACE_HLS_PIPELINE_CHOOSE_HPP_

#include <type_traits>

namespace halfspace {

// first(s, b) or, unless it is there, other(s, b), of streams and buffers. Both are generic lambdas, so that what is
// not called is not compiled.
template <class S, class B, class First, class Other>
void choose(std::true_type, bool is_there, S& s, B& b, First first, Other other) {
  if (is_there) first(s, b);
  else other(s, b);
}
template <class S, class B, class First, class Other>
void choose(std::false_type, bool, S& s, B& b, First, Other other) {
  other(s, b);
}

// unit(s, b), if it is there.
template <class S, class B, class Unit>
void when(std::true_type, bool is_there, S& s, B& b, Unit unit) {
  if (is_there) unit(s, b);
}
template <class S, class B, class Unit>
void when(std::false_type, bool, S&, B&, Unit) {}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_PIPELINE_CHOOSE_HPP_
