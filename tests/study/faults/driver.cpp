// SPDX-License-Identifier: Apache-2.0
// `halfspace bounds` of a file, as rows that do not hold. Compiled with the kernels as they are, and with a fault.
#include <cstdio>
#include <exception>

#include "study/bounds/bounds.hpp"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  try {
    halfspace::model::MeasureOptions options;
    options.triangles = 100;
    const auto report = halfspace::model::measured_bounds(halfspace::model::find_configuration(argv[1]), options);
    for (const auto& row : report.rows) {
      if (row.present() && row.exceeded != 0) std::printf("%s: %s\n", row.kernel.c_str(), row.quantity.c_str());
    }
    return report.holds() ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
