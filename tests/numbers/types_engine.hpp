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
