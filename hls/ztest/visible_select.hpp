// SPDX-License-Identifier: Apache-2.0
// Deferred shading (dual pipeline): the attributes of a triangle wait here until the Z-test has told whether it is
// visible. Those of an invisible one go no further, but the last of the frame do, as empty. Geometry hears the same
// word, and answers a visible one with its normals.
//
// A triangle is dropped for good: its index may be given to another one, as soon as geometry has its word.
//
// Interval: a triangle a cycle.
#ifndef HALFSPACE_HLS_ZTEST_VISIBLE_SELECT_HPP_
#define HALFSPACE_HLS_ZTEST_VISIBLE_SELECT_HPP_

#include "hls/formats/records.hpp"
#include "hls/numbers/stream.hpp"

namespace halfspace {

template <class F>
bool visible_select(Stream<Attributes<F>>& attributes, Stream<Visible<F>>& tested, Stream<Visible<F>>& visible,
                    Stream<Attributes<F>>& passed) {
  Attributes<F> out = attributes.read();
  const Visible<F> result = tested.read();
  out.empty = from_raw<Bit>(!is_set(result.visible));
  visible.write(result);
  if (is_set(result.visible) || is_set(result.last)) passed.write(out);
  return is_set(result.last);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_ZTEST_VISIBLE_SELECT_HPP_
