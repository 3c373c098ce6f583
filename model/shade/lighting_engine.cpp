// SPDX-License-Identifier: Apache-2.0
#include "model/shade/lighting_engine.hpp"

#include "model/formats/runtime_formats.hpp"

namespace halfspace::model {
namespace {

using F = RuntimeFormats<Stamp1>;

// The kernels, with their formats made the thread's before each use.
class RuntimeLighting : public LightingEngine {
 public:
  RuntimeLighting(const Config& config, const FormatTable& table) : config_(config), table_(table) {
    activate();
    kernels_ = std::make_unique<LightingKernels<F>>();
  }

  void capture(const LightingFrame& frame, const LightingKernels<F>::Sink& sink) override {
    activate();
    kernels_->capture(frame, sink);
  }
  std::vector<std::array<std::array<std::uint64_t, 3>, 3>> sums(const LightingFrame& frame) override {
    activate();
    return kernels_->sums(frame);
  }
  std::vector<std::array<std::array<int, 3>, 3>> colours(const LightingFrame& frame) override {
    activate();
    return kernels_->colours(frame);
  }

 private:
  void activate() const { F::activate(config_, table_); }

  Config config_;
  FormatTable table_;
  std::unique_ptr<LightingKernels<F>> kernels_;
};

}  // namespace

std::unique_ptr<LightingEngine> make_lighting_engine(const Config& config, const FormatTable& table) {
  return has_lighting(config) ? std::make_unique<RuntimeLighting>(config, table) : nullptr;
}
std::unique_ptr<LightingEngine> make_lighting_engine(const Config& config) {
  return make_lighting_engine(config, format_table(config));
}

}  // namespace halfspace::model
