// SPDX-License-Identifier: Apache-2.0
// What is answered to `visible`, from a table in memory: normals, texture coordinates, or both.
//
// An entry is the words of `normals` and then those of `texture_coordinates`, each without `last`
// and `index`, which are those of `visible`; each from bit 0 of a 64-bit word on. A triangle's
// entry is that of its place in the frame, the first one at the address of `table`. It is read if
// the triangle is visible.
// As many answers as hs_fetch takes are under way; when it takes no more, `visible` waits.
module hs_answers #(
  parameter int unsigned WordsBits,
  localparam int unsigned AddressBits = hs_memory_pkg::AddressBits,
  localparam int unsigned NormalsWordBits = hs_formats_pkg::NormalsWordBits,
  localparam int unsigned CoordinatesWordBits = hs_formats_pkg::TextureCoordinatesWordBits
) (
  input  logic                           clk_i,
  input  logic                           rst_ni,

  input  logic                           table_valid_i,
  input  logic [AddressBits-1:0]         table_i,

  input  logic                           visible_valid_i,
  output logic                           visible_ready_o,
  input  hs_formats_pkg::visible_t       visible_i,

  // To hs_fetch
  output logic                           fetch_valid_o,
  input  logic                           fetch_ready_i,
  output logic [AddressBits-1:0]         fetch_address_o,
  output logic [WordsBits-1:0]           fetch_words_o,
  input  logic                           word_valid_i,
  output logic                           word_ready_o,
  input  logic [63:0]                    word_i,

  output logic                           normals_valid_o,
  input  logic                           normals_ready_i,
  output logic [NormalsWordBits-1:0]     normals_o,
  output logic                           texture_coordinates_valid_o,
  input  logic                           texture_coordinates_ready_i,
  output logic [CoordinatesWordBits-1:0] texture_coordinates_o
);
  localparam int unsigned HeadBits = 1 + hs_formats_pkg::IndexBits;
  localparam int unsigned HasNormals = hs_formats_pkg::Lights != 0 ? 1 : 0;
  localparam int unsigned HasCoordinates = hs_formats_pkg::HasTexture;
  localparam int unsigned NormalsBits = HasNormals != 0 ? NormalsWordBits - HeadBits : 1;
  localparam int unsigned CoordinatesBits =
      HasCoordinates != 0 ? CoordinatesWordBits - HeadBits : 1;
  localparam int unsigned NormalsWords = HasNormals * ((NormalsBits + 63) / 64);
  localparam int unsigned CoordinatesWords = HasCoordinates * ((CoordinatesBits + 63) / 64);
  localparam int unsigned Words = NormalsWords + CoordinatesWords;
  localparam int unsigned HaveBits = $clog2(Words + 1);

  // --- the entry of the next triangle ---
  logic [AddressBits-1:0] table_q, entry_q;
  logic visible, head_ready;

  assign visible = visible_valid_i && visible_i.visible;
  assign visible_ready_o = !visible_i.visible || (fetch_ready_i && head_ready);
  assign fetch_valid_o = visible && head_ready;
  assign fetch_address_o = entry_q;
  assign fetch_words_o = WordsBits'(Words);

  always_ff @(posedge clk_i) begin
    if (table_valid_i) begin
      table_q <= table_i;
      entry_q <= table_i;
    end else if (visible_valid_i && visible_ready_o) begin
      entry_q <= visible_i.last ? table_q : entry_q + AddressBits'(8 * Words);
    end
  end

  // --- whose answers are under way ---
  logic head_valid, entry_taken;
  logic [HeadBits-1:0] head;

  hs_fifo #(
    .Width(HeadBits),
    .Depth(16)
  ) u_heads_fifo (
    .clk_i      (clk_i),
    .rst_ni     (rst_ni),
    .in_valid_i (visible && fetch_ready_i),
    .in_ready_o (head_ready),
    .in_i       ({visible_i.last, visible_i.index}),
    .out_valid_o(head_valid),
    .out_ready_i(entry_taken),
    .out_o      (head)
  );

  // --- an entry from its words: the one that came last is the uppermost ---
  logic [64*Words-1:0] record_q;
  logic [HaveBits-1:0] have_q;
  logic whole, normals_taken_q, coordinates_taken_q, normals_done, coordinates_done;

  assign whole = head_valid && have_q == HaveBits'(Words);
  assign word_ready_o = have_q != HaveBits'(Words);
  assign normals_done = HasNormals == 0 || normals_taken_q || normals_ready_i;
  assign coordinates_done =
      HasCoordinates == 0 || coordinates_taken_q || texture_coordinates_ready_i;
  assign entry_taken = whole && normals_done && coordinates_done;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      have_q <= '0;
      normals_taken_q <= 1'b0;
      coordinates_taken_q <= 1'b0;
    end else begin
      if (entry_taken) have_q <= '0;
      else if (word_valid_i && word_ready_o) have_q <= have_q + HaveBits'(1);
      normals_taken_q <= whole && normals_done && !entry_taken;
      coordinates_taken_q <= whole && coordinates_done && !entry_taken;
    end
  end

  always_ff @(posedge clk_i) begin
    if (word_valid_i && word_ready_o) record_q <= (64*Words)'({word_i, record_q} >> 64);
  end

  logic unused_record, unused_ready;
  assign unused_record = ^{record_q, head};
  assign unused_ready = ^{normals_ready_i, texture_coordinates_ready_i};

  if (HasNormals != 0) begin : gen_normals
    assign normals_valid_o = whole && !normals_taken_q;
    assign normals_o = {head, record_q[NormalsBits-1:0]};
  end else begin : gen_no_normals
    assign normals_valid_o = 1'b0;
    assign normals_o = '0;
  end
  if (HasCoordinates != 0) begin : gen_coordinates
    assign texture_coordinates_valid_o = whole && !coordinates_taken_q;
    assign texture_coordinates_o = {head, record_q[64*NormalsWords +: CoordinatesBits]};
  end else begin : gen_no_coordinates
    assign texture_coordinates_valid_o = 1'b0;
    assign texture_coordinates_o = '0;
  end
endmodule
