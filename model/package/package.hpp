// SPDX-License-Identifier: Apache-2.0
// The SystemVerilog package of a configuration, printed from the format table and the records.
#ifndef HALFSPACE_MODEL_PACKAGE_PACKAGE_HPP_
#define HALFSPACE_MODEL_PACKAGE_PACKAGE_HPP_

#include <string>

#include "model/formats/configuration.hpp"

namespace halfspace::model {

// The text of rtl/<config>/hs_formats_pkg.sv.
std::string formats_package(const Configuration&);

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_PACKAGE_PACKAGE_HPP_
