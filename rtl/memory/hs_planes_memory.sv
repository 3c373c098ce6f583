// SPDX-License-Identifier: Apache-2.0
// TdbS in memory outside: hs_planes_store for the setup, hs_planes_ahead for the shader.
//
// Memory, by client: memory_o is {store, store_valid, write, write_valid, read, read_valid},
// memory_i is {written, store_ready, write_ready, data, data_valid, read_ready}.
module hs_planes_memory #(
  parameter int unsigned LanesX,
  parameter int unsigned LanesY,
  parameter int unsigned PlanesBits,
  parameter int unsigned MemoryBits,
  parameter int unsigned EachPixel,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned EntryPlanesBits = PlanesBits - 2 - IndexBits,
  localparam int unsigned ScanBits =
      1 + hs_formats_pkg::XBits + hs_formats_pkg::YBits + Lanes * IndexBits,
  localparam int unsigned OutBits = 2 * (1 + hs_memory_pkg::RequestBits) + 1 + MemoryBits,
  localparam int unsigned InBits = 5 + MemoryBits
) (
  input  logic                                  clk_i,
  input  logic                                  rst_ni,

  input  logic                                  planes_valid_i,
  output logic                                  planes_ready_o,
  input  logic [PlanesBits-1:0]                 planes_i,
  input  logic                                  planes_bank_i,
  output logic                                  planes_last_o,
  output logic                                  stored_last_o,

  input  logic                                  scan_valid_i,
  output logic                                  scan_ready_o,
  input  logic [ScanBits-1:0]                   scan_i,
  output logic                                  scan_valid_o,
  input  logic                                  scan_ready_i,
  output logic [ScanBits-1:0]                   scan_o,
  input  logic                                  read_en_i,
  output logic [EntryPlanesBits-1:0]            read_planes_o,

  input  logic [hs_memory_pkg::AddressBits-1:0] base_i,
  output logic [OutBits-1:0]                    memory_o,
  input  logic [InBits-1:0]                     memory_i
);
  logic read_valid, read_ready, data_valid, write_valid, write_ready, store_valid, store_ready;
  logic written;
  logic [MemoryBits-1:0] data, store;
  hs_memory_pkg::request_t read, write;

  assign memory_o = {store, store_valid, write, write_valid, read, read_valid};
  assign {written, store_ready, write_ready, data, data_valid, read_ready} = memory_i;

  hs_planes_store #(
    .PlanesBits(PlanesBits),
    .MemoryBits(MemoryBits)
  ) u_store (
    .clk_i         (clk_i),
    .rst_ni        (rst_ni),
    .base_i        (base_i),
    .planes_valid_i(planes_valid_i),
    .planes_ready_o(planes_ready_o),
    .planes_i      (planes_i),
    .planes_bank_i (planes_bank_i),
    .planes_last_o (planes_last_o),
    .stored_last_o (stored_last_o),
    .write_valid_o (write_valid),
    .write_ready_i (write_ready),
    .write_o       (write),
    .store_valid_o (store_valid),
    .store_ready_i (store_ready),
    .store_o       (store),
    .written_i     (written)
  );

  hs_planes_ahead #(
    .LanesX         (LanesX),
    .LanesY         (LanesY),
    .EntryPlanesBits(EntryPlanesBits),
    .MemoryBits     (MemoryBits),
    .EachPixel      (EachPixel)
  ) u_ahead (
    .clk_i        (clk_i),
    .rst_ni       (rst_ni),
    .base_i       (base_i),
    .scan_valid_i (scan_valid_i),
    .scan_ready_o (scan_ready_o),
    .scan_i       (scan_i),
    .scan_valid_o (scan_valid_o),
    .scan_ready_i (scan_ready_i),
    .scan_o       (scan_o),
    .read_en_i    (read_en_i),
    .read_planes_o(read_planes_o),
    .read_valid_o (read_valid),
    .read_ready_i (read_ready),
    .read_o       (read),
    .data_valid_i (data_valid),
    .data_i       (data)
  );
endmodule
