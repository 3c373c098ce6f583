// SPDX-License-Identifier: Apache-2.0
// What every model includes, to be precompiled: it takes longer to parse than a unit's model.
#ifndef HALFSPACE_TB_HARNESS_HEADER_HPP_
#define HALFSPACE_TB_HARNESS_HEADER_HPP_

#include <verilated.h>

#include "tb/harness/model.hpp"

#endif  // HALFSPACE_TB_HARNESS_HEADER_HPP_
