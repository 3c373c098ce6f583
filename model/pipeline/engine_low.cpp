// SPDX-License-Identifier: Apache-2.0
#include "hls/formats/configs/low.hpp"
#include "model/pipeline/engine_impl.hpp"

namespace halfspace::model {
std::unique_ptr<Engine> make_engine_low(int lanes) { return make_kernel_engine<Low>(lanes); }
}  // namespace halfspace::model
