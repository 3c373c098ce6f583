// SPDX-License-Identifier: Apache-2.0
// The kernels of the named configurations, of one without depth and gradients, of type γ, and of one with objects, with
// 4 lanes, on the numbers that types_engine.cpp was compiled with. It is compiled once for each library, and the
// objects may stand in one program.
#ifndef HALFSPACE_TESTS_NUMBERS_TYPES_ENGINE_HPP_
#define HALFSPACE_TESTS_NUMBERS_TYPES_ENGINE_HPP_

#include <memory>
#include <string>

#include "model/objects/merge.hpp"
#include "model/pipeline/engine.hpp"

// Those of the numbers that the file is compiled with.
#if defined(HALFSPACE_TYPES_SYSTEMC)
#define HS_MAKE_ENGINE make_systemc_engine
#define HS_MERGE systemc_merge
#elif defined(HALFSPACE_TYPES_AP)
#define HS_MAKE_ENGINE make_ap_engine
#define HS_MERGE ap_merge
#elif defined(HALFSPACE_TYPES_AC)
#define HS_MAKE_ENGINE make_ac_engine
#define HS_MERGE ac_merge
#endif

namespace halfspace::tests {

constexpr int kTypesLanes = 4;

std::unique_ptr<model::Engine> make_systemc_engine(const std::string& config);
std::unique_ptr<model::Engine> make_ap_engine(const std::string& config);
std::unique_ptr<model::Engine> make_ac_engine(const std::string& config);

// The words of a run of ztest_merge in ObjectsMiddle.
std::vector<model::StreamWords> systemc_merge(const model::MergeInput&);
std::vector<model::StreamWords> ap_merge(const model::MergeInput&);
std::vector<model::StreamWords> ac_merge(const model::MergeInput&);

}  // namespace halfspace::tests

#endif  // HALFSPACE_TESTS_NUMBERS_TYPES_ENGINE_HPP_
