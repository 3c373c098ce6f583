// SPDX-License-Identifier: Apache-2.0
// The SystemVerilog package of a configuration, printed from the format table and the records.
#ifndef HALFSPACE_VECTORS_PACKAGE_HPP_
#define HALFSPACE_VECTORS_PACKAGE_HPP_

#include <string>

#include "vectors/configuration.hpp"

namespace halfspace::vectors {

// The text of rtl/<config>/hs_formats_pkg.sv.
std::string formats_package(const Configuration&);

}  // namespace halfspace::vectors

#endif  // HALFSPACE_VECTORS_PACKAGE_HPP_
