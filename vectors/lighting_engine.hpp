// SPDX-License-Identifier: Apache-2.0
// LightingEngine on one set of formats.
#ifndef HALFSPACE_VECTORS_LIGHTING_ENGINE_HPP_
#define HALFSPACE_VECTORS_LIGHTING_ENGINE_HPP_

#include "hls/light_vertex.hpp"
#include "vectors/lighting.hpp"

namespace halfspace::vectors {

template <class F>
class LightingKernels : public LightingEngine {
 public:
  using Sink = std::function<void(const Layout&, const Word*, std::size_t count)>;

  std::vector<Layout> layouts() const override {
    return {layout<Light<F>>(), layout<Material<F>>(), layout<Normals<F>>(), layout<Colours<F>>()};
  }

  void capture(const LightingFrame& frame, const Sink& sink) override {
    tell(load_lights(frame), sink);
    tell(load_materials(frame), sink);
    std::vector<Normals<F>> normals;
    for (std::size_t n = 0; n < frame.triangles.size(); ++n) normals.push_back(record(frame, n));
    tell(normals, sink);
    tell(light(normals), sink);
  }

  std::vector<std::array<std::array<std::uint64_t, 3>, 3>> sums(const LightingFrame& frame) override {
    load_lights(frame), load_materials(frame);
    std::vector<std::array<std::array<std::uint64_t, 3>, 3>> result(frame.triangles.size());
    for (std::size_t t = 0; t < result.size(); ++t) {
      const Normals<F> in = record(frame, t);
      for (int v = 0; v < (F::kGouraud ? 3 : 1); ++v) {
        const typename F::Normal n[3] = {in.x[v], in.y[v], in.z[v]};
        const LitSum<F> sum = light_sum<F>(n, in.material, lights_, materials_);
        for (int c = 0; c < 3; ++c) result[t][v][c] = raw(sum.channel[c]);
      }
    }
    return result;
  }

  std::vector<std::array<std::array<int, 3>, 3>> colours(const LightingFrame& frame) override {
    load_lights(frame), load_materials(frame);
    std::vector<Normals<F>> normals;
    for (std::size_t n = 0; n < frame.triangles.size(); ++n) normals.push_back(record(frame, n));
    std::vector<std::array<std::array<int, 3>, 3>> result;
    for (const Colours<F>& out : light(normals)) {
      auto& triangle = result.emplace_back();
      for (int v = 0; v < 3; ++v) triangle[v] = {int(raw(out.r[v])), int(raw(out.g[v])), int(raw(out.b[v]))};
    }
    return result;
  }

 private:
  template <class Record>
  static void tell(const std::vector<Record>& records, const Sink& sink) {
    const Layout words_layout = layout<Record>();
    std::vector<Word> words;
    for (const Record& record : records) words.push_back(pack(record, words_layout.bits));
    sink(words_layout, words.data(), words.size());
  }

  template <class T>
  static void fill(T (&to)[3], const std::array<int, 3>& from) {
    for (int c = 0; c < 3; ++c) to[c] = from_raw<T>(from[c]);
  }

  std::vector<Light<F>> load_lights(const LightingFrame& frame) {
    std::vector<Light<F>> words;
    Stream<Light<F>> stream;
    stream.tap(&words);
    for (std::size_t i = 0; i < frame.lights.size(); ++i) {
      Light<F> light{};
      light.light = from_raw<typename F::LightNumber>(i);
      fill(light.to_light, frame.lights[i].to_light);
      fill(light.half, frame.lights[i].half);
      stream.write(light);
      store_light(stream, lights_);
    }
    return words;
  }

  std::vector<Material<F>> load_materials(const LightingFrame& frame) {
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
        fill(entry.base, in.reflections[i].base);
        fill(entry.diffuse, in.reflections[i].diffuse);
        fill(entry.specular, in.reflections[i].specular);
        stream.write(entry);
        store_material(stream, materials_);
      }
    }
    return words;
  }

  static Normals<F> record(const LightingFrame& frame, std::size_t t) {
    Normals<F> out{};
    const RawNormals& in = frame.triangles[t];
    out.last = from_raw<Bit>(t + 1 == frame.triangles.size());
    out.index = from_raw<typename F::Index>(in.index);
    out.material = from_raw<typename F::MaterialNumber>(in.material);
    for (int v = 0; v < 3; ++v) {
      out.x[v] = from_raw<typename F::Normal>(in.normals[v][0]);
      out.y[v] = from_raw<typename F::Normal>(in.normals[v][1]);
      out.z[v] = from_raw<typename F::Normal>(in.normals[v][2]);
    }
    return out;
  }

  std::vector<Colours<F>> light(const std::vector<Normals<F>>& normals) {
    std::vector<Colours<F>> result;
    Stream<Normals<F>> in;
    Stream<Colours<F>> out;
    for (const Normals<F>& word : normals) {
      in.write(word);
      light_vertex(in, lights_, materials_, out);
      result.push_back(out.read());
    }
    return result;
  }

  LightTable<F> lights_{};
  MaterialTable<F> materials_{};
};

}  // namespace halfspace::vectors

#endif  // HALFSPACE_VECTORS_LIGHTING_ENGINE_HPP_
