// SPDX-License-Identifier: Apache-2.0
// SystemC's library has a main() that calls this. A test brings its own main(), so that nothing may.
#include <cstdio>

extern "C" int sc_main(int, char**) {
  std::fputs("the main() of SystemC ran in the place of the test's: link it after the test's\n", stderr);
  return 1;
}
