// SPDX-License-Identifier: Apache-2.0
// LightingEngine on one set of formats.
#ifndef HALFSPACE_MODEL_SHADE_LIGHTING_ENGINE_HPP_
#define HALFSPACE_MODEL_SHADE_LIGHTING_ENGINE_HPP_

#include "hls/shade/light_vertex.hpp"
#include "model/shade/lighting_records.hpp"

namespace halfspace::model {

template <class F>
class LightingKernels : public LightingEngine {
 public:
  using Sink = std::function<void(const Layout&, const Word*, std::size_t count)>;

  void capture(const LightingFrame& frame, const Sink& sink) override {
    tell(load_lights(frame, lights_), sink);
    tell(load_materials(frame, materials_), sink);
    std::vector<Normals<F>> normals;
    for (std::size_t n = 0; n < frame.triangles.size(); ++n) normals.push_back(record(frame, n));
    tell(normals, sink);
    tell(light(normals), sink);
  }

  std::vector<std::array<std::array<std::uint64_t, 3>, 3>> sums(const LightingFrame& frame) override {
    load_lights(frame, lights_), load_materials(frame, materials_);
    std::vector<std::array<std::array<std::uint64_t, 3>, 3>> result(frame.triangles.size());
    for (std::size_t t = 0; t < result.size(); ++t) {
      const Normals<F> in = record(frame, t);
      for (int v = 0; v < (F::kShadesPlanes ? 3 : 1); ++v) {
        const typename F::Normal n[3] = {in.x[v], in.y[v], in.z[v]};
        const LitSum<F> sum = light_sum<F>(n, in.material, lights_, materials_);
        for (int c = 0; c < 3; ++c) result[t][v][c] = raw(sum.channel[c]);
      }
    }
    return result;
  }

  std::vector<std::array<std::array<int, 3>, 3>> colours(const LightingFrame& frame) override {
    load_lights(frame, lights_), load_materials(frame, materials_);
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

  static Normals<F> record(const LightingFrame& frame, std::size_t t) {
    return normals_record<F>(frame.triangles[t], frame.triangles[t].index, t + 1 == frame.triangles.size());
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

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_SHADE_LIGHTING_ENGINE_HPP_
