// scene_rom: the world as a table, for scene files; takes the place of scene, with the same ports.
// Contract: sc/beam/scene_rom.h
//
// The table is read from RoomFile by $readmemh: a row for each of Rooms rooms, from room 0 on, of
// 36 words of 4 hex digits, the first word leftmost (`_` between digits is allowed):
//   edges of portals 0..3 of face +x, of -x, of +y, of -y, of +z, of -z, a digit each: see
//   sc/beam/scene.h; a row without these words has none
//   half size x, y, z    position x, y, z (two's complement)
//   portals 0..3 of face +x, of -x, of +y, of -y, of +z, of -z
// A portal is {0, back (2 bits), room (13 bits)}; 1fff is none. Without a file there are no rooms.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module scene_rom #(
    parameter RoomFile = "",  // a string; yosys 0.23 has no such type
    parameter int Rooms = 1
) (
    /* verilator lint_off UNUSEDSIGNAL */  // the geometries of scene
    // sequencer
    input  wire logic [5:0] scene_flags_i,
    /* verilator lint_on UNUSEDSIGNAL */
    // decision_datapath
    input  wire logic [racebeam_pkg::RoomPortBits-1:0] room_i,
    input  wire logic [1:0] look_axis_i,
    /* verilator lint_off UNUSEDSIGNAL */  // only the bit of the axis counts
    input  wire logic [2:0] look_signs_i,
    /* verilator lint_on UNUSEDSIGNAL */
    input  wire logic [racebeam_pkg::PortalBits-1:0] look_portal_i,
    input  wire logic [1:0] look_way_i,
    output logic [racebeam_pkg::CornerPortBits-1:0] half_size_x_o,
    output logic [racebeam_pkg::CornerPortBits-1:0] half_size_y_o,
    output logic [racebeam_pkg::CornerPortBits-1:0] half_size_z_o,
    output logic signed [racebeam_pkg::CornerPortBits-1:0] position_x_o,
    output logic signed [racebeam_pkg::CornerPortBits-1:0] position_y_o,
    output logic signed [racebeam_pkg::CornerPortBits-1:0] position_z_o,
    output logic [racebeam_pkg::RoomPortBits-1:0] neighbour_o,
    output logic [racebeam_pkg::PortalBits-1:0] back_o,
    output logic [3:0] edges_o
);
  localparam int WordBits = 16;
  localparam int SizeWords = 6;
  localparam int PortalWords = 6 * racebeam_pkg::MaxPortals;
  localparam int EdgeRowBits = PortalWords * 4;
  localparam int RoomRowBits = (SizeWords + PortalWords) * WordBits;
  localparam int RowBits = EdgeRowBits + RoomRowBits;
  localparam int PortalRowBits = PortalWords * WordBits;
  localparam int RoomBits = racebeam_pkg::RoomPortBits;
  localparam int PortalBits = racebeam_pkg::PortalBits;
  localparam int NoRoom = (1 << WordBits) - 1 - (7 << RoomBits);  // no portal, no room


  localparam int AddressBits = Rooms > 1 ? $clog2(Rooms) : 1;

  logic [RowBits-1:0] rows[Rooms];
  if (RoomFile != "") begin : g_table
    initial $readmemh(RoomFile, rows);
  end else begin : g_empty
    initial for (int n = 0; n < Rooms; n++) rows[n] = '0;
  end

  function automatic logic there(input logic [RoomBits-1:0] room);
    there = RoomFile != "" && 32'(room) < Rooms;
  endfunction

  // A portal of a row; `face` is {axis, towards negative}.
  function automatic logic [WordBits-1:0] portal_of(input logic [PortalRowBits-1:0] row,
                                                    input logic [2:0] face,
                                                    input logic [PortalBits-1:0] portal);
    portal_of = WordBits'(NoRoom);
    for (int n = 0; n < PortalWords; n++)
      if ({face, portal} == 5'(n)) portal_of = row[(PortalWords-1-n)*WordBits+:WordBits];
  endfunction

  logic [RowBits-1:0] row;
  logic [PortalRowBits-1:0] row_behind;
  logic [2:0] face;
  /* verilator lint_off UNUSEDSIGNAL */  // bit 15 of a word is 0
  logic [WordBits-1:0] through, beside, answer;
  /* verilator lint_on UNUSEDSIGNAL */
  logic [RoomBits-1:0] room_behind;
  logic [PortalBits:0] portal_beside;  // one bit more: there may be none

  always_comb begin
    row = there(room_i) ? rows[room_i[AddressBits-1:0]] : '0;
    {half_size_x_o, half_size_y_o, half_size_z_o} = row[RoomRowBits-1-:3*WordBits];
    {position_x_o, position_y_o, position_z_o} = row[RoomRowBits-3*WordBits-1-:3*WordBits];

    face = {look_axis_i, look_axis_i == 2'd2 ? look_signs_i[2]
        : look_axis_i == 2'd1 ? look_signs_i[1] : look_signs_i[0]};
    through = there(room_i) ? portal_of(row[PortalRowBits-1:0], face, look_portal_i)
        : WordBits'(NoRoom);

    edges_o = '0;
    for (int n = 0; n < PortalWords; n++)
      if ({face, look_portal_i} == 5'(n)) edges_o = row[RowBits-1-4*n-:4];

    // The portal beside, in the face towards us of the room behind.
    room_behind = through[RoomBits-1:0];
    row_behind = there(room_behind) ? rows[room_behind[AddressBits-1:0]][PortalRowBits-1:0] : '0;
    portal_beside = {1'b0, through[RoomBits+:PortalBits]};
    if (look_way_i == racebeam_pkg::LookNext) portal_beside = portal_beside + 1'b1;
    else portal_beside = portal_beside - 1'b1;
    beside = there(room_behind) && !portal_beside[PortalBits]
        ? portal_of(row_behind, face ^ 3'b001, portal_beside[PortalBits-1:0])
        : WordBits'(NoRoom);

    answer = look_way_i == racebeam_pkg::LookThrough ? through : beside;
    neighbour_o = answer[RoomBits-1:0];
    back_o = answer[RoomBits+:PortalBits];
  end
endmodule

`default_nettype wire
