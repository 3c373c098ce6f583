// SPDX-License-Identifier: Apache-2.0
// The Z-test with an index buffer: Z-buffer and I-buffer are tested and updated together, and a
// triangle is reported visible when a fragment of it passed (kernel: hls/ztest/ztest_index.hpp).
// Without depth the first fragment of a pixel passes; the ports of the Z-buffer are one bit then, 0
// and not looked at.
//
// Interval: a stamp a cycle, whatever the addresses. Latency: 3 cycles from a stamp to its write,
// 4 to `visible`. Stages: address | read | test | write. What is being written while a stamp is
// read or tested is forwarded to its test, by lanes.
// Stall: everything stops while a `visible` is not taken and the next one is due.
// Buffers: a read takes one cycle, its word stays until the next read, and a read of the word that
// is being written gives the old one. The I-buffer has two banks, used in turn by the frames, the
// first one by the first frame after reset; a bank is all 0 when its frame begins.
// Illegal: index 0 with a covered pixel.
module hs_ztest_index #(
  parameter int unsigned LanesX = 2,
  parameter int unsigned LanesY = 2,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned XBits = hs_formats_pkg::XBits,
  localparam int unsigned YBits = hs_formats_pkg::YBits,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned HasDepth = hs_formats_pkg::HasDepth,
  localparam int unsigned DepthBits = hs_formats_pkg::DepthBits,
  localparam int unsigned DepthsBits = HasDepth != 0 ? Lanes * DepthBits : 1,
  localparam int unsigned StampBits = 2 + IndexBits + XBits + YBits + Lanes * (1 + DepthBits),
  localparam int unsigned UpdateBits = IndexBits + XBits + YBits + Lanes * (1 + DepthBits),
  localparam int unsigned StampsX = (hs_formats_pkg::MaxWidth + LanesX - 1) / LanesX,
  localparam int unsigned StampsY = (hs_formats_pkg::MaxHeight + LanesY - 1) / LanesY,
  localparam int unsigned AddressBits = StampsX * StampsY > 1 ? $clog2(StampsX * StampsY) : 1
) (
  input  logic                       clk_i,
  input  logic                       rst_ni,

  // From raster_pineda
  input  logic                       stamp_valid_i,
  output logic                       stamp_ready_o,
  input  logic [StampBits-1:0]       stamp_i,

  // To geometry
  output logic                       visible_valid_o,
  input  logic                       visible_ready_i,
  output hs_formats_pkg::visible_t   visible_o,

  // To watch: the writes
  output logic                       update_valid_o,
  output logic [UpdateBits-1:0]      update_o,

  // I-buffer and Z-buffer
  output logic                       read_en_o,
  output logic                       read_bank_o,  // of the I-buffer
  output logic [AddressBits-1:0]     read_address_o,
  input  logic [Lanes*IndexBits-1:0] read_index_i,
  input  logic [DepthsBits-1:0]      read_depth_i,
  output logic [Lanes-1:0]           write_en_o,
  output logic                       write_bank_o,
  output logic [AddressBits-1:0]     write_address_o,
  output hs_formats_pkg::index_t     write_index_o,  // in each lane that is written
  output logic [DepthsBits-1:0]      write_depth_o
);
  localparam int unsigned HeadBits = 2 + IndexBits + XBits + YBits;

  logic go;  // all stages move

  // Stage address.
  hs_formats_pkg::stamp_head_t stamp_head;
  logic [Lanes-1:0] stamp_mask;
  logic [AddressBits-1:0] stamp_address;
  logic bank_q;

  // Stages read, test and write: the stamp; and what has been written in the cycle before.
  logic read_valid_q, test_valid_q, write_valid_q;
  hs_formats_pkg::stamp_head_t read_head_q, test_head_q, write_head_q;
  logic [Lanes-1:0] read_mask_q, test_mask_q, pass_d, pass_q, done_pass_q;
  logic [Lanes-1:0] first, nearer;  // in test: nothing is stored at the pixel; less than what is
  logic [AddressBits-1:0] read_address_q, test_address_q, write_address_q;
  logic read_bank_q, test_bank_q, write_bank_q;
  logic near_hit_q, far_hit_q;  // the stamp in test has the address of the one before, before that
  logic visible_valid_q, any_q, triangle_done;
  hs_formats_pkg::visible_t visible_q;
  hs_formats_pkg::update_head_t update_head;

  assign stamp_head = stamp_i[StampBits-1-:HeadBits];
  assign stamp_mask = stamp_i[StampBits-HeadBits-1-:Lanes];
  assign stamp_ready_o = go;

  // y·StampsX + x, by shifts, as StampsX has two to four ones.
  always_comb begin
    stamp_address = AddressBits'(stamp_head.x);
    for (int unsigned i = 0; i < $clog2(StampsX + 1); i++) begin
      if (((StampsX >> i) & 1) != 0) begin
        stamp_address = stamp_address + (AddressBits'(stamp_head.y) << i);
      end
    end
  end

  assign read_en_o = go && read_valid_q;
  assign read_bank_o = read_bank_q;
  assign read_address_o = read_address_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      bank_q <= 1'b0;
      read_valid_q <= 1'b0;
      test_valid_q <= 1'b0;
      write_valid_q <= 1'b0;
    end else if (go) begin
      if (stamp_valid_i && stamp_head.last) bank_q <= !bank_q;
      read_valid_q <= stamp_valid_i;
      test_valid_q <= read_valid_q;
      write_valid_q <= test_valid_q;
    end
  end

  always_ff @(posedge clk_i) begin
    if (go) begin
      read_head_q <= stamp_head;
      read_mask_q <= stamp_mask;
      read_address_q <= stamp_address;
      read_bank_q <= bank_q;

      test_head_q <= read_head_q;
      test_mask_q <= read_mask_q;
      test_address_q <= read_address_q;
      test_bank_q <= read_bank_q;
      near_hit_q <= test_valid_q && read_address_q == test_address_q && read_bank_q == test_bank_q;
      far_hit_q <= write_valid_q && read_address_q == write_address_q &&
                   read_bank_q == write_bank_q;

      write_head_q <= test_head_q;
      write_address_q <= test_address_q;
      write_bank_q <= test_bank_q;
      pass_q <= pass_d;

      done_pass_q <= pass_q;
    end
  end

  for (genvar lane = 0; lane < Lanes; lane++) begin : gen_lane
    assign first[lane] = !(near_hit_q && pass_q[lane]) && !(far_hit_q && done_pass_q[lane])
                         && read_index_i[lane*IndexBits +: IndexBits] == '0;
  end
  assign pass_d = test_mask_q & nearer;

  if (HasDepth != 0) begin : gen_depth
    hs_ztest_depth #(
      .DepthBits(DepthBits),
      .Lanes    (Lanes)
    ) u_depth (
      .clk_i        (clk_i),
      .go_i         (go),
      .near_i       (pass_q & {Lanes{near_hit_q}}),
      .far_i        (done_pass_q & {Lanes{far_hit_q}}),
      .first_i      (first),
      .stamp_depth_i(stamp_i[Lanes*DepthBits-1:0]),
      .read_depth_i (read_depth_i),
      .nearer_o     (nearer),
      .write_depth_o(write_depth_o)
    );
    assign update_o = {update_head, pass_q, write_depth_o};
  end else begin : gen_no_depth
    logic unused_read_depth;
    assign unused_read_depth = read_depth_i;
    assign nearer = first;
    assign write_depth_o = 1'b0;
    assign update_o = {update_head, pass_q};
  end

  // Stage write.
  assign write_en_o = write_valid_q && go ? pass_q : '0;
  assign write_bank_o = write_bank_q;
  assign write_address_o = write_address_q;
  assign write_index_o = write_head_q.index;

  assign update_head.index = write_head_q.index;
  assign update_head.x = write_head_q.x;
  assign update_head.y = write_head_q.y;
  assign update_valid_o = |write_en_o;

  assign triangle_done = write_valid_q && write_head_q.triangle_last;
  assign go = !triangle_done || !visible_valid_q || visible_ready_i;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      any_q <= 1'b0;
      visible_valid_q <= 1'b0;
    end else begin
      if (triangle_done && go) visible_valid_q <= 1'b1;
      else if (visible_ready_i) visible_valid_q <= 1'b0;
      if (write_valid_q && go) any_q <= !triangle_done && (any_q || |pass_q);
    end
  end

  always_ff @(posedge clk_i) begin
    if (triangle_done && go) begin
      visible_q.last <= write_head_q.last;
      visible_q.visible <= any_q || |pass_q;
      visible_q.index <= write_head_q.index;
    end
  end

  assign visible_valid_o = visible_valid_q;
  assign visible_o = visible_q;
endmodule
