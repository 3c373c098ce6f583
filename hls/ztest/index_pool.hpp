// SPDX-License-Identifier: Apache-2.0
// Indices of triangles, given in hardware (index rendering): triangle n of a frame takes the index of triangle n − W if
// that turned out invisible, else the next new one; W is F::kIndexWindow. So no list of free indices is kept, a result
// may take W triangles to arrive, and as many indices are used as triangles are visible, and W more at most.
//
// From triangle W on, each waits for the result of the one W before it, whatever frame that is of, so that W triangles
// at most are between here and the Z-test. A result of a frame before gives no index: a frame begins with 1.
//
// When there is no index, as F::kTriangles are in use, the triangle goes on with index 0 and all its vertices in row 0,
// where its box holds no pixel centre: it is drawn nowhere, and its word of `visible` says so by that index. Later ones
// may find an index again.
//
// Interval: a triangle a cycle.
#ifndef HALFSPACE_HLS_ZTEST_INDEX_POOL_HPP_
#define HALFSPACE_HLS_ZTEST_INDEX_POOL_HPP_

#include "hls/formats/buffers.hpp"
#include "hls/numbers/arithmetic.hpp"

namespace halfspace {

// `returned`: the words of `visible`, in the order of the triangles.
template <class F>
bool index_pool(Stream<UnnumberedTriangle<F>>& unnumbered, Stream<Visible<F>>& returned, PoolRegisters<F>& pool,
                Stream<Triangle<F>>& numbered) {
  using Index = typename F::Index;
  using Flight = typename F::Flight;
  Triangle<F> out = unnumbered.read();
  const Flight stale = pool.stale;
  Index again = from_raw<Index>(0);
  if (pool.in_flight < from_raw<Flight>(F::kIndexWindow)) {
    pool.in_flight = pool.in_flight + from_raw<Flight>(1);
  } else {
    const Visible<F> before = returned.read();
    if (is_zero(stale) && !is_set(before.visible)) again = before.index;
    if (!is_zero(stale)) pool.stale = stale - from_raw<Flight>(1);
  }
  out.index = again;
  if (is_zero(again) && pool.used < from_raw<Index>(F::kTriangles)) {
    out.index = pool.used + from_raw<Index>(1);
    pool.used = out.index;
  }
  const bool drawn = !is_zero(out.index);
Vertices:
  for (int i = 0; i < 3; ++i) {
    HS_UNROLL
    out.y[i] = select(drawn, out.y[i], typename F::Coord());
  }
  if (is_set(out.last)) {
    pool.used = from_raw<Index>(0);
    pool.stale = pool.in_flight;
  }
  numbered.write(out);
  return is_set(out.last);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_ZTEST_INDEX_POOL_HPP_
