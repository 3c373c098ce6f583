// SPDX-License-Identifier: Apache-2.0
// Files that go with the program when a signal ends it.
#ifndef HALFSPACE_VECTORS_UNFINISHED_HPP_
#define HALFSPACE_VECTORS_UNFINISHED_HPP_

#include <string>

namespace halfspace::model {

// One that is being written, for as long as this lives.
class Unfinished {
 public:
  explicit Unfinished(const std::string& path);
  ~Unfinished();
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;

 private:
  struct Entry;
  Entry* entry_;
};

}  // namespace halfspace::model

#endif  // HALFSPACE_VECTORS_UNFINISHED_HPP_
