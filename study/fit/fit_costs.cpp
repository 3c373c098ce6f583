// SPDX-License-Identifier: Apache-2.0
#include "study/fit/fit_costs.hpp"

#include <algorithm>

#include "model/formats/format_fields.hpp"
#include "model/pipeline/engine.hpp"
#include "model/pipeline/memories.hpp"
#include "model/pipeline/multipliers.hpp"
#include "ref/error.hpp"

namespace halfspace::model {

std::vector<int> fit_key(const Config& c) {
  std::vector<int> key;
  for (const ConfigField& field : config_fields()) key.push_back(field.get(c));
  return key;
}

std::uint64_t all_memory_bits(const Config& c) {
  const StampSize stamp = stamp_size(c.lanes);
  return memory_bits(c, stamp.x, stamp.y).total() + texture_bits(c).total();
}

std::uint64_t logic_bits(const Config& c) {
  const FormatTable table = format_table(c);
  std::uint64_t bits = 0;
  for (const FormatField& field : format_fields()) {
    if (field.is_used(c)) bits += std::uint64_t((table.*field.format).width);
  }
  return bits;
}

FitTraffic slowest_frame(const FitScene& scene, const Config& c) {
  FitTraffic most;
  const auto engine = make_engine(Configuration(c.name, c), c.lanes);
  for (const Subject& subject : scene.frames) {
    const Subject::Drawn drawn = subject.drawn(c, scene.width, scene.height);
    load_frame(*engine, c, drawn.frame);
    const ref::Frame frame = engine->render(drawn.frame.scene);
    most.cycles = std::max(most.cycles, model_cycles(c, *engine, drawn.frame.scene, frame).frame);
    most.bytes = std::max(most.bytes, total_bytes(count_accesses(c, *engine, drawn.frame.scene).words, entry_bits(c)) +
                                          texture_bytes(c, drawn.frame.texture, frame));
  }
  return most;
}

std::array<double, 3> FitCosts::of(Config c) {
  c.triangles = triangles_;
  const double logic = double(logic_bits(c)), memory = double(all_memory_bits(c));
  switch (cost_) {
    case FitCost::kMemory: return {memory, logic, 0};
    case FitCost::kLut: return {logic, memory, 0};
    case FitCost::kDsp: return {double(multiplier_bits(c).value_or(std::uint64_t(logic))), logic, memory};
    default: break;
  }
  const auto [at, is_new] = traffic_.try_emplace(fit_key(c));
  // Other positions may have other triangles: as many as an index of the same width tells apart, or of the next.
  for (c.triangles = (1 << bits_for(c.triangles)) - 1; is_new && at->second.cycles == 0;) {
    try {
      at->second = slowest_frame(scene_, c);
    } catch (const ref::Misfit&) {
      c.triangles = 2 * c.triangles + 1;
    }
  }
  return {double(cost_ == FitCost::kCycles ? at->second.cycles : at->second.bytes), memory, logic};
}

}  // namespace halfspace::model
