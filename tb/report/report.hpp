// SPDX-License-Identifier: Apache-2.0
// What the runs gave, for a person and as JSON.
#ifndef HALFSPACE_TB_REPORT_REPORT_HPP_
#define HALFSPACE_TB_REPORT_REPORT_HPP_

#include <string>
#include <vector>

#include "tb/harness/bench.hpp"

namespace halfspace::tb {

// Failures, a table of the streams, and last the line "cosim SCENE CONFIG: …" or "bench UNIT SCENE CONFIG: …".
void print_result(const Vectors& vectors, const Result& result);

// From now on what is printed goes to standard error, and standard output has the file "-" alone.
void give_standard_output_to_files();
// Writes through a second file, so that a failure leaves the old one as it was; a device or a pipe is written to, and
// of a link its target. Throws Error.
void write_file(const std::string& file, const std::string& bytes);
std::string json_report(const Vectors& vectors, const Options& options, const std::vector<Result>& results);

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_REPORT_REPORT_HPP_
