// SPDX-License-Identifier: Apache-2.0
// The stamps of `pixel` as lines, on AXI4-Stream: as many pixels a beat as a stamp has.
//
// video_tdata_o: the leftmost pixel in the lowest 24 bits, each {r, g, b} of 8 bits; a channel of
// fewer bits is stretched, so that full is 255. tuser: the first beat of a frame; tlast: the last
// one of a line; tkeep: a bit a byte, 0 behind the right end of a line. As video formats have it a
// line's width is a multiple of a beat's pixels, and then tkeep is all ones.
// A row of stamps is written into one of two buffers while the other one is read, line after line;
// so the first beat comes a row of stamps after the first pixel. Interval 1 on both sides.
// abort_i: all is forgotten but for a beat that is offered, which stays until it is taken.
//
// A buffer has LanesY banks. Line r of stamp x is in bank (x + r) mod LanesY: the lines of a stamp
// are written to all banks at once, and LanesY stamps side by side of one line are read so.
module hs_video #(
  parameter int unsigned LanesX = 2,
  parameter int unsigned LanesY = 2,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned XBits = hs_formats_pkg::XBits,
  localparam int unsigned YBits = hs_formats_pkg::YBits,
  localparam int unsigned PixelBits = 1 + XBits + YBits + Lanes * 3 * ColourBits
) (
  input  logic                      clk_i,
  input  logic                      rst_ni,
  input  logic                      abort_i,
  output logic                      idle_o,
  output logic                      frame_o,  // the last beat of a frame moves

  input  hs_formats_pkg::x_t        frame_width_i,
  input  hs_formats_pkg::y_t        frame_height_i,

  input  logic                      pixel_valid_i,
  output logic                      pixel_ready_o,
  input  logic [PixelBits-1:0]      pixel_i,

  output logic                      video_tvalid_o,
  input  logic                      video_tready_i,
  output logic [24*Lanes-1:0]       video_tdata_o,
  output logic [3*Lanes-1:0]        video_tkeep_o,
  output logic                      video_tuser_o,
  output logic                      video_tlast_o
);
  localparam int unsigned RowBits = LanesY > 1 ? $clog2(LanesY) : 1;  // of a line in its stamps
  localparam int unsigned LineShift = $clog2(LanesY);
  localparam int unsigned BeatShift = $clog2(Lanes);
  localparam int unsigned Beats = (hs_formats_pkg::MaxWidth + Lanes - 1) / Lanes;
  localparam int unsigned BeatBits = Beats > 1 ? $clog2(Beats) : 1;
  localparam int unsigned AddressBits = $clog2(2 * (1 << BeatBits) * LanesY);
  localparam int unsigned ChannelBits = LanesX * 3 * ColourBits;
  localparam int unsigned Full = (1 << ColourBits) - 1;

  // The channel of 8 bits that shows the same share of full.
  function automatic logic [7:0] stretched(input logic [ColourBits-1:0] channel);
    stretched = 8'(channel);
    if (ColourBits < 8) begin
      for (int unsigned i = 0; i <= Full; i++) begin
        if (32'(channel) == i) stretched = 8'((i * 255 + Full / 2) / Full);
      end
    end
  endfunction

  // --- stamps into a buffer ---
  hs_formats_pkg::pixel_head_t head;
  logic [1:0] whole_q;  // of each buffer: a row of stamps is in it
  logic write_buffer_q, read_buffer_q, write, row_ends, row_done;
  hs_formats_pkg::x_t x_last;
  hs_formats_pkg::y_t write_y_q [2];

  assign head = pixel_i[PixelBits-1 -: 1+XBits+YBits];
  assign x_last = (frame_width_i - XBits'(1)) >> $clog2(LanesX);
  assign pixel_ready_o = !whole_q[write_buffer_q];
  assign write = pixel_valid_i && pixel_ready_o && !abort_i;
  assign row_ends = write && head.x == x_last;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      whole_q <= 2'b00;
      write_buffer_q <= 1'b0;
      read_buffer_q <= 1'b0;
    end else if (abort_i) begin
      whole_q <= 2'b00;
      write_buffer_q <= 1'b0;
      read_buffer_q <= 1'b0;
    end else begin
      for (int unsigned i = 0; i < 2; i++) begin
        if (row_ends && write_buffer_q == 1'(i)) whole_q[i] <= 1'b1;
        else if (row_done && read_buffer_q == 1'(i)) whole_q[i] <= 1'b0;
      end
      if (row_ends) write_buffer_q <= !write_buffer_q;
      if (row_done) read_buffer_q <= !read_buffer_q;
    end
  end

  always_ff @(posedge clk_i) begin
    if (row_ends) write_y_q[write_buffer_q] <= head.y;
  end

  // --- beats out of the other one ---
  logic [BeatBits-1:0] beat_q, beat_last;
  logic [RowBits-1:0] row_q;
  logic read, line_ends;
  hs_formats_pkg::y_t line;

  assign beat_last = BeatBits'((frame_width_i - XBits'(1)) >> BeatShift);
  assign line_ends = beat_q == beat_last;
  assign line = (write_y_q[read_buffer_q] << LineShift) + YBits'(row_q);
  assign read = whole_q[read_buffer_q] && (!video_tvalid_o || video_tready_i) && !abort_i;
  assign row_done = read && line_ends
                    && (32'(row_q) == LanesY - 1 || line == frame_height_i - YBits'(1));

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      beat_q <= '0;
      row_q <= '0;
    end else if (abort_i) begin
      beat_q <= '0;
      row_q <= '0;
    end else if (read) begin
      beat_q <= line_ends ? '0 : beat_q + BeatBits'(1);
      if (line_ends) row_q <= row_done ? '0 : row_q + RowBits'(1);
    end
  end

  // --- banks ---
  logic [LanesY*ChannelBits-1:0] read_lines;

  for (genvar bank = 0; bank < LanesY; bank++) begin : gen_bank
    logic [RowBits-1:0] write_row;
    logic [ChannelBits-1:0] write_line;
    logic [AddressBits-1:0] write_address, read_address;

    assign write_row = RowBits'((bank + LanesY - (32'(head.x) & (LanesY - 1))) & (LanesY - 1));
    assign write_address = AddressBits'(
        (((32'(write_buffer_q) << BeatBits) + (32'(head.x) >> LineShift)) << LineShift)
        + 32'(write_row));
    assign read_address = AddressBits'(
        (((32'(read_buffer_q) << BeatBits) + 32'(beat_q)) << LineShift) + 32'(row_q));

    // {r, g, b} a pixel, from fields that have all lanes of a channel.
    always_comb begin
      write_line = '0;
      for (int unsigned row = 0; row < LanesY; row++) begin
        for (int unsigned i = 0; i < LanesX; i++) begin
          if (write_row == RowBits'(row)) begin
            write_line[3*i*ColourBits +: 3*ColourBits] =
                {pixel_i[(2*Lanes+row*LanesX+i)*ColourBits +: ColourBits],
                 pixel_i[(Lanes+row*LanesX+i)*ColourBits +: ColourBits],
                 pixel_i[(row*LanesX+i)*ColourBits +: ColourBits]};
          end
        end
      end
    end

    hs_ram_1r1w #(
      .Width(ChannelBits),
      .Depth(1 << AddressBits)
    ) u_lines (
      .clk_i          (clk_i),
      .read_en_i      (read),
      .read_address_i (read_address),
      .read_data_o    (read_lines[bank*ChannelBits +: ChannelBits]),
      .write_en_i     (write),
      .write_address_i(write_address),
      .write_data_i   (write_line)
    );
  end

  // --- the beat that was read ---
  logic valid_q, first_q, last_q, frame_last_q;
  logic [RowBits-1:0] shown_row_q;
  logic [BeatShift:0] pixels_q;  // of the beat, in the frame

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= 1'b0;
    else if (read) valid_q <= 1'b1;
    else if (video_tready_i) valid_q <= 1'b0;
  end

  always_ff @(posedge clk_i) begin
    if (read) begin
      first_q <= line == '0 && beat_q == '0;
      last_q <= line_ends;
      frame_last_q <= line_ends && line == frame_height_i - YBits'(1);
      shown_row_q <= row_q;
      pixels_q <= !line_ends ? (BeatShift+1)'(Lanes)
                  : (BeatShift+1)'(((32'(frame_width_i) - 32'd1) & (Lanes - 1)) + 32'd1);
    end
  end

  always_comb begin
    video_tdata_o = '0;
    for (int unsigned place = 0; place < Lanes; place++) begin
      video_tkeep_o[3*place +: 3] = {3{32'(pixels_q) > place}};
      for (int unsigned bank = 0; bank < LanesY; bank++) begin
        if (((place / LanesX + 32'(shown_row_q)) & (LanesY - 1)) == bank) begin
          for (int unsigned channel = 0; channel < 3; channel++) begin
            video_tdata_o[24*place+8*channel +: 8] = stretched(
                read_lines[bank*ChannelBits+(3*(place%LanesX)+channel)*ColourBits +: ColourBits]);
          end
        end
      end
    end
  end

  logic unused_last;
  assign unused_last = head.last;

  assign video_tvalid_o = valid_q;
  assign video_tuser_o = first_q;
  assign video_tlast_o = last_q;
  assign frame_o = video_tvalid_o && video_tready_i && frame_last_q;
  assign idle_o = whole_q == 2'b00 && !valid_q;
endmodule
