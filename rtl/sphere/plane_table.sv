// plane_table: the planes of a scene, in a read-only memory.
// Contract: sc/sphere/plane_table.h
//
// The table is read from PlaneFile by $readmemh: a row for each of Planes planes. Without a file
// there are none.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module plane_table #(
    parameter PlaneFile = "",  // a string; yosys 0.23 has no such type
    parameter int Planes = 0
) (
    // sphere_tracer
    input  wire logic [sphere_pkg::PlaneIndexBits-1:0] index_i,
    output logic [sphere_pkg::SphereBits-1:0] normal_x_o,  // signed, of length 1
    output logic [sphere_pkg::SphereBits-1:0] normal_y_o,
    output logic [sphere_pkg::SphereBits-1:0] normal_z_o,
    output logic [sphere_pkg::SphereBits-1:0] distance_o,  // signed
    output logic [sphere_pkg::SphereColourBits-1:0] red_o,
    output logic [sphere_pkg::SphereColourBits-1:0] green_o,
    output logic [sphere_pkg::SphereColourBits-1:0] blue_o,
    output logic [sphere_pkg::UnitBits-1:0] reflect_o,  // of 4096
    output logic [3:0] checker_o,
    output logic limited_o,
    output logic [sphere_pkg::UnitBits-1:0] limit_x_o,  // whole units
    output logic [sphere_pkg::UnitBits-1:0] limit_y_o,
    output logic [sphere_pkg::UnitBits-1:0] limit_z_o,
    output logic [sphere_pkg::PlaneIndexBits-1:0] last_o,  // index of the last plane
    output logic empty_o  // there is none
);
  localparam int Used = PlaneFile == "" ? 0 : Planes;
  localparam int Rows = Used > 0 ? Used : 1;
  localparam int RowBits = 176;  // fields of whole digits

  logic [RowBits-1:0] rows[Rows];
  if (Used > 0) begin : g_table
    initial $readmemh(PlaneFile, rows);
  end else begin : g_empty
    initial rows[0] = '0;
  end

  /* verilator lint_off UNUSEDSIGNAL */  // the upper bits of a digit
  logic [RowBits-1:0] row;
  logic [7:0] red, green, blue;
  logic [3:0] limited;
  /* verilator lint_on UNUSEDSIGNAL */

  always_comb begin
    row = '0;
    for (int n = 0; n < Used; n++) if (32'(index_i) == n) row = rows[n];
    {normal_x_o, normal_y_o, normal_z_o, distance_o, red, green, blue, reflect_o, checker_o,
     limited, limit_x_o, limit_y_o, limit_z_o} = row;
    red_o = red[sphere_pkg::SphereColourBits-1:0];
    green_o = green[sphere_pkg::SphereColourBits-1:0];
    blue_o = blue[sphere_pkg::SphereColourBits-1:0];
    limited_o = limited[0];
  end

  assign last_o = sphere_pkg::PlaneIndexBits'(Rows - 1);
  assign empty_o = Used == 0;
endmodule

`default_nettype wire
