// sphere_table: the spheres of a picture, and the light as the last of them.
// Contract: sc/sphere/sphere_table.h
//
// Entries are flip-flops without reset; a 2-state simulation starts them at 0.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module sphere_table #(
    parameter int TableEntries = 16,
    parameter int FractionBits = 12
) (
    // Clock
    input  wire logic clk_i,
    // sphere_host_link
    input  wire logic table_write_i,
    input  wire logic [sphere_pkg::SphereIndexBits-1:0] table_index_i,
    input  wire logic [sphere_pkg::SphereIndexBits-1:0] table_last_i,
    input  wire logic [sphere_pkg::SphereBits-1:0] table_centre_x_i,  // signed
    input  wire logic [sphere_pkg::SphereBits-1:0] table_centre_y_i,
    input  wire logic [sphere_pkg::SphereBits-1:0] table_centre_z_i,
    input  wire logic [sphere_pkg::UnitBits-1:0] table_radius_i,  // whole units
    input  wire logic [sphere_pkg::SphereBits-1:0] table_radius2_i,  // its square, whole
    input  wire logic [sphere_pkg::UnitBits-1:0] table_inverse_i,  // 4096 / radius
    input  wire logic [sphere_pkg::UnitBits-1:0] table_reflect_i,  // of 4096
    input  wire logic [sphere_pkg::SphereColourBits-1:0] table_red_i,
    input  wire logic [sphere_pkg::SphereColourBits-1:0] table_green_i,
    input  wire logic [sphere_pkg::SphereColourBits-1:0] table_blue_i,
    input  wire logic table_is_light_i,
    // sphere_tracer
    input  wire logic [sphere_pkg::SphereIndexBits-1:0] index_i,
    output logic [sphere_pkg::SphereBits-1:0] centre_x_o,  // signed
    output logic [sphere_pkg::SphereBits-1:0] centre_y_o,
    output logic [sphere_pkg::SphereBits-1:0] centre_z_o,
    output logic [sphere_pkg::UnitBits-1:0] radius_o,
    output logic [sphere_pkg::SphereBits-1:0] radius2_o,
    output logic [sphere_pkg::UnitBits-1:0] inverse_o,
    output logic [sphere_pkg::UnitBits-1:0] reflect_o,
    output logic [sphere_pkg::SphereColourBits-1:0] red_o,
    output logic [sphere_pkg::SphereColourBits-1:0] green_o,
    output logic [sphere_pkg::SphereColourBits-1:0] blue_o,
    output logic is_light_o,
    output logic [sphere_pkg::SphereIndexBits-1:0] last_o
);
  localparam int EntryBits = 4 * sphere_pkg::SphereBits + 3 * sphere_pkg::UnitBits
      + 3 * sphere_pkg::SphereColourBits + 1;
  localparam logic [sphere_pkg::SphereBits-1:0] Kept =
      sphere_pkg::SphereBits'(-(1 << (sphere_pkg::SphereFraction - FractionBits)));

  logic [EntryBits-1:0] entries_q[TableEntries];
  logic [sphere_pkg::SphereIndexBits-1:0] last_q;
  logic [EntryBits-1:0] entry;

  always_ff @(posedge clk_i) begin
    for (int n = 0; n < TableEntries; n++)
      if (table_write_i && 32'(table_index_i) == n) begin
        entries_q[n] <= {table_centre_x_i & Kept, table_centre_y_i & Kept,
                         table_centre_z_i & Kept, table_radius_i, table_radius2_i,
                         table_inverse_i, table_reflect_i, table_red_i, table_green_i,
                         table_blue_i, table_is_light_i};
        last_q <= table_last_i;
      end
  end

  always_comb begin
    entry = '0;
    for (int n = 0; n < TableEntries; n++) if (32'(index_i) == n) entry = entries_q[n];
  end

  assign {centre_x_o, centre_y_o, centre_z_o, radius_o, radius2_o, inverse_o, reflect_o, red_o,
          green_o, blue_o, is_light_o} = entry;
  assign last_o = last_q;
endmodule

`default_nettype wire
