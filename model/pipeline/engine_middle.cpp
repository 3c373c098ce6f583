// SPDX-License-Identifier: Apache-2.0
#include "hls/formats/configs/middle.hpp"
#include "model/pipeline/engine_impl.hpp"

namespace halfspace::model {
std::unique_ptr<Engine> make_engine_middle(int lanes) { return make_kernel_engine<Middle>(lanes); }
}  // namespace halfspace::model
