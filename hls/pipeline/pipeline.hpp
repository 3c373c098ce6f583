// SPDX-License-Identifier: Apache-2.0
// The composition: which unit feeds which. Nothing else names two stages. In hardware each unit is a process that runs
// on its streams for ever (hls/top/ has their tops); natively a call takes one triangle, or one stamp, through all of
// them.
#ifndef HALFSPACE_HLS_PIPELINE_PIPELINE_HPP_
#define HALFSPACE_HLS_PIPELINE_PIPELINE_HPP_

#include "hls/pipeline/back.hpp"
#include "hls/pipeline/front.hpp"

#endif  // HALFSPACE_HLS_PIPELINE_PIPELINE_HPP_
