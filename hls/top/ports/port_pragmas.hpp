// SPDX-License-Identifier: Apache-2.0
// What the first lines of a top say of its ports. Of a composed one HS_DEPTH says how many words a channel has; where
// HS_DATAFLOW is defined the pragma of that name stands in it, as Bambu takes none from a macro. Catapult and Bambu
// take the ports from their own files.
#ifndef HALFSPACE_HLS_TOP_PORTS_PORT_PRAGMAS_HPP_
#define HALFSPACE_HLS_TOP_PORTS_PORT_PRAGMAS_HPP_

#include "hls/numbers/pragmas.hpp"

#ifdef HS_PRAGMA
#define HS_STREAM_PORT(name) HS_PRAGMA(HLS INTERFACE mode = axis port = name)
#define HS_REGISTER_PORT(name) HS_PRAGMA(HLS INTERFACE mode = s_axilite port = name)
#define HS_MEMORY_PORT(name) HS_PRAGMA(HLS INTERFACE mode = ap_memory port = name)
#define HS_STARTED HS_PRAGMA(HLS INTERFACE mode = s_axilite port = return )
#define HS_FREE_RUNNING HS_PRAGMA(HLS INTERFACE mode = ap_ctrl_none port = return )
#define HS_DATAFLOW
#define HS_DEPTH(name, words) HS_PRAGMA(HLS STREAM variable = name depth = words)
#else
#define HS_STREAM_PORT(name)
#define HS_REGISTER_PORT(name)
#define HS_MEMORY_PORT(name)
#define HS_STARTED
#define HS_FREE_RUNNING
#ifdef __BAMBU__
#define HS_DATAFLOW
#endif
#define HS_DEPTH(name, words)
#endif

#endif  // HALFSPACE_HLS_TOP_PORTS_PORT_PRAGMAS_HPP_
