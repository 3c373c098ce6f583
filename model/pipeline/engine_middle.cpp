// SPDX-License-Identifier: Apache-2.0
#include "hls/configs/middle.hpp"
#include "vectors/engine_impl.hpp"

namespace halfspace::vectors {
std::unique_ptr<Engine> make_engine_middle(int lanes) { return make_kernel_engine<Middle>(lanes); }
}  // namespace halfspace::vectors
