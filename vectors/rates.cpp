// SPDX-License-Identifier: Apache-2.0
#include "vectors/rates.hpp"

#include <algorithm>
#include <map>
#include <string>

#include "vectors/field_value.hpp"

namespace halfspace::vectors {

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
    const auto field_of = [&](const char* name) -> const Field& {
      return *std::find_if(layout.fields.begin(), layout.fields.end(), [&](const Field& f) { return f.name == name; });
    };
    normals = normals || layout.stream == "normals";
    if (layout.stream == "colours") {
      colours = true;
      const int vertices = layout.fields.back().name == "b2" ? 3 : 1;
      for (std::size_t n = 0; n < count; ++n) lit += field_value(words[n], field_of("index")) != 0 ? vertices : 0;
    }
    if (layout.stream == "texture_planes") {
      for (std::size_t n = 0; n < count; ++n) {
        if (field_value(words[n], field_of("empty")) != 0) continue;
        has_texture[field_value(words[n], field_of("index"))] = field_value(words[n], field_of("texture")) != 0;
      }
    }
    if (layout.stream == "scan" && !has_texture.empty()) {
      const Field& index = field_of("index");
      for (std::size_t n = 0; n < count; ++n) {
        for (int lane = 0; lane < index.count; ++lane) {
          const auto found = has_texture.find(field_value(words[n], index, lane));
          if (found != has_texture.end() && found->second) rates.texture_fetches += std::uint64_t(texels_of_pixel);
        }
      }
    }
    for (const Counter& counter : kCounters) {
      if (layout.stream != counter.stream) continue;
      const auto field = std::find_if(layout.fields.begin(), layout.fields.end(), [&](const Field& f) { return f.name == counter.field; });
      for (std::size_t n = 0; n < count; ++n) {
        for (int lane = 0; lane < field->count; ++lane) rates.*counter.rate += field_value(words[n], *field, lane) != 0;
      }
    }
  });
  if (normals) rates.lightings = colours ? lit : rates.visible_pixels;
  rates.pixels = std::uint64_t(scene.width) * scene.height;
  return rates;
}

}  // namespace halfspace::vectors
