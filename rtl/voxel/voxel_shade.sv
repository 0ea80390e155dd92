// voxel_shade: the colour of a pixel from where its ray ended.
// Contract: sc/voxel/voxel_shade.h
//
// The palette is flip-flops without reset, as all registers but step and phase; a 2-state
// simulation starts them at 0.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module voxel_shade #(
    parameter int Leaf = 0,  // 0: march, 1: voxel
    parameter int Shading = 0,  // 0: height, 1: slope
    parameter int Sky = 0,  // 0: plain, 1: gradient
    parameter int DebugLimits = 0,
    parameter int MemoryClocks = 1,
    parameter int SizeX = 64,
    parameter int SizeY = 64,
    parameter int SizeZ = 32
) (
    // Clock and reset
    input  wire logic clk_i,
    input  wire logic rst_ni,
    // Host
    input  wire logic palette_write_i,
    input  wire logic [voxel_pkg::VoxelPaletteBits-1:0] palette_index_i,
    input  wire logic [voxel_pkg::VoxelColourBits-1:0] palette_colour_i,
    // voxel_scan
    input  wire logic take_i,
    input  wire logic shade_i,
    input  wire logic shadowed_i,  // with shade_i: the light does not reach it
    // voxel_walker
    input  wire logic [voxel_pkg::VoxelKindBits-1:0] kind_i,
    /* verilator lint_off UNUSEDSIGNAL */  // what is below a unit, or a bit of a sky's slope
    input  wire logic [voxel_pkg::VoxelPositionBits-1:0] hit_x_i,  // signed
    input  wire logic [voxel_pkg::VoxelPositionBits-1:0] hit_y_i,
    input  wire logic [voxel_pkg::VoxelPositionBits-1:0] hit_z_i,
    // voxel_camera
    input  wire logic [voxel_pkg::VoxelDirectionBits-1:0] direction_z_i,  // signed
    /* verilator lint_on UNUSEDSIGNAL */
    // voxel_leaf
    input  wire logic leaf_read_i,
    input  wire logic [voxel_pkg::VoxelColumnBits-1:0] leaf_address_i,
    // column_memory
    output logic read_o,
    output logic [voxel_pkg::VoxelColumnBits-1:0] address_o,
    input  wire logic [voxel_pkg::VoxelMemoryBits-1:0] data_i,
    // voxel_scan
    output logic done_o,
    output logic [voxel_pkg::VoxelColourBits-1:0] colour_o,
    // write_buffer
    input  wire logic put_ready_i
);
  localparam int CellBits = voxel_pkg::VoxelCoordinateBits;
  localparam int HeightBits = voxel_pkg::VoxelHeightBits;
  localparam int ColumnBits = voxel_pkg::VoxelColumnBits;
  localparam int ColourBits = voxel_pkg::VoxelColourBits;
  localparam int SlopeBits = HeightBits + 3;

  typedef logic [HeightBits-1:0] height_bits;
  typedef logic [CellBits-1:0] place_bits;
  typedef logic [SlopeBits-1:0] slope_bits;

  typedef enum logic [2:0] {
    Idle = 3'd0,
    Own = 3'd1,
    East = 3'd2,
    West = 3'd3,
    North = 3'd4,
    South = 3'd5,
    Last = 3'd6
  } step;

  logic [2:0] step_q, step_d;  // a step
  logic [3:0] phase_q, phase_d;  // clocks of this read that are over
  logic [voxel_pkg::VoxelKindBits-1:0] kind_q;
  place_bits cell_x_q, cell_y_q, cell_z_q;  // where the ray ended, in whole units, signed
  /* verilator lint_off UNUSEDSIGNAL */  // its spare bits
  logic [voxel_pkg::VoxelMemoryBits-1:0] column_q;
  /* verilator lint_on UNUSEDSIGNAL */
  slope_bits slope_q, slope_d;  // 2 (east - west) + (north - south), of what is read, signed
  logic shadowed_q;
  logic [ColourBits-1:0] palette_q[voxel_pkg::VoxelPaletteEntries];

  // --- Reads of columns -------------------------------------------------------------------------
  wire logic reads = step_q != Idle && step_q != Last;
  wire logic last_of_read = reads && phase_q == 4'(1 + MemoryClocks);

  wire place_bits beside_x = cell_x_q + CellBits'(step_q == East) - CellBits'(step_q == West);
  wire place_bits beside_y = cell_y_q + CellBits'(step_q == North)
      - CellBits'(step_q == South);
  wire place_bits place_x, place_y;
  voxel_wrap #(
      .Side(SizeX),
      .Levels(1)
  ) u_voxel_wrap_x (
      .value_i(beside_x),
      .level_i('0),
      .place_o(place_x)
  );
  voxel_wrap #(
      .Side(SizeY),
      .Levels(1)
  ) u_voxel_wrap_y (
      .value_i(beside_y),
      .level_i('0),
      .place_o(place_y)
  );
  assign read_o = reads ? phase_q == '0 : leaf_read_i;
  assign address_o = reads ? ColumnBits'(place_y) * ColumnBits'(SizeX) + ColumnBits'(place_x)
                           : leaf_address_i;

  // --- The surface that is shown ----------------------------------------------------------------
  wire height_bits low = column_q[0+:HeightBits];
  wire height_bits middle = column_q[HeightBits+:HeightBits];
  wire height_bits high = column_q[2*HeightBits+:HeightBits];
  wire logic signed [CellBits:0] z = (CellBits + 1)'($signed(cell_z_q));
  wire logic down = direction_z_i[voxel_pkg::VoxelDirectionBits-1];

  function automatic logic signed [CellBits:0] wide(input height_bits value);
    wide = $signed({1'b0, CellBits'(value)});
  endfunction

  wire logic upper = z >= wide(low) && z + (down ? 17'sd0 : 17'sd1) >= wide(middle)
      && middle < high;
  wire logic signed [CellBits:0] top = wide(upper ? high : low) - 17'sd1;
  wire logic signed [CellBits:0] bottom = wide(upper ? middle : '0);
  wire logic signed [CellBits:0] reached = z < top ? z : top;
  /* verilator lint_off UNUSEDSIGNAL */  // it is one of the column's heights
  wire logic signed [CellBits:0] height = reached > bottom ? reached : bottom;
  /* verilator lint_on UNUSEDSIGNAL */

  wire height_bits beside = data_i[(upper?2*HeightBits : 0)+:HeightBits];
  always_comb begin
    slope_d = slope_q;
    unique case (step_q)
      East: slope_d = slope_q + {2'b0, beside, 1'b0};
      West: slope_d = slope_q - {2'b0, beside, 1'b0};
      North: slope_d = slope_q + {3'b0, beside};
      South: slope_d = slope_q - {3'b0, beside};
      default: ;
    endcase
  end

  // --- What shows a column, and what of it is not there yet -------------------------------------
  function automatic logic shows_column(input logic [voxel_pkg::VoxelKindBits-1:0] kind);
    shows_column = kind == voxel_pkg::VoxelHit || kind != voxel_pkg::VoxelSky && DebugLimits == 0;
  endfunction

  wire logic [voxel_pkg::VoxelKindBits-1:0] kind_d = take_i ? kind_i : kind_q;
  wire logic begins = step_q == Idle && shade_i;
  always_comb begin
    step_d = step_q;
    phase_d = reads && !last_of_read ? phase_q + 1'b1 : '0;
    if (begins && kind_d == voxel_pkg::VoxelHit && Leaf == 1) step_d = Own;
    else if (begins || step_q == Own && last_of_read)
      step_d = Shading == 1 && shows_column(kind_d) ? East : Last;
    else if (last_of_read) step_d = step_q + 1'b1;
    else if (done_o && put_ready_i) step_d = Idle;
  end
  assign done_o = step_q == Last;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) {step_q, phase_q} <= {Idle, 4'd0};
    else {step_q, phase_q} <= {step_d, phase_d};
    kind_q <= kind_d;
    if (last_of_read) slope_q <= slope_d;
    if (begins) {slope_q, shadowed_q} <= {SlopeBits'(0), shadowed_i};
    if (take_i) begin
      cell_x_q <= hit_x_i[voxel_pkg::VoxelPositionFraction+:CellBits];
      cell_y_q <= hit_y_i[voxel_pkg::VoxelPositionFraction+:CellBits];
      cell_z_q <= hit_z_i[voxel_pkg::VoxelPositionFraction+:CellBits];
    end
    if (take_i || step_q == Own && last_of_read) column_q <= data_i;
    if (palette_write_i) palette_q[palette_index_i] <= palette_colour_i;
  end

  // --- Colour -----------------------------------------------------------------------------------
  localparam int ScaleBits = $clog2(voxel_pkg::VoxelPaletteHeights);
  localparam int WorldBits = $clog2(SizeZ);
  localparam int Right = WorldBits > ScaleBits ? WorldBits - ScaleBits : 0;
  localparam int Left = WorldBits < ScaleBits ? ScaleBits - WorldBits : 0;
  wire logic [2:0] material = upper ? column_q[27+:3] : column_q[24+:3];
  wire logic [ScaleBits-1:0] scaled = ScaleBits'(height[HeightBits-1:0] >> Right << Left);
  wire logic [ColourBits-1:0] base = palette_q[{material, scaled}];

  wire slope_bits light = SlopeBits'(10) - slope_q;
  wire logic [4:0] sixteenths = Shading == 0 ? 5'd16 :
      $signed(light) < $signed(SlopeBits'(2)) ? 5'd2 :
      $signed(light) > $signed(SlopeBits'(15)) ? 5'd15 : light[4:0];

  function automatic logic [7:0] lit(input logic [7:0] channel, input logic [4:0] parts,
                                     input logic shadowed);
    /* verilator lint_off UNUSEDSIGNAL */  // what is below a bit
    logic [12:0] product;
    /* verilator lint_on UNUSEDSIGNAL */
    product = channel * parts;
    lit = product[11:4] >> shadowed;
  endfunction

  localparam int DirectionBits = voxel_pkg::VoxelDirectionBits;
  wire logic [3:0] slope_of_sky = Sky == 0 ? 4'(voxel_pkg::VoxelSkyMiddle) :
      down ? 4'd0 : direction_z_i[DirectionBits-2] ? 4'd15 : direction_z_i[12+:4];
  wire logic [7:0] below = 8'd15 - 8'(slope_of_sky);

  always_comb begin
    if (kind_q == voxel_pkg::VoxelSky)
      colour_o = {
        8'(voxel_pkg::VoxelSkyRed) + below * 8'(voxel_pkg::VoxelSkyRedStep),
        8'(voxel_pkg::VoxelSkyGreen) + below * 8'(voxel_pkg::VoxelSkyGreenStep),
        8'(voxel_pkg::VoxelSkyBlue) + below * 8'(voxel_pkg::VoxelSkyBlueStep)
      };
    else if (!shows_column(kind_q))
      colour_o = kind_q == voxel_pkg::VoxelOuterLimit ? 24'hff00ff : 24'h7f007f;
    else
      colour_o = {
        lit(base[23:16], sixteenths, shadowed_q),
        lit(base[15:8], sixteenths, shadowed_q),
        lit(base[7:0], sixteenths, shadowed_q)
      };
  end
endmodule

`default_nettype wire
