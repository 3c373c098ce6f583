// SPDX-License-Identifier: Apache-2.0
// The waveform around the first failure of a run: the run is repeated, with a model that is built for it when it is
// asked for and not before.
#ifndef HALFSPACE_TB_REPORT_WAVE_HPP_
#define HALFSPACE_TB_REPORT_WAVE_HPP_

#include <functional>

#include "tb/harness/bench.hpp"

namespace halfspace::tb {

// `result`: what the run gave; `again`: does the same once more with other models. In a program whose model writes no
// waves another one is built, and is called with the same arguments. Throws Error.
void write_wave(int argc, char** argv, const Options& options, const Result& result,
                const std::function<void()>& again);

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_REPORT_WAVE_HPP_
