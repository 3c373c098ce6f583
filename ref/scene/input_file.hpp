// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_SCENE_INPUT_FILE_HPP_
#define HALFSPACE_REF_SCENE_INPUT_FILE_HPP_

#include <string>

namespace halfspace::ref {

// Error unless `path` names a file that can be read and is not empty.
void check_input_file(const std::string& path);

// Text from a file, fit for a sentence: one line, printable, no longer than `limit`.
std::string one_line(const std::string& text, std::size_t limit = 200);

// The part of a path after its last dot, in lower case; empty without one.
std::string extension_of(const std::string& path);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_SCENE_INPUT_FILE_HPP_
