// SPDX-License-Identifier: Apache-2.0
// What of an iCE40 stands between the pins and the logic, for simulation; the rest, in a netlist, is
// Yosys' ice40/cells_sim.v, which has no PLL.

// Pads as the boards use them: an output from a register, or at both edges of its clock.
module SB_IO #(
  parameter [5:0] PIN_TYPE = 6'b000000,
  parameter [0:0] PULLUP = 1'b0,
  parameter [0:0] NEG_TRIGGER = 1'b0,
  parameter IO_STANDARD = "SB_LVCMOS"
) (
  inout  PACKAGE_PIN,
  input  LATCH_INPUT_VALUE,
  input  CLOCK_ENABLE,
  input  INPUT_CLK,
  input  OUTPUT_CLK,
  input  OUTPUT_ENABLE,
  input  D_OUT_0,
  input  D_OUT_1,
  output D_IN_0,
  output D_IN_1
);
  reg rising, falling;

  always @(posedge OUTPUT_CLK) rising <= D_OUT_0;
  always @(negedge OUTPUT_CLK) falling <= D_OUT_1;

  assign PACKAGE_PIN = PIN_TYPE[3:2] == 2'b00 && !OUTPUT_CLK ? falling : rising;
  assign D_IN_0 = 1'b0;
  assign D_IN_1 = 1'b0;
endmodule

// Takes two cycles at its pin for one of PLLOUTGLOBALA, and four for one of PLLOUTGLOBALB; the two
// rise in the same moment. Locks after 16 cycles.
module SB_PLL40_2F_PAD #(
  parameter FEEDBACK_PATH = "SIMPLE",
  parameter PLLOUT_SELECT_PORTA = "GENCLK",
  parameter PLLOUT_SELECT_PORTB = "GENCLK",
  parameter [3:0] DIVR = 4'd0,
  parameter [6:0] DIVF = 7'd0,
  parameter [2:0] DIVQ = 3'd0,
  parameter [2:0] FILTER_RANGE = 3'd0
) (
  input  PACKAGEPIN,
  input  BYPASS,
  input  RESETB,
  output PLLOUTGLOBALA,
  output PLLOUTGLOBALB,
  output LOCK
);
  reg [5:0] count = 6'd0;
  reg fast = 1'b0;
  reg half = 1'b0;

  always @(posedge PACKAGEPIN) begin
    if (!count[5]) count <= count + 6'd1;
    fast <= !fast;
    if (!fast) half <= !half;
  end

  assign PLLOUTGLOBALA = fast;
  assign PLLOUTGLOBALB = half;
  assign LOCK = count[5];
endmodule

// The same with its input from the logic.
module SB_PLL40_2F_CORE #(
  parameter FEEDBACK_PATH = "SIMPLE",
  parameter PLLOUT_SELECT_PORTA = "GENCLK",
  parameter PLLOUT_SELECT_PORTB = "GENCLK",
  parameter [3:0] DIVR = 4'd0,
  parameter [6:0] DIVF = 7'd0,
  parameter [2:0] DIVQ = 3'd0,
  parameter [2:0] FILTER_RANGE = 3'd0
) (
  input  REFERENCECLK,
  input  BYPASS,
  input  RESETB,
  output PLLOUTGLOBALA,
  output PLLOUTGLOBALB,
  output LOCK
);
  SB_PLL40_2F_PAD u_pll (
    .PACKAGEPIN   (REFERENCECLK),
    .BYPASS       (BYPASS),
    .RESETB       (RESETB),
    .PLLOUTGLOBALA(PLLOUTGLOBALA),
    .PLLOUTGLOBALB(PLLOUTGLOBALB),
    .LOCK         (LOCK)
  );
endmodule
