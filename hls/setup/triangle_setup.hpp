// SPDX-License-Identifier: Apache-2.0
// Triangle setup: edge functions, bounding box, the reciprocal of the area and the plane of depth (dual pipeline).
// Without a plane there is no reciprocal.
//
// The vertices are put in one order: vertex 0 is the topmost, of these the leftmost; 1 and 2 follow clockwise on the
// screen, D > 0. All six orders of three vertices therefore give the same bits. With that order
//
//   E_i(p) = dx_i·(p.y − y_i) − dy_i·(p.x − x_i) > 0 inside, (dx_i, dy_i) the edge from vertex i to the next,
//
// and an edge includes its own points iff dy < 0, or dy = 0 and dx > 0 (top-left rule): else 1 is taken off.
//
// A configuration may cull: a triangle that is seen from behind, or one that is seen from the front, is dropped as if D
// were 0. Which of both it is, is whether its vertices had to be swapped for that order.
//
// Interval of the RTL: setup_interval() cycles a triangle, 21 in low, 29 in middle, 31 in high; 3 if its box holds no
// pixel centre, 7 if D is 0 or it is culled.
#ifndef HALFSPACE_HLS_SETUP_TRIANGLE_SETUP_HPP_
#define HALFSPACE_HLS_SETUP_TRIANGLE_SETUP_HPP_

#include "hls/setup/plane.hpp"

namespace halfspace {

// The order above, of a triangle and of the edges that leave its vertex 0.
template <class F>
struct OrderedTriangle {
  Triangle<F> vertices;
  typename F::Delta dx1, dy1, dx2, dy2;
  typename F::Area area;  // D
  VertexNumber first;     // which of those given vertex 0 is
  Bit turned;             // and whether the others follow it backwards
};

// What the three vertices have, from vertex `first` on.
template <class T>
struct Rotated {
  T of[3];
};
template <class T>
Rotated<T> rotated(int first, const T (&v)[3]) {
  Rotated<T> r;
  r.of[0] = select(first == 2, v[2], select(first == 1, v[1], v[0]));
  r.of[1] = select(first == 2, v[0], select(first == 1, v[2], v[1]));
  r.of[2] = select(first == 2, v[1], select(first == 1, v[0], v[2]));
  return r;
}
template <class T>
void order_values(const Rotated<T>& v, bool swap, T (&ordered)[3]) {
  ordered[0] = v.of[0];
  ordered[1] = select(swap, v.of[2], v.of[1]);
  ordered[2] = select(swap, v.of[1], v.of[2]);
}

template <class F>
OrderedTriangle<F> order_vertices(const Triangle<F>& in) {
  const bool above_1 = in.y[1] < in.y[0] || (in.y[1] == in.y[0] && in.x[1] < in.x[0]);
  using Coord = typename F::Coord;
  const Coord best_x = select(above_1, in.x[1], in.x[0]), best_y = select(above_1, in.y[1], in.y[0]);
  const bool above_2 = in.y[2] < best_y || (in.y[2] == best_y && in.x[2] < best_x);
  const int first = above_2 ? 2 : above_1 ? 1 : 0;

  const Rotated<Coord> x = rotated(first, in.x), y = rotated(first, in.y);
  const typename F::Delta dxa = x.of[1] - x.of[0], dya = y.of[1] - y.of[0];
  const typename F::Delta dxb = x.of[2] - x.of[0], dyb = y.of[2] - y.of[0];
  const typename F::SignedArea cross = dxa * dyb - dya * dxb;
  const bool swap = is_negative(cross);

  OrderedTriangle<F> out;
  out.vertices.last = in.last;
  out.vertices.index = in.index;
  out.first = from_raw<VertexNumber>(first);
  out.turned = from_raw<Bit>(swap);
  order_values(x, swap, out.vertices.x);
  order_values(y, swap, out.vertices.y);
  if (F::kHasDepth) order_values(rotated(first, in.depth), swap, out.vertices.depth);
  if (!F::kHasLighting) {
    // Flat: of the vertex that came first.
    const int from = F::kGouraud ? first : 0;
    order_values(rotated(from, in.r), swap, out.vertices.r);
    order_values(rotated(from, in.g), swap, out.vertices.g);
    order_values(rotated(from, in.b), swap, out.vertices.b);
  }
  out.dx1 = select(swap, dxb, dxa);
  out.dy1 = select(swap, dyb, dya);
  out.dx2 = select(swap, dxa, dxb);
  out.dy2 = select(swap, dya, dyb);
  out.area = magnitude(cross);
  return out;
}

// A whole pixel of a position, or the one beyond.
template <class F>
using PixelNumber = Whole<Wider<typename F::Coord, 1>>;

// The pixels whose centres lie in [min, max], cut to 0 … size − 1: first > last if there are none.
template <class F>
struct PixelRange {
  PixelNumber<F> first, last;
};
template <class F>
PixelRange<F> pixel_range(const typename F::Coord& a, const typename F::Coord& b, const typename F::Coord& c,
                          const PixelNumber<F>& size) {
  using Coord = typename F::Coord;
  const Coord half = half_pixel<F>();
  const Coord low_ab = select(a < b, a, b), high_ab = select(a < b, b, a);
  const Coord low = select(low_ab < c, low_ab, c);
  const Coord high = select(high_ab < c, c, high_ab);
  const PixelNumber<F> first = low + Coord(half - from_raw<Coord>(1));  // ceil(low − ½)
  const PixelNumber<F> last = high - half;                              // floor(high − ½)
  PixelRange<F> range;
  range.first = select(is_negative(first), PixelNumber<F>(), first);
  range.last = select(last < size, last, PixelNumber<F>(size - from_raw<PixelNumber<F>>(1)));
  return range;
}

// The edge function from (x, y) along (dx, dy) at p, tie rule and dropped bits included.
template <class F>
typename F::EdgeStep edge_start(const typename F::Coord& x, const typename F::Coord& y, const typename F::Delta& dx,
                                const typename F::Delta& dy, const typename F::Coord& px, const typename F::Coord& py) {
  const typename F::Delta along_x = px - x;
  const typename F::Delta along_y = py - y;
  const typename F::Edge cross = dx * along_y - dy * along_x;
  const bool inclusive = is_negative(dy) || (is_zero(dy) && dx > typename F::Delta());
  const typename F::Edge biased = cross - from_raw<typename F::Edge>(inclusive ? 0 : 1);
  return biased;
}

template <class F>
bool triangle_setup(const Frame<F>& frame, Stream<Triangle<F>>& triangle, Stream<Setup<F>>& setup,
                    Stream<Attributes<F>>& attributes) {
  using Coord = typename F::Coord;
  const OrderedTriangle<F> t = order_vertices<F>(triangle.read());
  const Coord* x = t.vertices.x;
  const Coord* y = t.vertices.y;

  const PixelRange<F> columns = pixel_range<F>(x[0], x[1], x[2], frame.width);
  const PixelRange<F> rows = pixel_range<F>(y[0], y[1], y[2], frame.height);
  // Counter-clockwise as they came, with D < 0, is the front.
  const bool culled = is_set(t.turned) ? F::kCullsFront : F::kCullsBack;
  const bool empty = is_zero(t.area) || culled || columns.first > columns.last || rows.first > rows.last;

  Setup<F> out{};
  out.last = t.vertices.last;
  out.empty = from_raw<Bit>(empty);
  out.index = t.vertices.index;
  Attributes<F> shade{};
  shade.last = out.last;
  shade.empty = out.empty;
  shade.index = out.index;

  if (!empty) {
    // Below the topmost vertex, the triangle's first row is nearest to it.
    const PixelNumber<F> top = x[0];
    const PixelNumber<F> start =
        select(top < columns.first, columns.first, select(top > columns.last, columns.last, top));
    const PixelNumber<F> x_start = shift_right(start, F::kLog2LanesX),
                         y_start = shift_right(rows.first, F::kLog2LanesY);
    out.x_min = shift_right(columns.first, F::kLog2LanesX);
    out.x_max = shift_right(columns.last, F::kLog2LanesX);
    out.x_start = x_start;
    out.y_min = y_start;
    out.y_max = shift_right(rows.last, F::kLog2LanesY);

    const Coord px = Coord(shift_left(x_start, F::kLog2LanesX)) + half_pixel<F>();
    const Coord py = Coord(shift_left(y_start, F::kLog2LanesY)) + half_pixel<F>();

    Coord xs[3] = {x[0], x[1], x[2]}, ys[3] = {y[0], y[1], y[2]};
  EdgeTurns:
    HS_IN_TURN for (int i = 0; i < 3; ++i) {
      HS_PIPELINE(1)
      const typename F::Delta dx = xs[1] - xs[0], dy = ys[1] - ys[0];
      move_up<typename F::EdgeStep>(out.e, edge_start<F>(xs[0], ys[0], dx, dy, px, py));
      move_up<typename F::Delta>(out.e_dx, -dy);
      move_up(out.e_dy, dx);
      move_up(xs, xs[0]);
      move_up(ys, ys[0]);
    }

    AreaReciprocal<F> inverse{};
    if (F::kHasPlanes) inverse = area_reciprocal<F>(t.area);
    if (F::kHasDepth) {
      PlaneBase<F> base;
      base.dx1 = t.dx1;
      base.dy1 = t.dy1;
      base.dx2 = t.dx2;
      base.dy2 = t.dy2;
      base.inverse = inverse;
      base.dx = px - x[0];
      base.dy = py - y[0];
      const auto depth =
          plane_setup<F, typename F::DepthChannel>(base, t.vertices.depth[0], t.vertices.depth[1], t.vertices.depth[2]);
      out.depth = depth.start;
      out.depth_dx = depth.dx;
      out.depth_dy = depth.dy;
    }
    if (F::kSendsShape) {
      shade.x = x[0];
      shade.y = y[0];
      shade.dx1 = t.dx1;
      shade.dy1 = t.dy1;
      shade.dx2 = t.dx2;
      shade.dy2 = t.dy2;
      shade.shift = inverse.shift;
      shade.reciprocal = inverse.reciprocal;
    }
    if (F::kOrdersVertices) {
      shade.first = t.first;
      shade.turned = t.turned;
    }
  Colours:
    for (int i = 0; i < 3 && !F::kHasLighting; ++i) {
      HS_UNROLL
      shade.r[i] = t.vertices.r[i];
      shade.g[i] = t.vertices.g[i];
      shade.b[i] = t.vertices.b[i];
    }
  }
  setup.write(out);
  if (!empty || is_set(out.last) || F::kDeferred) attributes.write(shade);
  return is_set(out.last);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_SETUP_TRIANGLE_SETUP_HPP_
