// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include "study/fit/fit.hpp"

namespace halfspace::model {
namespace {

using Triangle = std::array<ref::Vertex, 3>;

double twice_area(const Triangle& t) {
  return (t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[2].x - t[0].x) * (t[1].y - t[0].y);
}

// |∂v/∂x| + |∂v/∂y| of an attribute. Slivers thinner than a thousandth of a pixel cover no centre to speak of.
template <class Get>
double gradient(const Triangle& t, Get value) {
  const double area = twice_area(t);
  if (std::fabs(area) < 1e-3) return 0;
  const double dv1 = value(t[1]) - value(t[0]), dv2 = value(t[2]) - value(t[0]);
  const double dx = dv1 * (t[2].y - t[0].y) - dv2 * (t[1].y - t[0].y),
               dy = dv2 * (t[1].x - t[0].x) - dv1 * (t[2].x - t[0].x);
  return (std::fabs(dx) + std::fabs(dy)) / std::fabs(area);
}

// The depths of the two nearest surfaces of each pixel.
class Layers {
 public:
  Layers(int width, int height) : width_(width), height_(height), nearest_(std::size_t(width) * height, {2, 2}) {}

  void draw(const Triangle& t) {
    const double area = twice_area(t);
    if (area == 0) return;
    auto [x_low, x_high] = std::minmax({t[0].x, t[1].x, t[2].x});
    auto [y_low, y_high] = std::minmax({t[0].y, t[1].y, t[2].y});
    const int first_x = int(std::clamp(std::ceil(x_low - 0.5), 0.0, double(width_)));
    const int last_x = int(std::clamp(std::floor(x_high - 0.5), -1.0, width_ - 1.0));
    const int first_y = int(std::clamp(std::ceil(y_low - 0.5), 0.0, double(height_)));
    const int last_y = int(std::clamp(std::floor(y_high - 0.5), -1.0, height_ - 1.0));
    for (int y = first_y; y <= last_y; ++y) {
      for (int x = first_x; x <= last_x; ++x) {
        double weight[3], depth = 0;
        bool inside = true;
        for (int i = 0; i < 3; ++i) {
          const ref::Vertex &a = t[(i + 1) % 3], &b = t[(i + 2) % 3];
          weight[i] = ((b.x - a.x) * (y + 0.5 - a.y) - (b.y - a.y) * (x + 0.5 - a.x)) / area;
          inside = inside && weight[i] > 0;  // a centre on an edge belongs to one surface of two
          depth += weight[i] * t[i].z;
        }
        if (!inside) continue;
        auto& pixel = nearest_[std::size_t(y) * width_ + x];
        if (depth < pixel[0]) pixel = {depth, pixel[0]};
        else pixel[1] = std::min(pixel[1], depth);
      }
    }
  }

  void tell(Requirements& r) const {
    for (const auto& [first, second] : nearest_) {
      if (second > 1) continue;
      ++r.overlapping;
      r.depth_separation = std::min(r.depth_separation, second - first);
    }
  }

 private:
  int width_, height_;
  std::vector<std::array<double, 2>> nearest_;
};

}  // namespace

Requirements requirements(const FitScene& scene) {
  Requirements r;
  r.x_low = r.y_low = std::numeric_limits<double>::max();
  r.x_high = r.y_high = std::numeric_limits<double>::lowest();
  ref::TriangleList before;
  for (std::size_t frame = 0; frame < scene.frames.size(); ++frame) {
    ref::TriangleList list = scene.frames[frame].triangles(ref::ideal_view(scene.width, scene.height));
    r.triangles = std::max(r.triangles, list.triangles.size());
    Layers layers(scene.width, scene.height);
    for (const Triangle& t : list.triangles) {
      for (const ref::Vertex& v : t) {
        r.x_low = std::min(r.x_low, v.x), r.x_high = std::max(r.x_high, v.x);
        r.y_low = std::min(r.y_low, v.y), r.y_high = std::max(r.y_high, v.y);
        r.one_colour_each =
            r.one_colour_each && std::fabs(v.r - t[0].r) + std::fabs(v.g - t[0].g) + std::fabs(v.b - t[0].b) < 1e-6;
      }
      r.depth_gradient = std::max(r.depth_gradient, gradient(t, [](const ref::Vertex& v) { return v.z; }));
      for (const auto channel : {&ref::Vertex::r, &ref::Vertex::g, &ref::Vertex::b}) {
        r.colour_gradient = std::max(r.colour_gradient, gradient(t, [&](const ref::Vertex& v) { return v.*channel; }));
      }
      layers.draw(t);
    }
    layers.tell(r);
    // Faces that both frames show whole.
    if (before.face == list.face && !scene.begins_view(frame)) {
      for (std::size_t k = 0; k < std::min(before.triangles.size(), list.triangles.size()); ++k) {
        for (int v = 0; v < 3; ++v) {
          r.motion = std::max(r.motion, std::hypot(list.triangles[k][v].x - before.triangles[k][v].x,
                                                   list.triangles[k][v].y - before.triangles[k][v].y));
        }
      }
    }
    before = std::move(list);
  }
  return r;
}

}  // namespace halfspace::model
