// sphere_host_link: takes the spheres of a picture from a CPU, and adds the light.
// Contract: sc/sphere/sphere_host_link.h
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module sphere_host_link #(
    parameter int TableEntries = 16
) (
    // Clock and reset
    input  wire logic clk_i,
    input  wire logic rst_ni,
    // The CPU
    input  wire logic [7:0] sphere_i,  // {number of spheres, index of this one}
    input  wire logic [15:0] color_i,  // {light, red, green, blue}
    input  wire logic [sphere_pkg::SphereBits-1:0] x1_i,  // signed
    input  wire logic [sphere_pkg::SphereBits-1:0] y1_i,
    input  wire logic [sphere_pkg::SphereBits-1:0] z1_i,
    input  wire logic [sphere_pkg::UnitBits-1:0] reflect_i,
    input  wire logic [sphere_pkg::UnitBits-1:0] radius_i,
    input  wire logic [sphere_pkg::SphereBits-1:0] r2_i,
    input  wire logic [sphere_pkg::UnitBits-1:0] r_inv_i,
    input  wire logic valid_i,
    // sphere_inputs
    input  wire logic [sphere_pkg::SphereBits-1:0] light_x_i,  // signed
    input  wire logic [sphere_pkg::SphereBits-1:0] light_y_i,
    input  wire logic [sphere_pkg::SphereBits-1:0] light_z_i,
    input  wire logic scene_i,
    // sphere_tracer
    input  wire logic host_i,  // it waits for the table; the CPU's `done`
    output logic loaded_o,
    // sphere_table
    output logic table_write_o,
    output logic [sphere_pkg::SphereIndexBits-1:0] table_index_o,
    output logic [sphere_pkg::SphereIndexBits-1:0] table_last_o,  // number of spheres
    output logic [sphere_pkg::SphereBits-1:0] table_centre_x_o,
    output logic [sphere_pkg::SphereBits-1:0] table_centre_y_o,
    output logic [sphere_pkg::SphereBits-1:0] table_centre_z_o,
    output logic [sphere_pkg::UnitBits-1:0] table_radius_o,
    output logic [sphere_pkg::SphereBits-1:0] table_radius2_o,
    output logic [sphere_pkg::UnitBits-1:0] table_inverse_o,
    output logic [sphere_pkg::UnitBits-1:0] table_reflect_o,
    output logic [sphere_pkg::SphereColourBits-1:0] table_red_o,
    output logic [sphere_pkg::SphereColourBits-1:0] table_green_o,
    output logic [sphere_pkg::SphereColourBits-1:0] table_blue_o,
    output logic table_is_light_o,
    // Counters
    output logic fault_o
);
  localparam int Bits = sphere_pkg::SphereBits;
  localparam int Unit = sphere_pkg::UnitBits;
  // An entry but for its centre: {radius, radius2, inverse, reflect, is_light, red, green, blue}
  localparam int RestBits = 3 * Unit + Bits + 16;
  localparam int EntryBits = 3 * Bits + RestBits;

  typedef logic [sphere_pkg::SphereIndexBits-1:0] index;
  typedef logic [RestBits-1:0] rest;
  typedef logic [EntryBits-1:0] entry;

  localparam index Most = sphere_pkg::SphereIndexBits'(TableEntries - 1);
  // Bits that are shifted, the new one from two of them: what comes after HostPatience - 1 steps.
  localparam int PatienceBits = 17;
  localparam logic [PatienceBits-1:0] LastPatience = 17'h1ff80;

  logic waiting_q, taken_q, taken_d;  // valid_i was 1, and not taken; and taken
  logic answered_q, answered_d;  // a CPU sent something
  logic [PatienceBits-1:0] patience_q, patience_d;
  logic expired_q, expired_d;  // no CPU came
  index count_q, count_d;  // entries of this picture
  logic loaded_q, loaded_d, fault_q, fault_d, write_q, write_d;
  index index_q, index_d, last_q, last_d;
  entry entry_q, entry_d;

  // --- Who gives an entry in this clock --------------------------------------------------------
  wire logic listens = host_i && !loaded_q;
  wire logic cpu = listens && valid_i && !taken_q;
  wire logic built_in = listens && !cpu && !answered_q && expired_q;

  wire index wanted = cpu ? sphere_i[7:4] : scene_i ? 4'd1 : 4'd4;
  wire index spheres = 32'(wanted) >= TableEntries ? Most : wanted;
  wire logic is_last = count_q >= spheres;
  wire logic too_high = sphere_i[3:0] > spheres;

  // --- The entry -------------------------------------------------------------------------------
  function automatic logic [Bits-1:0] whole(input int units);
    whole = Bits'(units <<< sphere_pkg::SphereFraction);
  endfunction

  function automatic rest ball(input int radius, input logic [14:0] colour,
                                 input logic [Unit-1:0] reflect);
    ball = {Unit'(radius), Bits'(radius * radius), Unit'(4096 / radius), reflect, 1'b0,
            colour};
  endfunction

  always_comb begin
    entry_d = entry_q;
    if ((cpu || built_in) && is_last)
      entry_d = {light_x_i, light_y_i, light_z_i, Unit'(sphere_pkg::LightRadius),
                 Bits'(sphere_pkg::LightRadius * sphere_pkg::LightRadius),
                 Unit'(4096 / sphere_pkg::LightRadius), Unit'(0), 16'hffff};
    else if (cpu && !too_high)
      entry_d = {x1_i, y1_i, z1_i, radius_i, r2_i, r_inv_i, reflect_i, color_i};
    else if (built_in && scene_i)
      entry_d = {whole(0), whole(0), whole(15), ball(10, {5'd31, 5'd16, 5'd4}, 12'h400)};
    else if (built_in)
      unique case (count_q)
        4'd0: entry_d = {whole(-9), whole(0), whole(15), ball(5, {5'd31, 5'd4, 5'd4}, 12'h400)};
        4'd1: entry_d = {whole(9), whole(0), whole(15), ball(5, {5'd4, 5'd31, 5'd4}, 12'h400)};
        4'd2: entry_d = {whole(0), whole(-9), whole(20), ball(5, {5'd4, 5'd4, 5'd31}, 12'h400)};
        default: entry_d = {whole(0), whole(8), whole(10), ball(4, {5'd6, 5'd6, 5'd6}, 12'h800)};
      endcase
  end

  always_comb begin
    write_d = (cpu && (is_last || !too_high)) || built_in;
    index_d = index_q;
    last_d = last_q;
    if (write_d) begin
      index_d = is_last ? spheres : cpu ? sphere_i[3:0] : count_q;
      last_d = spheres;
    end
    loaded_d = (cpu || built_in) && is_last;
    count_d = count_q;
    if (loaded_q) count_d = '0;
    else if (cpu || built_in) count_d = count_q + 1'b1;
    fault_d = (cpu && (is_last ? 32'(sphere_i[7:4]) >= TableEntries : too_high))
        || (waiting_q && !valid_i);
    taken_d = valid_i && (taken_q || cpu);
    answered_d = answered_q || cpu;
    patience_d = patience_q;
    if (listens)
      patience_d = {patience_q[PatienceBits-2:0], ~(patience_q[16] ^ patience_q[13])};
    expired_d = expired_q || (listens && patience_q == LastPatience);
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      {waiting_q, taken_q, answered_q, expired_q, loaded_q, fault_q, write_q} <= '0;
      patience_q <= '0;
      {count_q, index_q, last_q} <= '0;
      entry_q <= '0;
    end else begin
      waiting_q <= valid_i && !taken_d;
      taken_q <= taken_d;
      answered_q <= answered_d;
      expired_q <= expired_d;
      loaded_q <= loaded_d;
      fault_q <= fault_d;
      write_q <= write_d;
      patience_q <= patience_d;
      count_q <= count_d;
      index_q <= index_d;
      last_q <= last_d;
      entry_q <= entry_d;
    end
  end

  assign loaded_o = loaded_q;
  assign table_write_o = write_q;
  assign table_index_o = index_q;
  assign table_last_o = last_q;
  assign {table_centre_x_o, table_centre_y_o, table_centre_z_o, table_radius_o, table_radius2_o,
          table_inverse_o, table_reflect_o, table_is_light_o, table_red_o, table_green_o,
          table_blue_o} = entry_q;
  assign fault_o = fault_q;
endmodule

`default_nettype wire
