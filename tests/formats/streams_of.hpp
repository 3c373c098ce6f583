// SPDX-License-Identifier: Apache-2.0
// The words of an engine as one text, to compare two engines by.
#ifndef HALFSPACE_TESTS_FORMATS_STREAMS_OF_HPP_
#define HALFSPACE_TESTS_FORMATS_STREAMS_OF_HPP_

#include <string>
#include <vector>

#include "model/pipeline/engine.hpp"
#include "model/pipeline/named_frame.hpp"

namespace halfspace::tests {

// What the words of all streams of some frames come to.
inline std::string streams_of(model::Engine& engine, const std::vector<model::NamedFrame>& frames) {
  std::string text;
  for (const auto& frame : frames) {
    engine.capture(frame.scene, [&](const model::Layout& layout, const model::Word* words, std::size_t count) {
      text += layout.stream;
      for (std::size_t n = 0; n < count; ++n) model::append_hex(text, words[n], layout.bits);
    });
  }
  return text;
}

}  // namespace halfspace::tests

#endif  // HALFSPACE_TESTS_FORMATS_STREAMS_OF_HPP_
