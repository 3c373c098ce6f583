// SPDX-License-Identifier: Apache-2.0
// hs_ztest_index decides at any one pixel as if stamps came one after the other, each after the writes of those before:
// what is on its way is forwarded, and nothing else. `at` and `bank` are any address and bank, the same for ever; the
// other words of the buffers are whatever they are. At most two frames are in flight, and a bank is cleared between the
// frames that use it. One lane, of the configuration micro.
// unit hs_ztest_index LanesX=1 LanesY=1
// cycles 14
module harness(input clk, input rst_free, input stamp_valid, input [14:0] stamp, input visible_ready, input [3:0] at_free,
               input bank_free, input [2:0] index_free, input [2:0] depth_free, output bad);
  // stamp: last, triangle_last, index, x, y, mask, depth
  wire last = stamp[14];
  wire [2:0] index = stamp[12:10], depth = stamp[2:0];
  wire [3:0] address = {1'b0, stamp[9:7]} + {stamp[5:4], 2'b00};
  wire mask = stamp[3];

  reg began = 0, bank = 0;
  reg [3:0] at = 0;
  wire rst_ni = began && rst_free;
  wire go, visible_valid, read_en, read_bank, write_en, write_bank;
  wire [3:0] read_address, write_address;
  wire [2:0] write_index, write_depth;
  wire [4:0] visible;  // last, visible, index
  reg [2:0] read_index = 0, read_depth = 0, stored_index = 0, stored_depth = 0;
  unit u_unit (.clk_i(clk), .rst_ni(rst_ni), .stamp_valid_i(stamp_valid), .stamp_ready_o(go), .stamp_i(stamp),
               .visible_valid_o(visible_valid), .visible_ready_i(visible_ready), .visible_o(visible),
               .read_en_o(read_en), .read_bank_o(read_bank), .read_address_o(read_address),
               .read_index_i(read_index), .read_depth_i(read_depth), .write_en_o(write_en),
               .write_bank_o(write_bank), .write_address_o(write_address), .write_index_o(write_index),
               .write_depth_o(write_depth));

  // The frames: that of the next stamp, that of the next `visible`, how many are in flight.
  reg next_bank = 0, visible_bank = 0, illegal = 0;
  reg [1:0] frames = 0;
  wire take = stamp_valid && go;
  wire ends = take && last;
  wire seen = visible_valid && visible_ready && visible[4];
  wire legal = !take || ((index != 0 || !mask) && frames != 2 && (!last || stamp[13]));

  // What the pixel holds by the rule; what is decided, beside the stages read, test and write.
  reg [2:0] spec_index = 0, spec_depth = 0;
  reg [7:0] read_q = 0, test_q = 0, write_q = 0;  // meets, passes, index, depth
  wire meets = take && next_bank == bank && address == at;
  wire passes = meets && mask && depth < (spec_index == 0 ? 3'd7 : spec_depth);

  assign bad = rst_ni && legal && !illegal && go && write_q[7]
               && (write_en != write_q[6] || (write_q[6] && {write_index, write_depth} != write_q[5:0]));

  always @(posedge clk) begin
    began <= 1;
    if (!began) {at, bank} <= {at_free, bank_free};
    illegal <= rst_ni && (illegal || !legal);

    if (read_en) begin
      if (read_bank == bank && read_address == at) read_index <= stored_index;
      else read_index <= index_free;
      if (read_address == at) read_depth <= stored_depth;
      else read_depth <= depth_free;
    end
    if (write_en && write_address == at) begin
      stored_depth <= write_depth;
      if (write_bank == bank) stored_index <= write_index;
    end
    if (seen && visible_bank == bank) stored_index <= 0;

    if (passes) {spec_index, spec_depth} <= {index, depth};
    if (ends && next_bank != bank) spec_index <= 0;
    if (go) {read_q, test_q, write_q} <= {meets, passes, index, depth, read_q, test_q};

    next_bank <= next_bank ^ ends;
    visible_bank <= visible_bank ^ seen;
    frames <= frames + ends - seen;
    if (!rst_ni) begin
      {next_bank, visible_bank, frames, spec_index, stored_index} <= 0;
      {read_q, test_q, write_q} <= 0;
    end
  end
endmodule
