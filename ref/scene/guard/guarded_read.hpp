// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_SCENE_GUARD_GUARDED_READ_HPP_
#define HALFSPACE_REF_SCENE_GUARD_GUARDED_READ_HPP_

#include <functional>
#include <string>

#include "ref/scene/document.hpp"

namespace halfspace::ref {

struct ReadLimits {
  unsigned long seconds;    // of the processor
  unsigned long megabytes;  // beside what this process has
};

// They grow with the file: a mesh in text takes its readers up to fifty times its size, and a second for some
// megabytes.
ReadLimits limits_of(const std::string& path);

// What `read` makes of the file at `path`, read in a child process: the libraries that read scenes and pictures crash,
// hang and grow on bad files, and that ends the child alone. It has limits, and says nothing on the screen. A signal, a
// limit or a broken answer is an Error with the path, as are those of `read`. Call it while this process has one
// thread.
Document guarded_read(const std::string& path, const std::function<Document()>& read, const ReadLimits& limits);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_SCENE_GUARD_GUARDED_READ_HPP_
