// SPDX-License-Identifier: Apache-2.0
#include "study/bounds/bounds_measure.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace halfspace::model {

namespace {

std::uint64_t low_bits(std::uint64_t value, int bits) { return value & ((std::uint64_t(1) << bits) - 1); }

std::uint64_t register_at(const PlaneNumbers& n, const ProbedPlane& plane, int x, int y) {
  const std::uint64_t at = plane.start + std::uint64_t(plane.dx) * std::uint64_t(std::int64_t(x) - plane.x) +
                           std::uint64_t(plane.dy) * std::uint64_t(std::int64_t(y) - plane.y);
  return low_bits(at, n.value_bits + n.fraction);
}

}  // namespace

double plane_error(const PlaneNumbers& n, const ExactTriangle& exact, const Values& values, const ProbedPlane& plane,
                   int x, int y) {
  const std::uint64_t half = std::uint64_t(1) << (n.fraction - 1);
  const std::uint64_t bits = low_bits(register_at(n, plane, x, y) - half, n.value_bits + n.fraction);
  return register_error(bits, n.value_bits, n.fraction, exact.value(values, x, y), exact.area());
}

std::uint64_t seed_of(const ref::SnappedTriangle& triangle) {
  std::uint64_t seed = 0;
  for (int v = 0; v < 3; ++v) {
    for (const std::uint64_t number : {std::uint64_t(std::uint32_t(triangle.x[v])),
                                       std::uint64_t(std::uint32_t(triangle.y[v])), std::uint64_t(triangle.depth[v])}) {
      seed = (seed ^ number) * 0x9e3779b97f4a7c15u;
      seed ^= seed >> 29;
    }
  }
  return seed;
}

std::vector<PlaneChannel> plane_channels(const Config& config) {
  std::vector<PlaneChannel> channels;
  if (has_depth(config)) {
    channels.push_back(
        {kDepths, depth_numbers(config), kDepthGradient, kDepthPlane, kDepthPlaneInFrame, kDepthSteps, kDepthRounded});
  }
  if (is_gouraud(config)) {
    channels.push_back({kColours, colour_numbers(config), kColourGradient, kColourPlane, kColourPlaneInFrame,
                        kColourSteps, kColourRounded});
  }
  if (is_phong(config)) {
    channels.push_back({kNormals, normal_numbers(config), kNormalGradient, kNormalPlane, kNormalPlaneInFrame,
                        kNormalSteps, kNormalRounded});
  }
  if (has_coordinates(config)) {
    channels.push_back({kCoordinates, coordinate_numbers(config), kCoordinateGradient, kCoordinatePlane,
                        kCoordinatePlaneInFrame, kCoordinateSteps, kCoordinateRounded});
  }
  if (relights(config)) {
    channels.push_back({kDifferences, difference_numbers(config), kDifferenceGradient, kDifferencePlane,
                        kDifferencePlaneInFrame, kDifferenceSteps, kDifferenceRounded});
  }
  return channels;
}

TriangleMeter::TriangleMeter(const Configuration& configuration, BoundsReport& report)
    : config_(configuration.config()),
      report_(report),
      probe_(make_kernel_probe(config_)),
      channels_(plane_channels(config_)) {
  if (has_motion(config_)) features_.push_back(make_motion_meter(configuration, *probe_, report));
  else features_.push_back(make_surface_meter(config_, *probe_, report));
  if (has_texture(config_)) features_.push_back(make_texture_meter(config_, *probe_, report));
}

void TriangleMeter::finish() {
  for (auto& feature : features_) feature->finish();
}

int TriangleMeter::components(PlaneKind kind) const {
  return kind == kDepths ? 1 : kind == kCoordinates && !has_perspective(config_) ? 2 : 3;
}

Values TriangleMeter::values_of(const ExactTriangle& exact, const PlaneChannel& channel, int c) const {
  if (channel.kind == kDepths) return exact.depth();
  Values values = exact.colour(c);
  for (auto& v : values) v = stretched_colour(config_, int(v), channel.numbers.value_bits);
  return values;
}

const ProbedPlane& TriangleMeter::plane_of(const ProbedSetup& setup, PlaneKind kind, int c) {
  const auto at = std::size_t(c);
  return kind == kDepths        ? setup.depth
         : kind == kCoordinates ? setup.coordinate[at]
         : kind == kDifferences ? setup.difference[at]
                                : setup.colour[at];
}

std::uint32_t TriangleMeter::sent_of(const ProbedPixel& pixel, PlaneKind kind, int c) {
  const auto at = std::size_t(c);
  return kind == kDepths        ? pixel.depth
         : kind == kCoordinates ? pixel.coordinate[at]
         : kind == kDifferences ? pixel.difference[at]
                                : pixel.colour[at];
}

void TriangleMeter::begin(const std::string& class_name, int width, int height) {
  report_.classes.push_back({class_name});
  width_ = width, height_ = height;
  probe_->set_frame(width, height);
}

Witness TriangleMeter::place(int x, int y) const {
  const ClassRow& row = report_.classes.back();
  return {row.name, row.triangles, true, triangle_, x, y};
}

void TriangleMeter::measure(const ref::SnappedTriangle& triangle) {
  triangle_ = triangle;
  ++report_.classes.back().triangles;
  const int one = 1 << config_.subpixel_bits;
  in_frame_ = true;
  for (int v = 0; v < 3; ++v) {
    in_frame_ = in_frame_ && triangle.x[v] >= 0 && triangle.x[v] <= config_.width * one && triangle.y[v] >= 0 &&
                triangle.y[v] <= config_.height * one;
  }

  const ExactTriangle exact(triangle, config_.subpixel_bits);
  const ProbedSetup setup = probe_->setup(triangle);
  const std::vector<ProbedPixel> pixels = probe_->pixels();
  measure_coverage(exact, pixels);
  if (setup.empty) return;
  measure_setup(exact, setup);
  for (const PlaneChannel& channel : channels_) {
    for (int c = 0; c < components(channel.kind); ++c) {
      const Values values = values_of(exact, channel, c);
      const Attribute attribute = {channel, exact, values, plane_of(setup, channel.kind, c)};
      measure_gradients(attribute, setup);
      for (const ProbedPixel& p : pixels) measure_pixel(attribute, sent_of(p, channel.kind, c), p.x, p.y);
    }
  }
  for (const ProbedPixel& p : pixels) {
    if (shades_planes(config_) || has_motion(config_)) break;
    if (report_.rows[kColourSteps].count(1, !std::equal(p.colour.begin(), p.colour.end(), triangle.rgb[0].begin())))
      report_.rows[kColourSteps].where = place(p.x, p.y);
  }
  for (auto& feature : features_) feature->measure({triangle_, exact, pixels, place()});
  report_.classes.back().pixels += pixels.size();
}

// Edge functions are kept without their low f bits. The reciprocal's error is |R·D − 2^(r+s)| in units of 2^s.
void TriangleMeter::measure_setup(const ExactTriangle& exact, const ProbedSetup& setup) {
  for (int i = 0; i < 3; ++i) {
    const int next = (i + 1) % 3;
    const bool equal = Wide(setup.e[i]) == exact.edge(i, setup.depth.x, setup.depth.y) >> config_.subpixel_bits &&
                       setup.e_dx[i] == exact.y(i) - exact.y(next) && setup.e_dy[i] == exact.x(next) - exact.x(i);
    if (report_.rows[kEdges].count(1, !equal)) report_.rows[kEdges].where = place();
  }
  if (!has_planes(config_)) return;
  const Wide error = setup.reciprocal * exact.area() - (Wide(1) << (config_.reciprocal_bits + setup.shift));
  const bool normal = exact.area() >> setup.shift == 1;
  BoundRow& row = report_.rows[kReciprocal];
  if (row.see(normal ? std::ldexp(double(error), -setup.shift) : INFINITY, 1)) row.where = place();
}

// A gradient is kept modulo 2^b; N·R·2^−n in units of 2^−g is not.
void TriangleMeter::measure_gradients(const Attribute& attribute, const ProbedSetup& setup) {
  const auto& [channel, exact, values, plane] = attribute;
  const int bits = channel.numbers.value_bits + channel.numbers.fraction;
  const int n = setup.shift + config_.reciprocal_bits - config_.subpixel_bits - channel.numbers.fraction;
  const Numerators numerators = exact.numerators(values);
  for (const auto& [numerator, kept] : {std::pair(numerators.x, plane.dx), std::pair(numerators.y, plane.dy)}) {
    const Wide product = numerator * Wide(setup.reciprocal);
    const Wide below = product >> n;  // the unit below: what is kept is it or the next
    const std::uint64_t above = low_bits(std::uint64_t(kept) - std::uint64_t(below), bits);
    const double rest = std::ldexp(double(product - below * (Wide(1) << n)), -n);
    BoundRow& row = report_.rows[channel.gradient];
    if (row.see(above <= 1 ? double(above) - rest : INFINITY, 0.5)) row.where = place();
  }
}

void TriangleMeter::measure_pixel(const Attribute& attribute, std::uint32_t sent, int x, int y) {
  const auto& [channel, exact, values, plane] = attribute;
  const double error = plane_error(channel.numbers, exact, values, plane, x, y);
  const Dyadic reach = {std::llabs(exact.dx(x)) + std::llabs(exact.dy(y)), -config_.subpixel_bits};
  const PlaneBound bound = plane_bound(channel.numbers, reach);
  const double limit = value(error > 0 ? bound.sum : bound.in_register);
  auto see = [this, x, y](Quantity q, double seen, double largest) {
    if (report_.rows[q].see(seen, largest)) report_.rows[q].where = place(x, y);
  };
  see(channel.plane, error, limit);
  if (in_frame_) see(channel.plane_in_frame, error, limit);

  const std::uint64_t integer = register_at(channel.numbers, plane, x, y) >> channel.numbers.fraction;
  if (report_.rows[channel.steps].count(1, integer != sent)) report_.rows[channel.steps].where = place(x, y);
  // An integer that wrapped would be off by 2^b: it is not taken modulo that.
  const Wide off = Wide(sent) * exact.area() - exact.value(values, x, y);
  see(channel.rounded, double(off) / double(exact.area()), value(bound.rounded));

  ClassRow& row = report_.classes.back();
  ClassRow::Largest& largest = row.planes[channel.kind];
  largest.error = std::max(largest.error, std::fabs(error));
  largest.share = std::max(largest.share, std::fabs(error) / limit);
}

// Row by row of the bounding box; pixels beyond it, or sent twice, differ as well.
void TriangleMeter::measure_coverage(const ExactTriangle& exact, const std::vector<ProbedPixel>& pixels) {
  std::vector<std::pair<int, int>> sent;  // y, x
  sent.reserve(pixels.size());
  for (const ProbedPixel& p : pixels) sent.emplace_back(p.y, p.x);
  std::sort(sent.begin(), sent.end());
  BoundRow& row = report_.rows[kCoverage];
  const PixelSpan columns = exact.columns(width_), rows = exact.rows(height_);
  std::size_t at = 0;
  for (int y = rows.first; y <= rows.last; ++y) {
    const PixelSpan span = exact.span(y, width_);
    std::int64_t differ = std::max(0, span.last - span.first + 1);
    for (; at < sent.size() && sent[at].first <= y; ++at) {
      const bool again = at > 0 && sent[at - 1] == sent[at];
      const bool right = sent[at].first == y && sent[at].second >= span.first && sent[at].second <= span.last && !again;
      differ += right ? -1 : 1;
    }
    if (row.count(std::uint64_t(std::max(0, columns.last - columns.first + 1)), std::uint64_t(differ))) {
      row.where = place(span.first, y);
    }
  }
  if (row.count(sent.size() - at, sent.size() - at)) row.where = place(sent[at].second, sent[at].first);
}

}  // namespace halfspace::model
