// SPDX-License-Identifier: Apache-2.0
// The command list: words of 64 bits from memory, and what they ask for.
//
//   [63:60] command  [59] ends the frame  [57:56] kind  [55:32] count  [31:0] address
//
// END      the list is over
// DRAW     `count` triangles from `address` on; with the mark the last of them ends the frame, and
//          where count is 0 a triangle without area does. A triangle gets its place in the frame,
//          from 1 on, as its index
// WAIT     kind 0: until every triangle was tested, kind 1: until every frame is out
// LOAD     `count` words of kind 0 light, 1 material, 2 texture, 3 texel, when every frame is out
// ANSWERS  what is answered to `visible` lies from `address` on, when every triangle was tested
//
// A triangle, or a word that is loaded, is the record of the configuration without `last` and
// `index`, from bit 0 of its first word on, in as many words as it needs.
// A wrong command ends the list with error_o, a level: one that is none of these, an END or a LOAD
// in a frame, a frame of more triangles than there are indices, a kind that the configuration has
// not.
// Interval: a triangle takes a cycle more than it has words, once they came. Stall: as its taker.
module hs_commands #(
  parameter int unsigned CountBits = 24,
  parameter int unsigned WordsBits = 28,
  localparam int unsigned AddressBits = hs_memory_pkg::AddressBits
) (
  input  logic                                             clk_i,
  input  logic                                             rst_ni,

  input  logic                                             start_i,
  input  logic [AddressBits-1:0]                           base_i,
  output logic                                             active_o,  // until the list is over
  output logic                                             error_o,
  output logic                                             fetching_o,  // triangles
  input  logic                                             idle_i,  // nothing is in the pipeline
  output logic                                             out_o,   // nor was anything sent

  // To hs_fetch
  output logic                                             fetch_valid_o,
  input  logic                                             fetch_ready_i,
  output logic [AddressBits-1:0]                           fetch_address_o,
  output logic [WordsBits-1:0]                             fetch_words_o,
  input  logic                                             word_valid_i,
  output logic                                             word_ready_o,
  input  logic [63:0]                                      word_i,

  // A `visible` moves; and what is answered to it
  input  logic                                             visible_i,
  output logic                                             answers_valid_o,  // for a cycle
  output logic [AddressBits-1:0]                           answers_o,

  // To hs_pipeline
  output logic                                             triangle_valid_o,
  input  logic                                             triangle_ready_i,
  output hs_formats_pkg::triangle_t                        triangle_o,
  output logic                                             light_valid_o,
  output logic [hs_formats_pkg::LightWordBits-1:0]         light_o,
  output logic                                             material_valid_o,
  output logic [hs_formats_pkg::MaterialWordBits-1:0]      material_o,
  output logic                                             texture_valid_o,
  output logic [hs_formats_pkg::TextureWordBits-1:0]       texture_o,
  output logic                                             texel_valid_o,
  output logic [hs_formats_pkg::TexelWordBits-1:0]         texel_o
);
  localparam int unsigned End = 0;
  localparam int unsigned Draw = 1;
  localparam int unsigned Wait = 2;
  localparam int unsigned Load = 3;
  localparam int unsigned Answers = 4;

  localparam int unsigned GivesIndices = hs_formats_pkg::GivesIndices;
  localparam int unsigned VertexBits =
      6 * hs_formats_pkg::CoordBits + 3 * hs_formats_pkg::DepthBits * hs_formats_pkg::HasDepth
      + hs_formats_pkg::TriangleColourBits;
  // Words of each kind; of a record that is not there 1.
  localparam int unsigned TriangleWords = (VertexBits + 63) / 64;
  localparam int unsigned LightWords = (hs_formats_pkg::LightWordBits + 63) / 64;
  localparam int unsigned MaterialWords = (hs_formats_pkg::MaterialWordBits + 63) / 64;
  localparam int unsigned MostWords = TriangleWords > MaterialWords ? TriangleWords : MaterialWords;
  localparam int unsigned RecordBits = 64 * MostWords;
  localparam int unsigned PlaceBits = $clog2(MostWords + 1);
  localparam int unsigned HasLights = hs_formats_pkg::Lights;
  localparam int unsigned HasTexture = hs_formats_pkg::HasTexture;

  typedef enum logic [2:0] {Idle, Fetch, Decode, Start, Records, Waiting} state_t;
  state_t state_q;
  logic [AddressBits-1:0] list_q;
  logic [63:0] command_q;
  logic error_q;

  logic [3:0] command;
  logic ends;
  logic [1:0] kind;
  logic [CountBits-1:0] count;
  logic [AddressBits-1:0] address;
  logic unused_mark;
  assign command = command_q[63:60];
  assign ends = command_q[59];
  assign unused_mark = command_q[58];
  assign kind = command_q[57:56];
  assign count = command_q[32 +: CountBits];
  assign address = command_q[31:0];

  // --- triangles of the frame, and those that are not tested yet ---
  logic [CountBits-1:0] drawn_q;
  logic [15:0] untested_q;
  logic in_frame, triangle, tested, out;
  assign in_frame = drawn_q != '0;
  assign triangle = triangle_valid_o && triangle_ready_i;
  assign tested = untested_q == '0;
  assign out = tested && idle_i;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      drawn_q <= '0;
      untested_q <= '0;
    end else begin
      if (triangle) drawn_q <= triangle_o.last ? '0 : drawn_q + CountBits'(1);
      untested_q <= untested_q + 16'(triangle) - 16'(visible_i);
    end
  end

  // --- a record from its words: the one that came last is the uppermost ---
  logic [RecordBits-1:0] record_q;
  logic [PlaceBits-1:0] have_q, need;
  logic [CountBits-1:0] left_q;
  logic record_valid, record_taken, record_last, is_draw, none_q;

  assign is_draw = command == 4'(Draw);
  always_comb begin
    need = PlaceBits'(TriangleWords);
    if (!is_draw) begin
      case (kind)
        2'd0: need = PlaceBits'(LightWords);
        2'd1: need = PlaceBits'(MaterialWords);
        default: need = PlaceBits'(1);
      endcase
    end
  end
  assign record_valid = state_q == Records && have_q == need;
  assign record_taken = record_valid && (!is_draw || triangle_ready_i);
  assign record_last = left_q == CountBits'(1);
  assign word_ready_o = state_q == Fetch || (state_q == Records && have_q != need);

  always_ff @(posedge clk_i) begin
    if (word_valid_i && word_ready_o) begin
      if (state_q == Fetch) command_q <= word_i;
      else record_q <= RecordBits'({word_i, record_q} >> 64);
    end
    if (state_q == Decode && none_q) record_q <= '0;
  end

  // --- the command ---
  logic wrong, too_many;
  logic [CountBits:0] drawn_then;
  assign drawn_then = {1'b0, drawn_q} + {1'b0, count};
  assign too_many = GivesIndices == 0
                    && drawn_then > (CountBits+1)'(hs_formats_pkg::Triangles);
  assign none_q = is_draw && count == '0;

  always_comb begin
    wrong = 1'b0;
    case (command)
      4'(End): wrong = in_frame;
      4'(Draw): wrong = too_many;
      4'(Wait): wrong = kind[1];
      4'(Load): wrong = in_frame || (kind[1] ? HasTexture == 0 : HasLights == 0);
      4'(Answers): wrong = hs_formats_pkg::Deferred == 0;
      default: wrong = 1'b1;
    endcase
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q <= Idle;
      error_q <= 1'b0;
    end else begin
      case (state_q)
        Idle: if (start_i) state_q <= Start;
        Fetch: if (word_valid_i) state_q <= Decode;
        Decode: begin
          if (wrong) begin
            state_q <= Idle;
            error_q <= 1'b1;
          end else if (command == 4'(End)) begin
            state_q <= Idle;
          end else if (none_q) begin
            state_q <= ends ? Records : Start;
          end else if (command == 4'(Load) && count == '0) begin
            state_q <= Start;
          end else if (is_draw) begin
            if (fetch_ready_i) state_q <= Records;
          end else begin
            state_q <= Waiting;
          end
        end
        Records: if (record_taken && record_last) state_q <= Start;
        Waiting: begin
          if (command == 4'(Load)) begin
            if (out && fetch_ready_i) state_q <= Records;
          end else if (command == 4'(Wait) && kind[0] ? out : tested) begin
            state_q <= Start;
          end
        end
        default: if (fetch_ready_i) state_q <= Fetch;  // Start: of the next command
      endcase
    end
  end

  always_ff @(posedge clk_i) begin
    if (state_q == Idle) list_q <= base_i;
    else if (state_q == Start && fetch_ready_i) list_q <= list_q + AddressBits'(8);
    if (state_q == Decode) left_q <= none_q ? CountBits'(1) : count;
    else if (record_taken) left_q <= left_q - CountBits'(1);
    if (state_q == Decode) have_q <= none_q ? PlaceBits'(TriangleWords) : '0;
    else if (record_taken) have_q <= '0;
    else if (state_q == Records && word_valid_i && word_ready_o) have_q <= have_q + PlaceBits'(1);
  end

  always_comb begin
    fetch_valid_o = 1'b0;
    fetch_address_o = address;
    fetch_words_o = WordsBits'(count) * WordsBits'(need);
    case (state_q)
      Start: begin
        fetch_valid_o = 1'b1;
        fetch_address_o = list_q;
        fetch_words_o = WordsBits'(1);
      end
      Decode: fetch_valid_o = is_draw && !none_q && !wrong;
      Waiting: fetch_valid_o = command == 4'(Load) && out;
      default: ;
    endcase
  end

  // --- to hs_pipeline ---
  hs_formats_pkg::index_t index;
  assign index = none_q ? '0 : hs_formats_pkg::IndexBits'(drawn_q + CountBits'(1));
  assign triangle_valid_o = record_valid && is_draw;
  if (GivesIndices != 0) begin : gen_numbers_itself
    logic unused_index;
    assign unused_index = ^index;
    assign triangle_o = {ends && record_last, record_q[64*(MostWords-TriangleWords) +: VertexBits]};
  end else begin : gen_number
    assign triangle_o = {ends && record_last, index,
                         record_q[64*(MostWords-TriangleWords) +: VertexBits]};
  end

  assign light_valid_o = record_valid && !is_draw && kind == 2'd0;
  assign light_o = record_q[64*(MostWords-LightWords) +: hs_formats_pkg::LightWordBits];
  assign material_valid_o = record_valid && !is_draw && kind == 2'd1;
  assign material_o = record_q[64*(MostWords-MaterialWords) +: hs_formats_pkg::MaterialWordBits];
  assign texture_valid_o = record_valid && !is_draw && kind == 2'd2;
  assign texture_o = record_q[64*(MostWords-1) +: hs_formats_pkg::TextureWordBits];
  assign texel_valid_o = record_valid && !is_draw && kind == 2'd3;
  assign texel_o = record_q[64*(MostWords-1) +: hs_formats_pkg::TexelWordBits];

  logic unused_record;
  assign unused_record = ^record_q;

  assign answers_valid_o = state_q == Waiting && command == 4'(Answers) && tested;
  assign answers_o = address;
  assign out_o = out;
  assign active_o = state_q != Idle;
  assign error_o = error_q;
  assign fetching_o = state_q == Records && is_draw;
endmodule
