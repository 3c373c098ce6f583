// SPDX-License-Identifier: Apache-2.0
// The Verilog that Bambu makes of a function of hls/top/pixel, Verilated as VPixel: its cases from the standard input,
// a start each cycle. Status 0 if the expected words come out in their order, one a cycle. HS_PIXEL_PORTS(model) is a
// list of the ports.
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "VPixel.h"

namespace {

std::vector<std::vector<std::uint64_t>> cases_of_input() {
  std::vector<std::vector<std::uint64_t>> cases;
  for (std::string line; std::getline(std::cin, line);) {
    std::istringstream words(line);
    words >> std::hex;
    cases.emplace_back();
    for (std::uint64_t word; words >> word;) cases.back().push_back(word);
  }
  return cases;
}

}  // namespace

int main() {
  const std::vector<std::vector<std::uint64_t>> cases = cases_of_input();
  VPixel model;
  std::uint64_t* const ports[] = {HS_PIXEL_PORTS(model)};
  const auto tick = [&] {
    model.clock = 0;
    model.eval();
    model.clock = 1;
    model.eval();
  };
  model.start_port = 0;
  model.reset = 0;
  for (int i = 0; i < 4; ++i) tick();
  model.reset = 1;
  tick();

  const std::size_t most = cases.size() + 100;
  std::size_t cycle = 0, done = 0, wrong = 0, latency = 0;
  for (; cycle < most && done < cases.size(); ++cycle) {
    model.start_port = cycle < cases.size();
    if (model.start_port) {
      std::size_t n = 0;
      for (std::uint64_t* port : ports) *port = cases[cycle].at(++n);
    }
    model.clock = 0;
    model.eval();
    if (model.done_port) {
      if (done == 0) latency = cycle;
      const std::uint64_t expected = cases[done][0], got = model.return_port;
      if (got != expected && ++wrong <= 5) {
        std::printf("case %zu: %" PRIx64 ", expected %" PRIx64 "\n", done, got, expected);
      }
      ++done;
    }
    model.clock = 1;
    model.eval();
  }
  std::printf("%zu of %zu cases in %zu cycles, %zu wrong, latency %zu\n", done, cases.size(), cycle, wrong, latency);
  return done == cases.size() && done > 0 && wrong == 0 && cycle == done + latency ? 0 : 1;
}
