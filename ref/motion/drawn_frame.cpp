// SPDX-License-Identifier: Apache-2.0
#include "ref/motion/drawn_frame.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

#include "ref/raster/architecture.hpp"
#include "ref/raster/ideal.hpp"

namespace halfspace::ref {
namespace {

// Groups that grow together; each goes by its lowest member.
class Groups {
 public:
  explicit Groups(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0); }
  std::uint32_t of(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = of(a), b = of(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

// Of the faces of a mesh, from 0 on.
std::vector<std::uint32_t> groups_of(const Mesh& mesh) {
  std::map<std::array<double, 6>, std::uint32_t> first_at;  // face at a vertex
  Groups groups(mesh.triangles.size());
  for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face) {
    for (const std::uint32_t v : mesh.triangles[face]) {
      const glm::dvec3 &p = mesh.positions[v], &n = mesh.normals[v];
      groups.join(face, first_at.try_emplace({p.x, p.y, p.z, n.x, n.y, n.z}, face).first->second);
    }
  }
  std::vector<std::uint32_t> of_face;
  for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face) of_face.push_back(groups.of(face));
  return of_face;
}

// The samples of a pixel that show one identity.
struct Part {
  std::uint32_t identity;
  unsigned samples;
  std::array<unsigned, 3> sum;
};

std::vector<Part> parts_of(const DrawnFrame& frame, int x, int y, int samples, const Identities& identities) {
  std::vector<Part> parts;
  for (int s = 0; s < samples * samples; ++s) {
    const std::size_t at = std::size_t(y + s / samples) * frame.width + x + s % samples;
    const std::uint32_t identity = identities[frame.face[at]];
    if (identity == 0) continue;
    const auto same = [&](const Part& part) { return part.identity == identity; };
    auto part = std::find_if(parts.begin(), parts.end(), same);
    if (part == parts.end()) part = parts.insert(part, Part{identity, 0, {}});
    ++part->samples;
    for (int c = 0; c < 3; ++c) part->sum[c] += frame.colour[at][c];
  }
  std::stable_sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.samples > b.samples; });
  return parts;
}

KeyFrame ranked_key_frame(const DrawnFrame& frame, int samples, const Identities& identities, std::size_t rank) {
  KeyFrame key{frame.width / samples, frame.height / samples, {}, {}};
  key.colour = averaged(frame.colour, frame.width, frame.height, samples);
  key.identity.assign(key.colour.size(), 0);
  for (std::size_t at = 0; at < key.colour.size(); ++at) {
    const int x = int(at) % key.width * samples, y = int(at) / key.width * samples;
    const std::vector<Part> parts = parts_of(frame, x, y, samples, identities);
    if (parts.size() <= rank) continue;
    const Part& part = parts[rank];
    key.identity[at] = part.identity;
    for (int c = 0; c < 3; ++c) key.colour[at][c] = std::uint8_t((2 * part.sum[c] + part.samples) / (2 * part.samples));
  }
  return key;
}

}  // namespace

DrawnFrame draw_frame(Geometry& geometry, const Look& look) {
  const SnappedList list = snap(geometry.positions(), look.format);
  std::unique_ptr<Surface> surface = lit_surface(geometry, list, look.shading);
  if (look.texture) surface = textured_surface(std::move(surface), geometry, list, *look.texture);
  Drawing drawing = draw(list, *surface, Architecture::kDelta);
  for (std::uint32_t& shown : drawing.triangle) shown = face_of(geometry.positions(), shown);
  return {list.width, list.height, std::move(drawing.colour), std::move(drawing.triangle)};
}

Colours averaged(const Colours& colours, int width, int height, int samples) {
  Colours out;
  const unsigned count = unsigned(samples * samples);
  for (int y = 0; y < height; y += samples) {
    for (int x = 0; x < width; x += samples) {
      std::array<unsigned, 3> sum{};
      for (int s = 0; s < samples * samples; ++s) {
        const auto& colour = colours[std::size_t(y + s / samples) * width + x + s % samples];
        for (int c = 0; c < 3; ++c) sum[c] += colour[c];
      }
      auto& mean = out.emplace_back(std::array<std::uint8_t, 4>{0, 0, 0, 255});
      for (int c = 0; c < 3; ++c) mean[c] = std::uint8_t((2 * sum[c] + count) / (2 * count));
    }
  }
  return out;
}

KeyFrame key_frame(const DrawnFrame& frame, int samples, const Identities& identities) {
  return ranked_key_frame(frame, samples, identities, 0);
}

KeyFrame second_key_frame(const DrawnFrame& frame, int samples, const Identities& identities) {
  return ranked_key_frame(frame, samples, identities, 1);
}

KeyFrame pure_key_frame(const DrawnFrame& frame, int samples, const Identities& identities) {
  KeyFrame key{frame.width / samples, frame.height / samples, {}, {}};
  key.colour = averaged(frame.colour, frame.width, frame.height, samples);
  for (int y = 0; y < frame.height; y += samples) {
    for (int x = 0; x < frame.width; x += samples) {
      std::uint32_t shown = identities[frame.face[std::size_t(y) * frame.width + x]];
      for (int s = 1; s < samples * samples; ++s) {
        if (identities[frame.face[std::size_t(y + s / samples) * frame.width + x + s % samples]] != shown) shown = 0;
      }
      key.identity.push_back(shown);
    }
  }
  return key;
}

Identities face_identities(const Scene& scene) {
  std::size_t faces = 0;
  for (const Instance& instance : scene.instances) faces += scene.meshes[instance.mesh].triangles.size();
  Identities identities(faces + 1);
  std::iota(identities.begin(), identities.end(), 0);
  return identities;
}

Identities surface_identities(const Scene& scene) {
  Identities identities{0};
  std::uint32_t last = 0;
  for (const Instance& instance : scene.instances) {
    const std::vector<std::uint32_t> groups = groups_of(scene.meshes[instance.mesh]);
    std::vector<std::uint32_t> number(groups.size(), 0);
    for (const std::uint32_t group : groups) {
      if (number[group] == 0) number[group] = ++last;
      identities.push_back(number[group]);
    }
  }
  return identities;
}

}  // namespace halfspace::ref
