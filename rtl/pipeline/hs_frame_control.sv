// SPDX-License-Identifier: Apache-2.0
// The frames of hs_pipeline: at most two are in flight, one being drawn and one being scanned out.
//
// After reset, two passes of scan_index clear the banks of the I-buffer; triangles wait for that. A
// frame is scanned out when its last `visible` was taken and all that it is shaded with is stored;
// it is in flight until its last `pixel` is taken. No triangle of a third frame is let in. Banks
// take turns.
module hs_frame_control (
  input  logic clk_i,
  input  logic rst_ni,

  output logic open_o,  // triangles may be taken
  output logic busy_o,  // clearing, or a frame in flight: the frame registers must not change

  // Words that move in this cycle
  input  logic triangle_i,
  input  logic triangle_last_i,
  input  logic visible_last_i,
  input  logic planes_last_i,  // the end of a frame's `planes`
  input  logic stored_last_i,  // that, or of what is stored later
  input  logic pixel_last_i,

  // To scan_index
  output logic start_valid_o,
  input  logic start_ready_i,
  output logic start_clear_o,

  output logic scan_bank_o,   // of the I-buffer, for scan_index
  output logic planes_bank_o  // of TdbS, to store to
);
  logic [1:0] to_clear_q;                // banks
  logic cleared_q, entering_q;           // entering: a frame is let in but for its last triangle
  logic [1:0] frames_q, drawn_q, stored_q;  // let in; drawn, stored but not started to be scanned
  logic scan_bank_q, planes_bank_q, start, start_frame;

  assign open_o = cleared_q && frames_q != 2'd2;
  assign busy_o = !cleared_q || entering_q || frames_q != 2'd0;

  assign start_clear_o = to_clear_q != 2'd0;
  assign start_valid_o = start_clear_o || (cleared_q && drawn_q != 2'd0 && stored_q != 2'd0);
  assign start = start_valid_o && start_ready_i;
  assign start_frame = start && !start_clear_o;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      to_clear_q <= 2'd2;
      cleared_q <= 1'b0;
      entering_q <= 1'b0;
      frames_q <= 2'd0;
      drawn_q <= 2'd0;
      stored_q <= 2'd0;
      scan_bank_q <= 1'b1;
      planes_bank_q <= 1'b0;
    end else begin
      if (start && start_clear_o) to_clear_q <= to_clear_q - 2'd1;
      if (to_clear_q == 2'd0 && start_ready_i) cleared_q <= 1'b1;
      if (triangle_i) entering_q <= !triangle_last_i;
      frames_q <= frames_q + 2'(triangle_i && triangle_last_i) - 2'(pixel_last_i);
      drawn_q <= drawn_q + 2'(visible_last_i) - 2'(start_frame);
      stored_q <= stored_q + 2'(stored_last_i) - 2'(start_frame);
      if (start) scan_bank_q <= !scan_bank_q;
      if (planes_last_i) planes_bank_q <= !planes_bank_q;
    end
  end

  assign scan_bank_o = scan_bank_q;
  assign planes_bank_o = planes_bank_q;
endmodule
