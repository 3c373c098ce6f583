// SPDX-License-Identifier: Apache-2.0
#include "hls/configs/low.hpp"
#include "vectors/engine_impl.hpp"

namespace halfspace::vectors {
std::unique_ptr<Engine> make_engine_low(int lanes) { return make_kernel_engine<Low>(lanes); }
}  // namespace halfspace::vectors
