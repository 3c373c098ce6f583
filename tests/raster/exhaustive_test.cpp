// SPDX-License-Identifier: Apache-2.0
// Every triangle of a micro configuration, through triangle_setup, shade_setup and raster_pineda, against integers;
// every edge and pixel centre of one, for the tie rule. UBSan watches the kernels.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "hls/raster/raster_pineda.hpp"
#include "hls/setup/shade_setup.hpp"
#include "hls/setup/triangle_setup.hpp"
#include "tests/raster/exact_triangle.hpp"

namespace halfspace::tests {
namespace {

// Fields of a record, one number after another.
struct Digest {
  std::uint64_t sum = 1469598103934665603u;
  template <class T>
  void operator()(const char*, const T& field) {
    sum = (sum ^ std::uint64_t(raw(field))) * 1099511628211u;
  }
};

template <class S>
class Triangles {
 public:
  using F = Formats<Micro, S>;

  Triangles(int width, int height) : width_(width), height_(height) {
    frame_.width = from_raw<typename F::X>(width);
    frame_.height = from_raw<typename F::Y>(height);
    visits_.tap(&visits);
  }

  // The places a <= b <= c: in all orders, and once through the rest. Returns "" or what is wrong.
  const char* run(int a, int b, int c) {
    const Exact t({a, b, c});
    std::array<int, 3> order{a, b, c};
    const std::uint64_t first = set_up(order);
    const Setup<F> setup = setup_;
    const bool has_attributes = has_attributes_;
    if (const char* wrong = check_setup(t)) return wrong;
    if (const char* wrong = check_walk(t)) return wrong;
    while (std::next_permutation(order.begin(), order.end())) {
      if (set_up(order) != first || has_attributes_ != has_attributes) return "another order of the vertices";
    }
    setup_ = setup;
    return nullptr;
  }

  std::int64_t covered = 0, walked = 0, empty = 0;
  std::vector<int> visits;

 private:
  std::uint64_t set_up(const std::array<int, 3>& v) {
    Triangle<F> in{};
    for (int i = 0; i < 3; ++i) {
      in.x[i] = from_raw<typename F::Coord>(place(v[i]).x);
      in.y[i] = from_raw<typename F::Coord>(place(v[i]).y);
      in.depth[i] = from_raw<typename F::Depth>(depth_at(v[i]));
      in.r[i] = from_raw<typename F::Colour>(colour_at(v[i], 0));
      in.g[i] = from_raw<typename F::Colour>(colour_at(v[i], 1));
      in.b[i] = from_raw<typename F::Colour>(colour_at(v[i], 2));
    }
    in.index = from_raw<typename F::Index>(3);
    in.last = from_raw<Bit>(v[0] & 1 & v[1] & v[2]);
    triangle.write(in);
    returned_ = triangle_setup(frame_, triangle, setup, attributes);
    setup_ = setup.read();
    Digest digest;
    setup_.visit(digest);
    has_attributes_ = !attributes.empty();
    if (has_attributes_) {
      attributes_ = attributes.read();
      attributes_.visit(digest);
    }
    return digest.sum;
  }

  // The pixels of a row, or column, of the frame that a triangle can have.
  static std::array<int, 2> range(int a, int b, int c, int size) {
    const int low = std::min({a, b, c}), high = std::max({a, b, c});
    int first = 0, last = size - 1;
    while (first < size && 2 * first + 1 < low) ++first;
    while (last >= 0 && 2 * last + 1 > high) --last;
    return {first, last};
  }

  const char* check_setup(const Exact& t) {
    const auto columns = range(t.at[0].x, t.at[1].x, t.at[2].x, width_);
    const auto rows = range(t.at[0].y, t.at[1].y, t.at[2].y, height_);
    const bool is_empty = t.area == 0 || columns[0] > columns[1] || rows[0] > rows[1];
    const bool last = t.vertex[0] & 1 & t.vertex[1] & t.vertex[2];
    empty += is_empty;
    if (is_set(setup_.empty) != is_empty) return "setup.empty";
    if (is_set(setup_.last) != last || returned_ != last || raw(setup_.index) != 3) return "setup.last, index";
    if (has_attributes_ != (!is_empty || last)) return "attributes of an empty triangle";
    if (has_attributes_ && (is_set(attributes_.last) != last || is_set(attributes_.empty) != is_empty))
      return "attributes.last, empty";
    if (is_empty) return nullptr;
    const int top = (t.at[0].x - (t.at[0].x & 1)) / 2;
    x_start_ = std::max(columns[0], std::min(columns[1], top)) / S::kX;
    x_min_ = columns[0] / S::kX, x_max_ = columns[1] / S::kX;
    y_min_ = rows[0] / S::kY, y_max_ = rows[1] / S::kY;
    if (int(raw(setup_.x_start)) != x_start_ || int(raw(setup_.x_min)) != x_min_ || int(raw(setup_.x_max)) != x_max_)
      return "setup.x_start, x_min, x_max";
    if (int(raw(setup_.y_min)) != y_min_ || int(raw(setup_.y_max)) != y_max_) return "setup.y_min, y_max";
    const Place from = centre(x_start_ * S::kX, y_min_ * S::kY);
    for (int i = 0; i < 3; ++i) {
      const Place a = t.at[i], b = t.at[(i + 1) % 3];
      if (int(raw(setup_.e[i])) != t.edge(i, from) >> kConfig.subpixel_bits) return "setup.e";
      if (int(raw(setup_.e_dx[i])) != a.y - b.y || int(raw(setup_.e_dy[i])) != b.x - a.x) return "setup.e_dx, e_dy";
    }
    depth_ =
        t.plane({depth_at(t.vertex[0]), depth_at(t.vertex[1]), depth_at(t.vertex[2])}, from, kConfig.depth_fraction);
    const int bits = kConfig.depth_bits + kConfig.depth_fraction;
    if (modulo(raw(setup_.depth), bits) != modulo(depth_.start, bits)) return "setup.depth";
    if (modulo(raw(setup_.depth_dx), bits) != modulo(depth_.dx, bits)) return "setup.depth_dx";
    if (modulo(raw(setup_.depth_dy), bits) != modulo(depth_.dy, bits)) return "setup.depth_dy";
    return check_colours(t);
  }

  const char* check_colours(const Exact& t) {
    attributes.write(attributes_);
    shade_setup(attributes, planes);
    const Planes<F> p = planes.read();
    const std::int64_t got[3][3] = {{std::int64_t(raw(p.r)), std::int64_t(raw(p.r_dx)), std::int64_t(raw(p.r_dy))},
                                    {std::int64_t(raw(p.g)), std::int64_t(raw(p.g_dx)), std::int64_t(raw(p.g_dy))},
                                    {std::int64_t(raw(p.b)), std::int64_t(raw(p.b_dx)), std::int64_t(raw(p.b_dy))}};
    const int bits = kConfig.colour_bits + kConfig.colour_fraction;
    for (int c = 0; c < 3; ++c) {
      const PlaneNumbers want =
          t.plane({colour_at(t.vertex[0], c), colour_at(t.vertex[1], c), colour_at(t.vertex[2], c)}, centre(0, 0),
                  kConfig.colour_fraction);
      if (modulo(got[c][0], bits) != modulo(want.start, bits) || modulo(got[c][1], bits) != modulo(want.dx, bits) ||
          modulo(got[c][2], bits) != modulo(want.dy, bits))
        return "planes of a colour";
    }
    return nullptr;
  }

  // A stamp is near when each edge function is not negative at one of its pixels at least.
  bool near(const Exact& t, int x, int y) const {
    for (int i = 0; i < 3; ++i) {
      bool any = false;
      for (int l = 0; l < F::kLanes; ++l)
        any = any || t.edge(i, centre(x * S::kX + l % S::kX, y * S::kY + l / S::kX)) >= 0;
      if (!any) return false;
    }
    return true;
  }
  // Whether all edges that keep a stamp from being near rise to the right, or to the left, if `step` is -1.
  bool all_rise(const Exact& t, int x, int y, int step) const {
    for (int i = 0; i < 3; ++i) {
      bool any = false;
      for (int l = 0; l < F::kLanes; ++l)
        any = any || t.edge(i, centre(x * S::kX + l % S::kX, y * S::kY + l / S::kX)) >= 0;
      if (!any && (t.at[i].y - t.at[(i + 1) % 3].y) * step <= 0) return false;
    }
    return true;
  }

  // The walk as raster_pineda.hpp has it in words: the stamps in order. A row of near ones is searched for from where
  // the row above says, taken to its right end, then from where it began to its left end.
  void walk(const Exact& t) {
    path_.clear();
    int x = x_start_;
    for (int y = y_min_; y <= y_max_; ++y) {
      int way = 0;
      path_.push_back({x, y});
      while (!near(t, x, y)) {
        if (way >= 0 && x < x_max_ && all_rise(t, x, y, 1)) way = 1;
        else if (way <= 0 && x > x_min_ && all_rise(t, x, y, -1)) way = -1;
        else break;
        path_.push_back({x += way, y});
      }
      int next = -1;
      const auto take = [&](int at) {
        if (next < 0 && near(t, at, y + 1)) next = at;
        x = at;
      };
      if (near(t, x, y)) {
        const int begin = x;
        take(begin);
        for (int at = begin + 1; at <= x_max_ && near(t, at, y); ++at) path_.push_back({at, y}), take(at);
        for (int at = begin - 1; at >= x_min_ && near(t, at, y); --at) path_.push_back({at, y}), take(at);
      }
      if (next >= 0) x = next;
    }
  }

  const char* check_walk(const Exact& t) {
    const bool last = is_set(setup_.last);
    visits.clear();
    setup.write(setup_);
    if (raster_pineda(frame_, setup, stamp, triangle_depth, visits_) != last) return "raster_pineda returns";
    path_.clear();
    if (!is_set(setup_.empty)) walk(t);
    if (visits.size() != 1 || visits[0] != int(path_.size())) return "visits";
    walked += visits[0];
    const int bits = kConfig.depth_bits + kConfig.depth_fraction;
    Stamp<F> got{};
    bool any_sent = false;
    for (const Place& at : path_) {
      bool mask[F::kLanes], any = false;
      for (int l = 0; l < F::kLanes; ++l) {
        const int x = at.x * S::kX + l % S::kX, y = at.y * S::kY + l / S::kX;
        const Place p = centre(x, y);
        mask[l] = x < width_ && y < height_ && t.edge(0, p) >= 0 && t.edge(1, p) >= 0 && t.edge(2, p) >= 0;
        any = any || mask[l];
      }
      if (!any) continue;
      if (stamp.empty()) return "a stamp lacks";
      got = stamp.read();
      any_sent = true;
      if (int(raw(got.x)) != at.x || int(raw(got.y)) != at.y || raw(got.index) != 3) return "stamp.x, y, index";
      if (is_set(got.triangle_last) != stamp.empty() || is_set(got.last) != (stamp.empty() && last))
        return "stamp.last";
      for (int l = 0; l < F::kLanes; ++l) {
        covered += mask[l];
        if (is_set(got.mask[l]) != mask[l]) return "stamp.mask";
        const int x = at.x * S::kX + l % S::kX - x_start_ * S::kX, y = at.y * S::kY + l / S::kX - y_min_ * S::kY;
        const std::int64_t depth = modulo(depth_.start + depth_.dx * x + depth_.dy * y, bits);
        if (int(raw(got.depth[l])) != depth >> kConfig.depth_fraction) return "stamp.depth";
      }
    }
    if (any_sent) return stamp.empty() ? nullptr : "a stamp too many";
    if (stamp.empty()) return "no end of a triangle";
    got = stamp.read();
    for (int l = 0; l < F::kLanes; ++l) {
      if (is_set(got.mask[l])) return "stamp.mask of no pixel";
    }
    if (!is_set(got.triangle_last) || is_set(got.last) != last || raw(got.index) != 3) return "the end of a triangle";
    return stamp.empty() ? nullptr : "a stamp too many";
  }

  const int width_, height_;
  Frame<F> frame_{};
  Stream<Triangle<F>> triangle;
  Stream<Setup<F>> setup;
  Stream<Attributes<F>> attributes;
  Stream<Planes<F>> planes;
  Stream<Stamp<F>> stamp;
  Stream<TriangleDepth<F>> triangle_depth;
  Probe<int> visits_;
  Setup<F> setup_;
  Attributes<F> attributes_;
  bool has_attributes_ = false, returned_ = false;
  int x_start_ = 0, x_min_ = 0, x_max_ = 0, y_min_ = 0, y_max_ = 0;
  PlaneNumbers depth_{};
  std::vector<Place> path_;
};

// All triangles whose vertices are places with a number modulo `every` of 0, a set of which is as good as another.
template <class S>
void expect_all(int width, int height, int every) {
  Triangles<S> all(width, height);
  for (int a = 0; a < kPlaces; ++a) {
    for (int b = a; b < kPlaces; ++b) {
      for (int c = b; c < kPlaces; ++c) {
        if (every > 1 && (a + b + c) % every) continue;
        const char* wrong = all.run(a, b, c);
        ASSERT_EQ(wrong, nullptr) << wrong << " of (" << place(a).x << ", " << place(a).y << ") (" << place(b).x << ", "
                                  << place(b).y << ") (" << place(c).x << ", " << place(c).y << ") in half pixels";
      }
    }
  }
  EXPECT_GT(all.covered, all.empty / 4);
  EXPECT_GT(all.walked, all.covered / S::kX / S::kY / 2);
  std::printf("%lld visits, %lld pixels covered, %lld triangles empty\n", (long long)(all.walked),
              (long long)(all.covered), (long long)(all.empty));
}

// With label `long` all of them in each size of stamp.
int only(int every) { return std::getenv("HALFSPACE_LATTICE") ? 1 : every; }

// 2,829,056 sets of three places, each in six orders.
TEST(Exhaustive, TrianglesByPixels) { expect_all<Stamp1>(4, 4, 1); }
TEST(Exhaustive, TrianglesByPairs) { expect_all<Stamp2>(3, 4, only(7)); }
TEST(Exhaustive, TrianglesByStamps) { expect_all<Stamp4>(3, 3, only(5)); }

// All edges of the configuration, both ways, at the 16 pixel centres of its frame: 268,369,920 edge functions. One of
// the two sides has the centre, whatever else is about it.
TEST(Exhaustive, EdgesHaveEachCentreOnOneSide) {
  using F = Formats<Micro, Stamp1>;
  using Coord = typename F::Coord;
  using Delta = typename F::Delta;
  constexpr int kSide = 1 << 6, kEnds = kSide * kSide;
  std::int64_t ties = 0, tried = 0;
  for (int n = 0; n < kEnds; ++n) {
    const Place a = {n % kSide - kSide / 2, n / kSide - kSide / 2};
    for (int m = n + 1; m < kEnds; ++m) {
      const Place b = {m % kSide - kSide / 2, m / kSide - kSide / 2};
      const int dx = b.x - a.x, dy = b.y - a.y;
      // A centre on the edge moves right by a hair, and down by less than that.
      const bool keeps = dx - 128 * dy > 0;
      for (int p = 0; p < 16; ++p) {
        const Place at = centre(p % 4, p / 4);
        const int cross = dx * (at.y - a.y) - dy * (at.x - a.x);
        const Coord px = from_raw<Coord>(at.x), py = from_raw<Coord>(at.y);
        const int there = int(raw(edge_start<F>(from_raw<Coord>(a.x), from_raw<Coord>(a.y), from_raw<Delta>(dx),
                                                from_raw<Delta>(dy), px, py)));
        const int back = int(raw(edge_start<F>(from_raw<Coord>(b.x), from_raw<Coord>(b.y), from_raw<Delta>(-dx),
                                               from_raw<Delta>(-dy), px, py)));
        ties += cross == 0;
        tried += 2;
        if ((there >= 0) == (back >= 0) || there != (cross - !keeps) >> 1 || back != (-cross - keeps) >> 1) {
          FAIL() << "edge (" << a.x << ", " << a.y << ") to (" << b.x << ", " << b.y << ") at (" << at.x << ", " << at.y
                 << "), in half pixels: " << there << ", and " << back << " from the other end";
        }
      }
    }
  }
  EXPECT_EQ(tried, 2 * 16 * std::int64_t(kEnds) * (kEnds - 1) / 2);
  EXPECT_GT(ties, 300000);
}

}  // namespace
}  // namespace halfspace::tests
