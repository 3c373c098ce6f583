// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_SCENE_ASSIMP_PROMISED_ELEMENTS_HPP_
#define HALFSPACE_REF_SCENE_ASSIMP_PROMISED_ELEMENTS_HPP_

#include <string>

namespace halfspace::ref {

// Error if the header of a PLY or OFF file announces more elements than the file can hold. Assimp 5.2
// believes such headers: it waits for ever for the rest of a cut PLY, and takes the memory that an OFF asks
// for.
void check_promised_elements(const std::string& path);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_SCENE_ASSIMP_PROMISED_ELEMENTS_HPP_
