// SPDX-License-Identifier: Apache-2.0
// Files that are wrong, and the sentences that they are refused with.
#ifndef HALFSPACE_TESTS_SCENE_REFUSAL_HPP_
#define HALFSPACE_TESTS_SCENE_REFUSAL_HPP_

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "ref/error.hpp"

namespace halfspace::ref {

// The sentence of the Error that `what` ends in; a text that no test expects if it does not.
template <class What>
std::string refusal(What&& what) {
  try {
    what();
  } catch (const Error& error) {
    std::string sentence = error.what();
    EXPECT_EQ(sentence.find('\n'), sentence.npos) << sentence;
    return sentence;
  }
  return "(not refused)";
}

inline void expect_in(const std::string& part, const std::string& text) {
  EXPECT_NE(text.find(part), text.npos) << "expected '" << part << "' in: " << text;
}

class TemporaryFile {
 public:
  TemporaryFile(const std::string& name, const std::string& text)
      : path_(::testing::TempDir() + "halfspace_ref_" + name) {
    std::ofstream(path_, std::ios::binary) << text;
  }
  ~TemporaryFile() { std::filesystem::remove(path_); }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace halfspace::ref

#endif  // HALFSPACE_TESTS_SCENE_REFUSAL_HPP_
