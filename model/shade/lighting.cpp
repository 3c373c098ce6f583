// SPDX-License-Identifier: Apache-2.0
#include "model/shade/lighting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "ref/error.hpp"
#include "ref/geometry/distant_lighting.hpp"

namespace halfspace::model {
namespace {

// To nearest, and within the width.
int quantized(double value, const NumberFormat& format) {
  const double scaled = std::round(std::ldexp(value, format.width - format.integer));
  const double most = std::ldexp(1.0, format.width - int(format.is_signed)) - 1;
  return int(std::clamp(scaled, format.is_signed ? -most : 0.0, most));
}

std::array<int, 3> quantized(const glm::dvec3& v, const NumberFormat& format) {
  return {quantized(v.x, format), quantized(v.y, format), quantized(v.z, format)};
}

// Corner cases and random frames of one configuration.
class Frames {
 public:
  Frames(const Config& config, std::uint64_t seed)
      : config_(config), table_(format_table(config)), random_(seed), squarings_(exact_log2(config.gloss)) {
    limit_ = 1 << (table_.normal.width - 1);
    corners();
    for (int n = 0; n < 4; ++n) random(n);
  }

  std::vector<LightingFrame> take() { return std::move(frames_); }

 private:
  using Normal = std::array<int, 3>;

  int below(int n) { return int(random_() % std::uint64_t(n)); }
  glm::dvec3 random_unit() {
    std::normal_distribution<double> normal;
    return glm::normalize(glm::dvec3(normal(random_), normal(random_), normal(random_)) + glm::dvec3(1e-9));
  }
  int coefficient(int share) { return int((std::int64_t(1) << table_.coefficient.width) * share / 256 - (share != 0)); }

  RawLight light(const glm::dvec3& to_light, const glm::dvec3& half) {
    return {quantized(to_light, table_.direction), quantized(half, table_.direction)};
  }

  // Lights from all axes in turn, straight and from behind, and highlights along them.
  LightingFrame& frame(const std::string& note) {
    LightingFrame& f = frames_.emplace_back();
    f.note = note;
    const glm::dvec3 ways[] = {{0, 0, 1}, {0, -1, 0}, {0, 0, -1}, {0.6, 0, 0.8}};
    for (int i = 0; i < config_.lights; ++i) {
      f.lights.push_back(light(ways[i], i == 2 ? glm::dvec3(0) : ways[(i + 3) % 4]));
    }
    // In turn every gloss, and one beyond what is built. Material 5 is below full scale however it is lit, 6 has a base
    // alone, and 7 is all at its largest.
    for (int m = 0; m < config_.materials; ++m) {
      RawMaterial& material = f.materials.emplace_back();
      material.gloss = m % (squarings_ + 2) & ((1 << table_.gloss.width) - 1);
      for (int i = 0; i < config_.lights; ++i) {
        const int share = m == 5 ? 6 : m == 6 ? 0 : 64;
        const int base = coefficient(i == 0 ? 3 * (m % 4) : 0), full = coefficient(256);
        if (m == 7) {
          material.reflections.push_back({{full, full, full}, {full, full, full}, {full, full, full}});
          continue;
        }
        material.reflections.push_back({{base, base / 2, 0},
                                        {coefficient(share), coefficient(share * 3 / 4), coefficient(share / 2)},
                                        {coefficient(share / 2), coefficient(share / 4), coefficient(share)}});
      }
    }
    return f;
  }

  void add(LightingFrame& f, int material, const Normal& a, const Normal& b, const Normal& c) {
    f.triangles.push_back({1 + int(f.triangles.size()) % config_.triangles, material % config_.materials, {a, b, c}});
  }

  void corners() {
    LightingFrame& alone = frame("corner: one normal, of length 0");
    add(alone, 1, {0, 0, 0}, {0, 0, 0}, {0, 0, 0});

    LightingFrame& f =
        frame("corner: normals of length 0, shortest and longest, along axes and diagonals, all materials");
    const int most = limit_ - 1, least = -limit_, half = limit_ / 2;
    std::vector<Normal> normals;
    for (const int x : {0, 1, -1, 2, half, most, least}) {
      for (const int y : {0, 1, -3, -half, most, least}) {
        for (const int z : {0, 1, -1, half - 1, most, least}) normals.push_back({x, y, z});
      }
    }
    for (std::size_t n = 0; n < normals.size(); ++n) {
      add(f, int(n), normals[n], normals[(n + 1) % normals.size()], normals[(n + 7) % normals.size()]);
    }

    LightingFrame& edge = frame("corner: light that grazes: n·L of −1, 0, 1 and a few units");
    for (int n = 0; n < 200; ++n) {
      // At right angles to (0.6, 0, 0.8) and to (0, 0, 1) but for the last place.
      const int s = 1 + below(limit_ / 4);
      add(edge, n, {4 * s - limit_ / 2, below(5) - 2, -3 * s}, {s, -s, n % 3 - 1}, {-s, n % 5 - 2, below(3) - 1});
    }

    LightingFrame& lengths = frame("corner: one direction in every length, and its neighbours");
    for (int bit = 0; bit < table_.normal.width - 1; ++bit) {
      const int s = 1 << bit;
      for (int n = 0; n < 6; ++n) {
        add(lengths, n + bit, {s - 1, s / 2, s}, {s, -s / 3, s - n % 2}, {n - 3, s - 1, s - 1});
      }
    }

    LightingFrame& loud = frame("corner: directions and coefficients at their largest");
    const int far = (1 << (table_.direction.width - 1)) - 1;
    for (RawLight& l : loud.lights) l = {{far, far, far}, {far, -far - 1, far}};
    for (int n = 0; n < 60; ++n) {
      const int materials[] = {1, 5, 7, 7};
      add(loud, materials[n % 4], {most - n, most, most}, {most, least, most - n}, {n - 30, 2 * n, 1});
    }
  }

  void random(int n) {
    LightingFrame& f = frames_.emplace_back();
    f.note = fmt::format("random: frame {}", n);
    for (int i = 0; i < config_.lights; ++i) f.lights.push_back(light(random_unit(), random_unit()));
    for (int m = 0; m < config_.materials; ++m) {
      RawMaterial& material = f.materials.emplace_back();
      material.gloss = below(squarings_ + 1);
      const int bits = table_.coefficient.width - below(5);
      auto any = [&] { return below(1 << bits); };
      for (int i = 0; i < config_.lights; ++i) {
        material.reflections.push_back(
            {{any() / 8, any() / 8, any() / 8}, {any(), any(), any()}, {any(), any(), any()}});
      }
    }
    for (int t = 0; t < 300; ++t) {
      Normal normals[3];
      for (Normal& normal : normals) {
        // Also near the direction of a highlight, and of any length.
        const RawLight& near = f.lights[std::size_t(below(config_.lights))];
        const glm::dvec3 way = t % 3 == 0 ? random_unit()
                                          : glm::dvec3(near.half[0], near.half[1], near.half[2]) /
                                                    std::ldexp(1.0, table_.direction.width - 1) +
                                                0.1 * random_unit();
        const glm::dvec3 scaled = way * std::ldexp(1.0, -below(t % 2 ? 2 : table_.normal.width));
        normal = quantized(glm::clamp(scaled, -1.0, 1.0), table_.normal);
      }
      add(f, below(config_.materials), normals[0], normals[1], normals[2]);
    }
  }

  Config config_;
  FormatTable table_;
  std::mt19937_64 random_;
  int squarings_, limit_;
  std::vector<LightingFrame> frames_;
};

}  // namespace

int most_squarings(const Config& config) { return has_gloss(config) ? exact_log2(config.gloss) : -1; }

LightingFrame quantized_lighting(const ref::DistantScene& scene, const Config& config) {
  auto refuse = [&](const char* what, std::size_t has, int most, const char* field) {
    throw ref::Error(fmt::format("the scene has {} {}, and configuration {} is built for {}: raise {}", has, what,
                                 config.name, most, field));
  };
  if (scene.lights.size() > std::size_t(config.lights)) refuse("lights", scene.lights.size(), config.lights, "lights");
  if (scene.materials.size() > std::size_t(config.materials)) {
    refuse("materials", scene.materials.size(), config.materials, "materials");
  }
  const FormatTable table = format_table(config);
  const double scale = ((1 << config.colour_bits) - 1) / 255.0;
  LightingFrame frame;
  frame.lights.resize(std::size_t(config.lights));
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    frame.lights[i] = {quantized(scene.lights[i].to_light, table.direction),
                       quantized(scene.lights[i].half, table.direction)};
  }
  for (const ref::DistantMaterial& in : scene.materials) {
    RawMaterial& material = frame.materials.emplace_back();
    material.gloss = in.squarings;
    material.reflections.resize(std::size_t(config.lights));
    material.reflections[0].base = quantized(scale * in.base, table.coefficient);
    for (std::size_t i = 0; i < in.reflections.size(); ++i) {
      material.reflections[i].diffuse = quantized(scale * in.reflections[i].diffuse, table.coefficient);
      material.reflections[i].specular = quantized(scale * in.reflections[i].specular, table.coefficient);
    }
  }
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    const ref::DistantTriangle& in = scene.triangles[t];
    RawNormals& out = frame.triangles.emplace_back();
    out.index = 1 + int(t % std::size_t(config.triangles));
    out.material = in.material;
    for (int v = 0; v < 3; ++v) out.normals[v] = quantized(in.normals[v], table.normal);
  }
  return frame;
}

std::array<int, 3> quantized_normal(const glm::dvec3& normal, const Config& config) {
  return quantized(normal, format_table(config).normal);
}

std::vector<LightingFrame> lighting_frames(const Config& config, std::uint64_t seed) {
  return Frames(config, seed).take();
}

}  // namespace halfspace::model
