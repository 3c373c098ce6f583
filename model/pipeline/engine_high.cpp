// SPDX-License-Identifier: Apache-2.0
#include "hls/formats/configs/high.hpp"
#include "model/pipeline/engine_impl.hpp"

namespace halfspace::model {
std::unique_ptr<Engine> make_engine_high(int lanes) { return make_kernel_engine<High>(lanes); }
}  // namespace halfspace::model
