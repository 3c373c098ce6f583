// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_SCENE_CHECK_DOCUMENT_HPP_
#define HALFSPACE_REF_SCENE_CHECK_DOCUMENT_HPP_

#include "ref/scene/document.hpp"

namespace halfspace::ref {

// Error, with the path and the place, unless every number in the document names what is there, every list has the
// length that its neighbours ask for, and what places vertices is finite. So nothing behind it has to ask again.
void check_document(const Document&);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_SCENE_CHECK_DOCUMENT_HPP_
