// SPDX-License-Identifier: Apache-2.0
#include "hls/configs/high.hpp"
#include "vectors/engine_impl.hpp"

namespace halfspace::vectors {
std::unique_ptr<Engine> make_engine_high(int lanes) { return make_kernel_engine<High>(lanes); }
}  // namespace halfspace::vectors
