// SPDX-License-Identifier: Apache-2.0
// Start and end of hs_system: what runs, and how it is given up.
//
//   Idle ─start─► Launch ─► Run ─done─► Idle
//                            └─stop, error─► Drain ─the bus has ended─► Idle
//
// While it drains the pipeline and all that feeds it are in reset (core_rst_no), and the masters of
// the bus end what they began (flush_o). A frame that was given up leaves nothing behind: the next
// start is as the first one after the reset, which clears the I-buffer.
module hs_system_control #(
  parameter int unsigned IdBits = 4
) (
  input  logic       clk_i,
  input  logic       rst_ni,

  input  logic       start_i,
  input  logic       stop_i,
  input  logic       frame_wrong_i,
  output logic       started_o,  // for a cycle; a cycle later
  output logic       launch_o,
  output logic       busy_o,
  output logic       done_o,
  output logic       stopped_o,
  output logic       error_o,
  output logic [1:0] error_kind_o,
  output logic [3:0] error_client_o,

  output logic       core_rst_no,
  output logic       flush_o,
  input  logic       bus_idle_i,
  input  logic       list_active_i,
  input  logic       core_idle_i,

  input  logic              command_error_i,
  input  logic              read_error_i,
  input  logic [IdBits-1:0] read_client_i,
  input  logic              write_error_i,
  input  logic [IdBits-1:0] write_client_i
);
  localparam logic [1:0] CommandError = 2'd0;
  localparam logic [1:0] ReadError = 2'd1;
  localparam logic [1:0] WriteError = 2'd2;
  localparam int unsigned ResetCycles = 4;

  typedef enum logic [1:0] {Idle, Launch, Run, Drain} state_t;
  state_t state_q;
  logic core_rst_nq, wrong, stops, given_up;
  logic [2:0] reset_q;  // cycles of it

  assign started_o = start_i && state_q == Idle;
  assign launch_o = state_q == Launch && !given_up;
  assign busy_o = state_q != Idle;
  assign wrong = (state_q == Launch && frame_wrong_i)
                 || (state_q == Run && (command_error_i || read_error_i || write_error_i));
  assign stops = stop_i && (state_q == Launch || state_q == Run);
  assign given_up = wrong || stops;
  assign error_o = wrong;
  assign stopped_o = stops && !wrong;
  assign done_o = state_q == Run && !given_up && !list_active_i && core_idle_i && bus_idle_i;
  assign error_kind_o = state_q == Launch ? CommandError : read_error_i ? ReadError
                        : write_error_i ? WriteError : CommandError;
  assign error_client_o = state_q == Launch ? '0 : read_error_i ? 4'(read_client_i)
                          : write_error_i ? 4'(write_client_i) : '0;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q <= Idle;
      core_rst_nq <= 1'b0;
      reset_q <= '0;
    end else begin
      case (state_q)
        Idle: if (start_i) state_q <= Launch;
        Launch: state_q <= given_up ? Drain : Run;
        Run: begin
          if (given_up) state_q <= Drain;
          else if (done_o) state_q <= Idle;
        end
        default: if (reset_q == 3'(ResetCycles) && bus_idle_i) state_q <= Idle;  // Drain
      endcase
      core_rst_nq <= !given_up && state_q != Drain;
      if (state_q != Drain) reset_q <= '0;
      else if (reset_q != 3'(ResetCycles)) reset_q <= reset_q + 3'd1;
    end
  end

  assign core_rst_no = core_rst_nq;
  assign flush_o = state_q == Drain;
endmodule
