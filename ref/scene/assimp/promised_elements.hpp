// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_SCENE_ASSIMP_PROMISED_ELEMENTS_HPP_
#define HALFSPACE_REF_SCENE_ASSIMP_PROMISED_ELEMENTS_HPP_

#include <string>
#include <string_view>

namespace halfspace::ref {

// Error if a PLY or OFF file promises more than is there. Assimp 5.2 believes them: it waits for ever for the rest of a
// cut PLY, draws faces with corners that are not there, and takes the memory that an OFF asks for.
void check_promised_elements(const std::string& path);

// Of a PLY file: that each element has the numbers that the header says, and each face the corners that it says, which
// are vertices.
void check_ply(const std::string& path, std::string_view text);

// Of an OFF file: the same, in the lines that Assimp takes them from.
void check_off(const std::string& path, std::string_view text);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_SCENE_ASSIMP_PROMISED_ELEMENTS_HPP_
