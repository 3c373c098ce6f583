// SPDX-License-Identifier: Apache-2.0
// The order of a film: which pass a frame of triangles is, when it may come, and what is shown.
//
//   K0 | K1, B1 … Bn | K2, B1 … Bn | …    n = hs_formats_pkg::FramesBetween
//
// K is a pass of a key frame, which takes the slots of the two key memories in turn; B one of a
// frame in between, and after it, if geometry was asked for faces, a pass that fills the holes. A
// pass is over when its last pixel is stored and the last word of `asked` is taken, and then
// triangles of the next one are let in. Shown are K0, and of an interval each B and then the second
// key; a frame is shown while the next pass is drawn.
// A film begins at reset.
module hs_up_convert_control #(
  localparam int unsigned KeyWeightBits = hs_formats_pkg::KeyWeightBits
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,

  output logic                     open_o,  // triangles may be taken
  output logic                     busy_o,  // a pass is under way, or a frame waits to be shown

  // Words that move in this cycle
  input  logic                     triangle_i,
  input  logic                     triangle_last_i,
  input  logic                     shown_last_i,
  input  logic                     asked_i,
  input  logic                     asked_last_i,
  input  logic                     asked_any_i,  // its face is not 0

  // The pass
  output logic                     begins_o,  // K0: no frame was shown yet
  output logic                     between_o,
  output logic                     fill_o,
  output logic                     slot_o,  // of the key that is drawn; of key 0 of the interval
  output logic [KeyWeightBits-1:0] key_weight_o,  // of key 0

  // To film_scan: {source, slot}, source 0 is a key frame
  output logic                     show_valid_o,
  input  logic                     show_ready_i,
  output logic [1:0]               show_o
);
  localparam int unsigned Fields = hs_formats_pkg::FramesBetween;
  localparam int unsigned FieldBits = $clog2(Fields + 1);
  localparam int unsigned Ways = Fields + 1;
  localparam int unsigned One = 1 << (KeyWeightBits - 1);

  logic begins_q, between_q, fill_q, slot_q, closed_q;
  logic [FieldBits-1:0] field_q;  // 1 … Fields in an interval, 0 of a key frame
  logic ends, film_ends, interval_ends;

  assign open_o = !closed_q;
  assign begins_o = begins_q;
  assign between_o = between_q;
  assign fill_o = fill_q;
  assign slot_o = slot_q;

  // --- The weight of key 0 at field of Ways: 1 − field/Ways, rounded ---
  always_comb begin
    key_weight_o = '0;
    for (int unsigned i = 1; i <= Fields; i++) begin
      if (field_q == FieldBits'(i)) begin
        key_weight_o = KeyWeightBits'(((Ways - i) * 2 * One + Ways) / (2 * Ways));
      end
    end
  end

  // --- Passes ---
  assign ends = between_q ? asked_i && asked_last_i : shown_last_i;
  // The frame in between is whole.
  assign film_ends = ends && (fill_q || (between_q && !asked_any_i));
  assign interval_ends = film_ends && field_q == FieldBits'(Fields);

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      begins_q <= 1'b1;
      between_q <= 1'b0;
      fill_q <= 1'b0;
      slot_q <= 1'b0;
      field_q <= '0;
      closed_q <= 1'b0;
    end else begin
      if (triangle_i && triangle_last_i) closed_q <= 1'b1;
      if (ends) begin
        closed_q <= 1'b0;
        begins_q <= 1'b0;
        between_q <= interval_ends ? 1'b0 : film_ends || !(begins_q || between_q);
        fill_q <= between_q && !film_ends;
        if (interval_ends) field_q <= '0;
        else if (film_ends || !(begins_q || between_q || fill_q)) begin
          field_q <= field_q + FieldBits'(1);
        end
        // The second key of an interval is the first one of the next; the slot of the older one is
        // drawn into.
        if (field_q == '0) slot_q <= !slot_q;
      end
    end
  end

  // --- What is shown: at most the last frame in between of an interval, and its second key ---
  logic [1:0] shows_q;  // waiting
  logic [3:0] show_q;
  logic show;

  assign show_valid_o = shows_q != 2'd0;
  assign show_o = show_q[1:0];
  assign show = show_valid_o && show_ready_i;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      shows_q <= 2'd0;
    end else if (interval_ends) begin
      shows_q <= 2'd2;
    end else if (film_ends || (ends && begins_q)) begin
      shows_q <= 2'd1;
    end else if (show) begin
      shows_q <= shows_q - 2'd1;
    end
  end

  always_ff @(posedge clk_i) begin
    if (film_ends) show_q <= {1'b0, !slot_q, 1'b1, 1'b0};
    else if (ends && begins_q) show_q <= {2'b00, 1'b0, slot_q};
    else if (show) show_q <= {2'b00, show_q[3:2]};
    if (rst_ni) assert (!(film_ends || (ends && begins_q)) || shows_q == 2'd0);
  end

  assign busy_o = closed_q || show_valid_o;
endmodule
