// SPDX-License-Identifier: Apache-2.0
#include "ref/motion/compensate.hpp"

#include <algorithm>
#include <cmath>

namespace halfspace::ref {
namespace {

// Less weight is what rounding leaves of none: a tap without weight does not match.
constexpr double kNoWeight = 1e-9;

// Pixels of a key as one place sees them.
class Taps {
 public:
  Taps(const KeyFrame& key, std::uint32_t identity, bool test) : key_(key), identity_(identity), test_(test) {}

  bool matches(int x, int y) const {
    if (x < 0 || y < 0 || x >= key_.width || y >= key_.height) return false;
    return !test_ || key_.identity[at(x, y)] == identity_;
  }
  glm::dvec3 colour(int x, int y) const {
    const auto& colour = key_.colour[at(x, y)];
    return {colour[0], colour[1], colour[2]};
  }

 private:
  std::size_t at(int x, int y) const { return std::size_t(y) * key_.width + x; }

  const KeyFrame& key_;
  const std::uint32_t identity_;
  const bool test_;
};

std::optional<glm::dvec3> bicubic(const Taps& taps, int x, int y, double tx, double ty) {
  const auto across = cubic_weights(tx), down = cubic_weights(ty);
  glm::dvec3 sum(0);
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) {
      if (!taps.matches(x - 1 + i, y - 1 + j)) return std::nullopt;
      sum += across[i] * down[j] * taps.colour(x - 1 + i, y - 1 + j);
    }
  }
  return sum;
}

// The weight of taps that do not match goes to the first one that does, in the order of weights: the nearest, its
// neighbour along the axis whose fraction is nearer to ½, the other neighbour, the one across.
std::optional<glm::dvec3> of_four(const Taps& taps, int x, int y, double tx, double ty, const CompensationMode& mode) {
  const int i = tx >= 0.5, j = ty >= 0.5;
  const bool x_first = std::abs(tx - 0.5) <= std::abs(ty - 0.5);
  const int along_x[2] = {1 - i, j}, along_y[2] = {i, 1 - j};
  const int(&second)[2] = x_first ? along_x : along_y, (&third)[2] = x_first ? along_y : along_x;
  const int order[4][2] = {{i, j}, {second[0], second[1]}, {third[0], third[1]}, {1 - i, 1 - j}};
  const auto across = axis_weights(mode.filter, tx), down = axis_weights(mode.filter, ty);
  glm::dvec3 sum(0);
  std::optional<glm::dvec3> first;
  double matched = 0;
  for (const auto& tap : order) {
    if (!taps.matches(x + tap[0], y + tap[1])) continue;
    const double weight = across[tap[0]] * down[tap[1]];
    const glm::dvec3 colour = taps.colour(x + tap[0], y + tap[1]);
    if (!first) first = colour;
    sum += weight * colour;
    matched += weight;
  }
  if (matched < std::max(kNoWeight, mode.least_weight - kNoWeight)) return std::nullopt;
  return sum + (1 - matched) * *first;
}

}  // namespace

const char* name_of(Filter filter) {
  constexpr const char* kNames[] = {"nearest", "bilinear", "area", "bicubic", "footprint"};
  return kNames[int(filter)];
}

std::array<double, 2> axis_weights(Filter filter, double t) {
  if (filter != Filter::kArea) return {1 - t, t};
  const double near = (1 - t) * (1 - t), far = t * t;
  return {near / (near + far), far / (near + far)};
}

std::array<double, 4> cubic_weights(double t) {
  const double t2 = t * t, t3 = t2 * t;
  return {(-t3 + 2 * t2 - t) / 2, (3 * t3 - 5 * t2 + 2) / 2, (-3 * t3 + 4 * t2 + t) / 2, (t3 - t2) / 2};
}

std::optional<glm::dvec3> fetch(const KeyFrame& key, const glm::dvec2& place, std::uint32_t identity,
                                const CompensationMode& mode) {
  // Beyond it no tap is in the frame, and the place may be beyond any integer.
  if (!(place.x > -1 && place.y > -1 && place.x < key.width + 1 && place.y < key.height + 1)) return std::nullopt;
  const Taps taps(key, identity, mode.index_test);
  if (mode.filter == Filter::kNearest) {
    const int x = int(std::floor(place.x)), y = int(std::floor(place.y));
    if (!taps.matches(x, y)) return std::nullopt;
    return taps.colour(x, y);
  }
  const int x = int(std::floor(place.x - 0.5)), y = int(std::floor(place.y - 0.5));
  const double tx = place.x - 0.5 - x, ty = place.y - 0.5 - y;
  if (mode.filter == Filter::kBicubic) {
    if (const auto colour = bicubic(taps, x, y, tx, ty)) return colour;
  }
  return of_four(taps, x, y, tx, ty, mode);
}

namespace {

// How far the place in a key goes from a pixel of the field to the next one along an axis, as its neighbours of the
// same triangle have it: in pixels of the field, of which (1, 0) and (0, 1) are what does not move.
glm::dvec2 stretch(const MotionField& field, int key, std::size_t at, bool down) {
  const std::size_t width = std::size_t(field.width), step = down ? width : 1;
  const std::size_t number = down ? at / width : at % width, last = std::size_t(down ? field.height : field.width) - 1;
  const auto& vectors = field.to_key[key];
  const glm::dvec2 unit(down ? 0 : 1, down ? 1 : 0), here = *vectors[at];
  const auto is_there = [&](std::size_t other) {
    return field.triangle[other] == field.triangle[at] && vectors[other].has_value();
  };
  glm::dvec2 change(0);
  int neighbours = 0;
  if (number > 0 && is_there(at - step)) change += here - *vectors[at - step], ++neighbours;
  if (number < last && is_there(at + step)) change += *vectors[at + step] - here, ++neighbours;
  return unit + change / double(std::max(neighbours, 1));
}

// The mean over the pixel that is carried to the key: so many places each way as it is pixels of the key long.
std::optional<glm::dvec3> fetch_footprint(const KeyFrame& key, const glm::dvec2& place, const glm::dvec2& right,
                                          const glm::dvec2& down, std::uint32_t identity,
                                          const CompensationMode& mode) {
  constexpr int kMost = 8;  // places each way
  const auto places = [&](const glm::dvec2& side) {
    return std::clamp(int(std::ceil(glm::length(side) - 0.25)), 1, kMost);
  };
  const int across = places(right), rows = places(down);
  glm::dvec3 sum(0);
  int shown = 0;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < across; ++i) {
      const glm::dvec2 at = place + right * ((i + 0.5) / across - 0.5) + down * ((j + 0.5) / rows - 0.5);
      const auto colour = fetch(key, at, identity, mode);
      if (colour) sum += *colour, ++shown;
    }
  }
  if (shown == 0) return std::nullopt;
  return sum / double(shown);
}

// Of one pixel of the field.
struct OfTheKeys {
  std::uint8_t keys = 0;  // that show it
  OfKeys<glm::dvec3> colour;
};

OfTheKeys fetched(const OfKeys<KeyFrame>& keys, const MotionField& field, std::size_t at, std::uint32_t identity,
                  const CompensationMode& mode) {
  OfTheKeys out;
  const double scale = double(keys[0].width) / field.width;
  const std::size_t x = at % std::size_t(field.width), y = at / std::size_t(field.width);
  const glm::dvec2 centre(double(x) + 0.5, double(y) + 0.5);
  for (int key = 0; key < kKeys; ++key) {
    const auto& vector = field.to_key[key][at];
    if (!vector || !mode.use[key]) continue;
    const glm::dvec2 place = (centre + *vector) * scale;
    const auto colour = mode.filter == Filter::kFootprint
                            ? fetch_footprint(keys[key], place, stretch(field, key, at, false) * scale,
                                              stretch(field, key, at, true) * scale, identity, mode)
                            : fetch(keys[key], place, identity, mode);
    if (!colour) continue;
    out.keys |= std::uint8_t(1 << key);
    out.colour[key] = *colour;
  }
  return out;
}

}  // namespace

Compensated compensate(const OfKeys<KeyFrame>& keys, const MotionField& field, const Identities& identities, double a,
                       const CompensationMode& mode, const LightPlanes& light, const Colours& rendered,
                       const OfKeys<KeyFrame>* second) {
  const OfKeys<double> time{1 - a, a};
  Compensated out{rendered, std::vector<std::uint8_t>(field.face.size(), 0), {}};
  for (std::size_t at = 0; at < field.face.size(); ++at) {
    if (field.face[at] == 0) {
      ++out.shares.background;
      continue;
    }
    const std::uint32_t identity = identities[field.face[at]];
    OfTheKeys of = fetched(keys, field, at, identity, mode);
    if (of.keys == 0 && second) of = fetched(*second, field, at, identity, mode);
    if (of.keys == 0 && !mode.render_holes) {
      CompensationMode untested = mode;
      untested.index_test = false;
      of = fetched(keys, field, at, identity, untested);
    }
    out.keys[at] = of.keys;
    if (of.keys == 0) {
      ++out.shares.filled;
      continue;
    }
    for (int key = 0; key < kKeys; ++key) {
      if (!light[key].empty()) of.colour[key] += light[key][at];
    }
    ++(of.keys == 3 ? out.shares.blended : out.shares.copied);
    const glm::dvec3 sum = of.keys == 3 ? time[0] * of.colour[0] + time[1] * of.colour[1] : of.colour[of.keys - 1];
    for (int c = 0; c < 3; ++c) out.colour[at][c] = std::uint8_t(std::floor(std::clamp(sum[c], 0.0, 255.0) + 0.5));
  }
  return out;
}

std::vector<bool> made_of_keys(const std::vector<std::uint8_t>& keys, const std::vector<std::uint32_t>& face, int width,
                               int height, int samples, Shares& shares) {
  std::vector<bool> made(std::size_t(width / samples) * (height / samples), false), rendered(made);
  for (int y = 0; y < height / samples * samples; ++y) {
    for (int x = 0; x < width / samples * samples; ++x) {
      const std::size_t at = std::size_t(y) * width + x;
      const std::size_t pixel = std::size_t(y / samples) * (width / samples) + x / samples;
      if (face[at] == 0) continue;
      if (keys[at] == 0) rendered[pixel] = true;
      else made[pixel] = true;
    }
  }
  for (std::size_t pixel = 0; pixel < made.size(); ++pixel) {
    shares.pixels += made[pixel] || rendered[pixel];
    shares.rendered += rendered[pixel];
    made[pixel] = made[pixel] && !rendered[pixel];
  }
  return made;
}

}  // namespace halfspace::ref
