// SPDX-License-Identifier: Apache-2.0
#include "ref/motion/foresee.hpp"

#include <algorithm>
#include <cmath>

#include "ref/motion/quality.hpp"

namespace halfspace::ref {
namespace {

// Of the plane through the colours of the vertices, squared, weighted as PSNR_Y weights channels; no steeper than from
// black to white in a pixel.
double squared_gradient(const std::array<Vertex, 3>& t, const std::array<glm::dvec3, 3>& colours, double doubled_area) {
  const glm::dvec3 weights(0.299, 0.587, 0.114);
  const glm::dvec3 d1 = colours[1] - colours[0], d2 = colours[2] - colours[0];
  const glm::dvec3 dx = (d1 * (t[2].y - t[0].y) - d2 * (t[1].y - t[0].y)) / doubled_area;
  const glm::dvec3 dy = (d2 * (t[1].x - t[0].x) - d1 * (t[2].x - t[0].x)) / doubled_area;
  return std::min(glm::dot(weights, dx * dx + dy * dy), 255.0 * 255.0);
}

double mean_length(const Between& between, std::size_t triangle) {
  double length = 0;
  for (const auto& of_key : vectors(between, triangle)) {
    if (of_key) length += glm::length(((*of_key)[0] + (*of_key)[1] + (*of_key)[2]) / 3.0) / kKeys;
  }
  return length;
}

}  // namespace

double moving_gradient(const Between& between, Geometry& lit, const View& view) {
  double sum = 0;
  for (std::size_t k = 0; k < between.list.triangles.size(); ++k) {
    const std::array<Vertex, 3>& t = between.list.triangles[k];
    const double doubled_area = (t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[1].y - t[0].y) * (t[2].x - t[0].x);
    if (doubled_area == 0) continue;
    sum += std::abs(doubled_area) / 2 * squared_gradient(t, lit.colours(k), doubled_area) *
           std::min(1.0, mean_length(between, k));
  }
  return sum / (double(view.width) * view.height);
}

double foreseen_psnr_y(double moving_gradient) {
  if (!(moving_gradient > 0)) return kMostDecibels;
  return std::min(59 - 5.1 * std::log10(moving_gradient), kMostDecibels);
}

}  // namespace halfspace::ref
