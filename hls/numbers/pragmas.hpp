// SPDX-License-Identifier: Apache-2.0
// What kernels say to a synthesis tool. Catapult's pragmas are its directives, which name a loop by its label.
//
//   HS_PIPELINE(interval)   first in a loop: a pass begins each so many cycles
//   HS_UNROLL               first in a loop: its passes are hardware side by side
//   HS_IN_TURN              before a loop: its passes share their multipliers
//   HS_SHARED               before a function: its calls share it
//   HS_INLINE               before a function: a step of a process, whose state stays in registers where the loop about
//                           it is compiled; or what packs a word, which is wires
#ifndef HALFSPACE_HLS_NUMBERS_PRAGMAS_HPP_
#define HALFSPACE_HLS_NUMBERS_PRAGMAS_HPP_

// A top is compiled: its streams and its memories are of words.
#if defined(HALFSPACE_STREAM_HLS) || defined(HALFSPACE_STREAM_AC) || defined(HALFSPACE_STREAM_WORDS) || \
    defined(__VITIS_HLS__)
#define HS_WORDS
#endif

#if defined(HALFSPACE_STREAM_HLS) || defined(__VITIS_HLS__)
#define HS_PRAGMA(x) _Pragma(#x)
#define HS_PIPELINE(interval) HS_PRAGMA(HLS PIPELINE II = interval)
#define HS_UNROLL HS_PRAGMA(HLS UNROLL)
#else
#define HS_PIPELINE(interval)
#define HS_UNROLL
#endif

#if defined(__GNUC__) || defined(__clang__)
#define HS_INLINE __attribute__((always_inline))
#else
#define HS_INLINE
#endif

// Bambu unrolls and puts functions into their callers unless it is told.
#ifdef __BAMBU__
#define HS_IN_TURN _Pragma("clang loop unroll(disable)")
#define HS_SHARED __attribute__((noinline))
#else
#define HS_IN_TURN
#define HS_SHARED
#endif

#endif  // HALFSPACE_HLS_NUMBERS_PRAGMAS_HPP_
