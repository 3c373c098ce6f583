// SPDX-License-Identifier: Apache-2.0
#include "tests/numbers/types_engine.hpp"

#include "hls/formats/configs/high.hpp"
#include "hls/formats/configs/low.hpp"
#include "hls/formats/configs/middle.hpp"
#include "model/objects/merge_impl.hpp"
#include "model/pipeline/engine_impl.hpp"
#include "tests/formats/feature_configs.hpp"
#include "tests/objects/object_configs.hpp"

namespace halfspace::tests {
namespace {

// Names of this file alone: whatever a kernel instantiates with them is its own, and no other object's of the same name
// on other numbers is taken for it.
struct OwnLow : Low {};
struct OwnMiddle : Middle {};
struct OwnHigh : High {};
struct OwnFlatOnly : FlatOnly {};
struct OwnGamma : Gamma {};
struct OwnObjects : ObjectsMiddle {};

template <class C>
std::unique_ptr<model::Engine> make() {
  static_assert(Stamp4::kX * Stamp4::kY == kTypesLanes, "the lanes that the header promises");
  return std::make_unique<model::KernelEngine<Formats<C, Stamp4>>>();
}

}  // namespace

std::unique_ptr<model::Engine> HS_MAKE_ENGINE(const std::string& config) {
  return config == Low::config().name             ? make<OwnLow>()
         : config == Middle::config().name        ? make<OwnMiddle>()
         : config == High::config().name          ? make<OwnHigh>()
         : config == FlatOnly::config().name      ? make<OwnFlatOnly>()
         : config == Gamma::config().name         ? make<OwnGamma>()
         : config == ObjectsMiddle::config().name ? make<OwnObjects>()
                                                  : nullptr;
}

std::vector<model::StreamWords> HS_MERGE(const model::MergeInput& input) {
  std::vector<model::StreamWords> streams;
  model::merge_run<Formats<OwnObjects, Stamp4>>(input, &streams);
  return streams;
}

}  // namespace halfspace::tests
