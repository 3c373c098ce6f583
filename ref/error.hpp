// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_ERROR_HPP_
#define HALFSPACE_REF_ERROR_HPP_

#include <stdexcept>

namespace halfspace::ref {

// A fault of the input, as opposed to a fault of ours. what() is one sentence that names the file, the place
// in it and the remedy, ready to be shown to a person.
struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// The input is sound, and beyond what a configuration takes: a larger one may do.
struct Misfit : Error {
  using Error::Error;
};

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_ERROR_HPP_
