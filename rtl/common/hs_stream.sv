// SPDX-License-Identifier: Apache-2.0
// A stream between two units, by name: wires alone, and no cell is left of it when it is flattened.
//
// Each stream of the composition passes one, and its instance is u_stream_<name>, the name being
// that of the table of streams (docs/architecture.md). So the stream has this name in a waveform
// and in a netlist. The benches watch it by that name from outside (tb/watch.vlt), so that no port
// of the product is there to be watched alone.
// A stream that never waits has ready_i 1. A probe, whose word nobody takes, is marked (* keep *),
// or Yosys drops it.
module hs_stream #(
  parameter int unsigned Width
) (
  input  logic             valid_i,
  output logic             ready_o,
  input  logic [Width-1:0] word_i,

  output logic             valid_o,
  input  logic             ready_i,
  output logic [Width-1:0] word_o
);
  assign valid_o = valid_i;
  assign ready_o = ready_i;
  assign word_o = word_i;
endmodule
