// SPDX-License-Identifier: Apache-2.0
// Lights, materials and normals of a LightingFrame as records, and into the tables of the kernels.
#ifndef HALFSPACE_MODEL_SHADE_LIGHTING_RECORDS_HPP_
#define HALFSPACE_MODEL_SHADE_LIGHTING_RECORDS_HPP_

#include <vector>

#include "hls/shade/lighting.hpp"
#include "model/shade/lighting.hpp"

namespace halfspace::model {

template <class T>
void fill_components(T (&to)[3], const std::array<int, 3>& from) {
  for (int c = 0; c < 3; ++c) to[c] = from_raw<T>(from[c]);
}

// The words that went into the table.
template <class F>
std::vector<Light<F>> load_lights(const LightingFrame& frame, LightTable<F>& table) {
  std::vector<Light<F>> words;
  Stream<Light<F>> stream;
  stream.tap(&words);
  for (std::size_t i = 0; i < frame.lights.size(); ++i) {
    Light<F> light{};
    light.light = from_raw<typename F::LightNumber>(i);
    fill_components(light.to_light, frame.lights[i].to_light);
    fill_components(light.half, frame.lights[i].half);
    stream.write(light);
    store_light(stream, table);
  }
  return words;
}

template <class F>
std::vector<Material<F>> load_materials(const LightingFrame& frame, MaterialTable<F>& table) {
  std::vector<Material<F>> words;
  Stream<Material<F>> stream;
  stream.tap(&words);
  for (std::size_t m = 0; m < frame.materials.size(); ++m) {
    const RawMaterial& in = frame.materials[m];
    for (std::size_t i = 0; i < in.reflections.size(); ++i) {
      Material<F> entry{};
      entry.material = from_raw<typename F::MaterialNumber>(m);
      entry.light = from_raw<typename F::LightNumber>(i);
      entry.gloss = from_raw<typename F::Gloss>(in.gloss);
      fill_components(entry.base, in.reflections[i].base);
      fill_components(entry.diffuse, in.reflections[i].diffuse);
      fill_components(entry.specular, in.reflections[i].specular);
      stream.write(entry);
      store_material(stream, table);
    }
  }
  return words;
}

template <class F>
Normals<F> normals_record(const RawNormals& in, int index, bool last) {
  Normals<F> out{};
  out.last = from_raw<Bit>(last);
  out.index = from_raw<typename F::Index>(index);
  out.material = from_raw<typename F::MaterialNumber>(in.material);
  for (int v = 0; v < 3; ++v) {
    out.x[v] = from_raw<typename F::Normal>(in.normals[v][0]);
    out.y[v] = from_raw<typename F::Normal>(in.normals[v][1]);
    out.z[v] = from_raw<typename F::Normal>(in.normals[v][2]);
  }
  return out;
}

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_SHADE_LIGHTING_RECORDS_HPP_
