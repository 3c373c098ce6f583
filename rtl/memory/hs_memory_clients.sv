// SPDX-License-Identifier: Apache-2.0
// The clients of hs_pipeline side by side, as hs_memory_pkg numbers them; and when a frame is
// drawn: its last `visible` was taken and, outside, its tiles are in memory.
//
// memory_o, memory_i as in hs_frame_memory, of all clients; without any they are 0 and not looked
// at.
module hs_memory_clients #(
  parameter int unsigned OutsideFrame,
  parameter int unsigned OutsidePlanes,
  parameter int unsigned MemoryBits,
  parameter int unsigned FrameOutBits,
  parameter int unsigned FrameInBits,
  parameter int unsigned PlanesOutBits,
  parameter int unsigned PlanesInBits,
  parameter int unsigned OutBits,
  parameter int unsigned InBits
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,

  input  logic                     visible_last_i,
  input  logic                     frame_stored_i,
  output logic                     drawn_last_o,

  input  logic [FrameOutBits-1:0]  frame_i,
  output logic [FrameInBits-1:0]   frame_o,
  input  logic [PlanesOutBits-1:0] planes_i,
  output logic [PlanesInBits-1:0]  planes_o,
  output logic [OutBits-1:0]       memory_o,
  input  logic [InBits-1:0]        memory_i
);
  localparam int unsigned Reads = hs_memory_pkg::Reads;
  localparam int unsigned Writes = hs_memory_pkg::Writes;
  localparam int unsigned RequestBits = hs_memory_pkg::RequestBits;

  logic [2:0] frame_read_valid;
  logic [3*RequestBits-1:0] frame_read;
  logic [1:0] frame_write_valid, frame_store_valid;
  logic [2*RequestBits-1:0] frame_write;
  logic [2*MemoryBits-1:0] frame_store;
  logic planes_read_valid, planes_write_valid, planes_store_valid;
  logic [RequestBits-1:0] planes_read, planes_write;
  logic [MemoryBits-1:0] planes_store;
  logic [Reads-1:0] read_ready, data_valid;
  logic [Reads*MemoryBits-1:0] data;
  logic [Writes-1:0] write_ready, store_ready, written;

  if (OutsideFrame != 0 || OutsidePlanes != 0) begin : gen_memory
    assign {written, store_ready, write_ready, data, data_valid, read_ready} = memory_i;
    assign memory_o = {planes_store, frame_store, planes_store_valid, frame_store_valid,
                       planes_write, frame_write, planes_write_valid, frame_write_valid,
                       planes_read, frame_read, planes_read_valid, frame_read_valid};
  end else begin : gen_no_memory
    logic unused_memory;
    assign unused_memory = ^{memory_i, planes_store, frame_store, planes_store_valid,
                             frame_store_valid, planes_write, frame_write, planes_write_valid,
                             frame_write_valid, planes_read, frame_read, planes_read_valid,
                             frame_read_valid};
    assign {written, store_ready, write_ready, data, data_valid, read_ready} = '0;
    assign memory_o = '0;
  end

  if (OutsidePlanes != 0) begin : gen_planes
    assign {planes_store, planes_store_valid, planes_write, planes_write_valid, planes_read,
            planes_read_valid} = planes_i;
    assign planes_o = {written[Writes-1], store_ready[Writes-1], write_ready[Writes-1],
                       data[(Reads-1)*MemoryBits +: MemoryBits], data_valid[Reads-1],
                       read_ready[Reads-1]};
  end else begin : gen_no_planes
    logic unused_planes;
    assign unused_planes = ^{planes_i, written, store_ready, write_ready, data, data_valid,
                             read_ready};
    assign {planes_store, planes_store_valid, planes_write, planes_write_valid, planes_read,
            planes_read_valid} = '0;
    assign planes_o = '0;
  end

  if (OutsideFrame != 0) begin : gen_frame
    logic [1:0] visible_ahead_q, stored_ahead_q;  // frames that one is true of and the other not

    assign {frame_store, frame_store_valid, frame_write, frame_write_valid, frame_read,
            frame_read_valid} = frame_i;
    assign frame_o = {written[1:0], store_ready[1:0], write_ready[1:0], data[3*MemoryBits-1:0],
                      data_valid[2:0], read_ready[2:0]};

    assign drawn_last_o = (visible_last_i && stored_ahead_q != 2'd0)
                          || (frame_stored_i && visible_ahead_q != 2'd0)
                          || (visible_last_i && frame_stored_i);

    always_ff @(posedge clk_i or negedge rst_ni) begin
      if (!rst_ni) begin
        visible_ahead_q <= 2'd0;
        stored_ahead_q <= 2'd0;
      end else begin
        visible_ahead_q <= visible_ahead_q + 2'(visible_last_i) - 2'(drawn_last_o);
        stored_ahead_q <= stored_ahead_q + 2'(frame_stored_i) - 2'(drawn_last_o);
      end
    end
  end else begin : gen_no_frame
    logic unused_frame;
    assign unused_frame = ^{clk_i, rst_ni, frame_stored_i, frame_i, written, store_ready,
                            write_ready, data, data_valid, read_ready};
    assign {frame_store, frame_store_valid, frame_write, frame_write_valid, frame_read,
            frame_read_valid} = '0;
    assign drawn_last_o = visible_last_i;
    assign frame_o = '0;
  end
endmodule
