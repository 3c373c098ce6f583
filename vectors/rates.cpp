// SPDX-License-Identifier: Apache-2.0
#include "vectors/rates.hpp"

#include <algorithm>
#include <string>

#include "vectors/field_value.hpp"

namespace halfspace::vectors {

ref::Rates count_rates(Engine& engine, const ref::SnappedList& scene) {
  ref::Rates rates;
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
  engine.capture(scene, [&](const Layout& layout, const Word* words, std::size_t count) {
    normals = normals || layout.stream == "normals";
    if (layout.stream == "colours") {
      const auto find = [&](const char* name) {
        return std::find_if(layout.fields.begin(), layout.fields.end(), [&](const Field& f) { return f.name == name; });
      };
      colours = true;
      const int vertices = find("r0") != layout.fields.end() ? 3 : 1;
      for (std::size_t n = 0; n < count; ++n) lit += field_value(words[n], *find("index")) != 0 ? vertices : 0;
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
