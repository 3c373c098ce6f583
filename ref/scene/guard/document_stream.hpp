// SPDX-License-Identifier: Apache-2.0
// What a reading process made of a file, through a pipe.
#ifndef HALFSPACE_REF_SCENE_GUARD_DOCUMENT_STREAM_HPP_
#define HALFSPACE_REF_SCENE_GUARD_DOCUMENT_STREAM_HPP_

#include <stdexcept>
#include <string>

#include "ref/scene/document.hpp"

namespace halfspace::ref {

// The other end of the pipe is gone, or what it sent is no document.
struct BrokenStream : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// What became of a file: a document, or the sentence that refuses it.
struct Answer {
  std::string refusal;
  Document document;
};

void write_answer(int descriptor, const Answer&);
// Waits for it.
Answer read_answer(int descriptor);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_SCENE_GUARD_DOCUMENT_STREAM_HPP_
