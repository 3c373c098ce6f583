// SPDX-License-Identifier: Apache-2.0
#include "model/pipeline/rates.hpp"

#include <algorithm>
#include <map>
#include <string>

#include "model/formats/field_value.hpp"
#include "model/pipeline/cycles.hpp"

namespace halfspace::model {

ref::Rates count_rates(Engine& engine, const ref::SnappedList& scene, const Config& config) {
  ref::Rates rates;
  const int texels_of_pixel = is_bilinear(config) ? 4 : 1;
  // Where the lanes, or the words, of a field are not 0.
  struct Counter {
    const char *stream, *field;
    std::uint64_t ref::Rates::*rate;
  };
  constexpr Counter kCounters[] = {{"visible", "index", &ref::Rates::triangles},  // 0: a frame without triangles
                                   {"visible", "visible", &ref::Rates::reduced_triangles},
                                   {"stamp", "mask", &ref::Rates::fragments},
                                   {"update", "mask", &ref::Rates::reduced_fragments},
                                   {"scan", "index", &ref::Rates::visible_pixels}};
  bool normals = false, colours = false;
  std::uint64_t lit = 0;
  std::map<std::int64_t, bool> has_texture;  // of the triangle that an index stands for at scan-out
  engine.capture(scene, [&](const Layout& layout, const Word* words, std::size_t count) {
    normals = normals || layout.stream == "normals";
    if (layout.stream == "colours") {
      colours = true;
      const int vertices = layout.fields.back().name == "b2" ? 3 : 1;
      lit = count_set(layout, words, count, "index") * std::uint64_t(vertices);
    }
    if (layout.stream == "texture_planes") {
      const Field &empty = field_named(layout, "empty"), &index = field_named(layout, "index"),
                  &texture = field_named(layout, "texture");
      for (std::size_t n = 0; n < count; ++n) {
        if (field_value(words[n], empty) == 0)
          has_texture[field_value(words[n], index)] = field_value(words[n], texture) != 0;
      }
    }
    if (layout.stream == "scan" && !has_texture.empty()) {
      const Field& index = field_named(layout, "index");
      for (std::size_t n = 0; n < count; ++n) {
        for (int lane = 0; lane < index.count; ++lane) {
          const auto found = has_texture.find(field_value(words[n], index, lane));
          if (found != has_texture.end() && found->second) rates.texture_fetches += std::uint64_t(texels_of_pixel);
        }
      }
    }
    if (layout.stream == "setup" && culls(config)) {
      // Empty for no other reason than its sign. Index 0: none of the pool was left for it.
      const SetupModel setup(config, scene.width, scene.height);
      const Field &empty = field_named(layout, "empty"), &index = field_named(layout, "index");
      for (std::size_t k = 0; k < std::min(count, scene.triangles.size()); ++k) {
        rates.culled += field_value(words[k], empty) != 0 && field_value(words[k], index) != 0 &&
                        setup.has_sign(scene.triangles[k]);
      }
    }
    for (const Counter& counter : kCounters) {
      if (layout.stream == counter.stream) rates.*counter.rate += count_set(layout, words, count, counter.field);
    }
  });
  if (normals) rates.lightings = colours ? lit : rates.visible_pixels;
  rates.pixels = std::uint64_t(scene.width) * scene.height;
  return rates;
}

}  // namespace halfspace::model
