// SPDX-License-Identifier: Apache-2.0
// hs_board on the iCE40-HX8K breakout board, with video at the pins of a header: for a DVI chip as
// that of the iCEBreaker's PMOD, or three resistor ladders of a VGA plug. Pins: hx8k.pcf.
//
// 12 MHz in; 12·67/32 = 25.125 MHz the pixel clock, and half of that, in phase, for the pipeline.
// The pins change with the rising edge of the pixel clock, and what is connected takes them with
// that of dvi_clk, half a cycle later. The button is 0 when pressed.
module hx8k #(
  parameter int unsigned Entries = 256,
  parameter int unsigned Repeats = 2,
  parameter int unsigned Background = 0,
  parameter File = "lists.hex"
) (
  input  logic       clk_12mhz,
  input  logic       btn_n,
  output logic       dvi_clk,
  output logic       dvi_hsync,
  output logic       dvi_vsync,
  output logic       dvi_de,
  output logic [3:0] dvi_r,
  output logic [3:0] dvi_g,
  output logic [3:0] dvi_b
);
  logic clk_pixel, clk_half, locked;

  SB_PLL40_2F_CORE #(
    .FEEDBACK_PATH      ("SIMPLE"),
    .DIVR               (4'b0000),
    .DIVF               (7'b1000010),
    .DIVQ               (3'b101),
    .FILTER_RANGE       (3'b001),
    .PLLOUT_SELECT_PORTA("GENCLK"),
    .PLLOUT_SELECT_PORTB("GENCLK_HALF")
  ) u_pll (
    .REFERENCECLK (clk_12mhz),
    .PLLOUTGLOBALA(clk_pixel),
    .PLLOUTGLOBALB(clk_half),
    .LOCK         (locked),
    .BYPASS       (1'b0),
    .RESETB       (1'b1)
  );

  logic hsync, vsync, enable;
  logic [3:0] red, green, blue;

  hs_board #(
    .Entries   (Entries),
    .Repeats   (Repeats),
    .Background(Background),
    .File      (File)
  ) u_board (
    .clk_i   (clk_half),
    .fast_i  (clk_pixel),
    .locked_i(locked),
    .button_i(!btn_n),
    .hsync_o (hsync),
    .vsync_o (vsync),
    .enable_o(enable),
    .red_o   (red),
    .green_o (green),
    .blue_o  (blue)
  );

  // Registers in the pads, so that all pins change at the same time.
  logic [14:0] pins;
  assign {dvi_hsync, dvi_vsync, dvi_de, dvi_r, dvi_g, dvi_b} = pins;
  logic [14:0] values;
  assign values = {hsync, vsync, enable, red, green, blue};

  for (genvar i = 0; i < 15; i++) begin : gen_pin
    SB_IO #(
      .PIN_TYPE(6'b010100)  // no input, output from a register
    ) u_io (
      .PACKAGE_PIN(pins[i]),
      .OUTPUT_CLK (clk_pixel),
      .D_OUT_0    (values[i])
    );
  end

  SB_IO #(
    .PIN_TYPE(6'b010000)  // no input, output at both edges
  ) u_clk (
    .PACKAGE_PIN(dvi_clk),
    .OUTPUT_CLK (clk_pixel),
    .D_OUT_0    (1'b0),
    .D_OUT_1    (1'b1)
  );
endmodule
