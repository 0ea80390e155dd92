// sphere_top: all units of the sphere tracer wired under one clock; the frame memory is outside.
// Contract: sc/sphere/sphere_chip.h, whose wires these are.
//
// No arithmetic: a wire has the name of the port that drives it, without its suffix, but for
// aliasing and plane_checker: SystemVerilog keeps alias and checker for itself. The raster and the
// beam's side of the frame store follow rst_ni, all other units the board's reset.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module sphere_top #(
    parameter PlaneFile = "",  // as plane_table has them: a string
    parameter int Planes = 0
) (
    // Clock and reset
    input  wire logic clk_i,
    input  wire logic rst_ni,
    // Board
    input  wire logic [17:0] sw_i,
    input  wire logic [3:0] key_ni,
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
    output logic [7:0] rotz_o,
    output logic done_o,
    // frame_memory
    output logic mem_write_o,
    output logic [19:0] mem_address_o,
    output logic [63:0] mem_data_o,
    input  wire logic [63:0] mem_data_i,
    // Monitor
    output logic hsync_no,
    output logic vsync_no,
    output logic [9:0] red_o,
    output logic [9:0] green_o,
    output logic [9:0] blue_o
);
  /* verilator lint_off UNUSEDSIGNAL */  // some are for monitors and counters
  // sphere_inputs
  wire logic rst_n, narrow, planes, scene;
  wire logic [sphere_pkg::SphereBits-1:0] origin_x, origin_y, origin_z, light_x, light_y;
  wire logic [sphere_pkg::SphereBits-1:0] light_z, screen;
  wire logic [1:0] max_reflections, aliasing;
  // sphere_host_link
  wire logic loaded, table_write, table_is_light, fault;
  wire logic [sphere_pkg::SphereIndexBits-1:0] table_index, table_last;
  wire logic [sphere_pkg::SphereBits-1:0] table_centre_x, table_centre_y, table_centre_z;
  wire logic [sphere_pkg::SphereBits-1:0] table_radius2;
  wire logic [sphere_pkg::UnitBits-1:0] table_radius, table_inverse, table_reflect;
  wire logic [sphere_pkg::SphereColourBits-1:0] table_red, table_green, table_blue;
  // sphere_table
  wire logic [sphere_pkg::SphereBits-1:0] centre_x, centre_y, centre_z, radius2;
  wire logic [sphere_pkg::UnitBits-1:0] radius, inverse, sphere_reflect;
  wire logic [sphere_pkg::SphereColourBits-1:0] sphere_red, sphere_green, sphere_blue;
  wire logic is_light;
  wire logic [sphere_pkg::SphereIndexBits-1:0] sphere_last;
  // plane_table
  wire logic [sphere_pkg::SphereBits-1:0] normal_x, normal_y, normal_z, distance;
  wire logic [sphere_pkg::SphereColourBits-1:0] plane_red, plane_green, plane_blue;
  wire logic [sphere_pkg::UnitBits-1:0] plane_reflect, limit_x, limit_y, limit_z;
  wire logic [3:0] plane_checker;
  wire logic limited, plane_empty;
  wire logic [sphere_pkg::PlaneIndexBits-1:0] plane_last;
  // sphere_raygen
  wire logic [sphere_pkg::SphereBits-1:0] direction_x, direction_y, direction_z;
  // vector_unit
  wire logic [sphere_pkg::SphereBits-1:0] product_x, product_y, product_z;
  wire logic [sphere_pkg::SphereSumBits-1:0] sum, square;
  // root_unit
  wire logic [sphere_pkg::SphereBits-1:0] root;
  wire logic root_done;
  // divider_unit
  wire logic [sphere_pkg::SphereBits-1:0] quotient_x, quotient_y, quotient_z;
  wire logic divider_done;
  // sphere_tracer
  wire logic picture_done, done, root_start, divider_start, dark, direct, word_valid;
  wire logic [racebeam_pkg::PixelBits-1:0] x, tracer_y;
  wire logic [3:0] sub;
  wire logic [sphere_pkg::SphereIndexBits-1:0] sphere_index;
  wire logic [sphere_pkg::PlaneIndexBits-1:0] plane_index;
  wire logic [1:0] op;
  wire logic [sphere_pkg::SphereBits-1:0] a_x, a_y, a_z, b_x, b_y, b_z, s, radicand, denominator;
  wire logic [sphere_pkg::NumeratorBits-1:0] numerator_x, numerator_y, numerator_z;
  wire logic [2:0] shader_op;
  wire logic [sphere_pkg::SphereColourBits-1:0] base_red, base_green, base_blue;
  wire logic [sphere_pkg::UnitBits-1:0] fraction, reflect;
  wire logic [19:0] word_address;
  wire logic [sphere_pkg::SphereStateBits-1:0] state;
  // sphere_shader
  wire logic [sphere_pkg::UnitBits-1:0] weight;
  wire logic [63:0] word;
  // frame_store
  wire logic put_ready;
  /* verilator lint_on UNUSEDSIGNAL */

  assign done_o = done;

  sphere_inputs u_sphere_inputs (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .rst_no(rst_n),
      .sw_i(sw_i),
      .key_ni(key_ni),
      .rotz_o(rotz_o),
      .picture_done_i(picture_done),
      .origin_x_o(origin_x),
      .origin_y_o(origin_y),
      .origin_z_o(origin_z),
      .light_x_o(light_x),
      .light_y_o(light_y),
      .light_z_o(light_z),
      .max_reflections_o(max_reflections),
      .alias_o(aliasing),
      .narrow_o(narrow),
      .planes_o(planes),
      .screen_o(screen),
      .scene_o(scene)
  );

  sphere_host_link u_sphere_host_link (
      .clk_i(clk_i),
      .rst_ni(rst_n),
      .sphere_i(sphere_i),
      .color_i(color_i),
      .x1_i(x1_i),
      .y1_i(y1_i),
      .z1_i(z1_i),
      .reflect_i(reflect_i),
      .radius_i(radius_i),
      .r2_i(r2_i),
      .r_inv_i(r_inv_i),
      .valid_i(valid_i),
      .light_x_i(light_x),
      .light_y_i(light_y),
      .light_z_i(light_z),
      .scene_i(scene),
      .host_i(done),
      .loaded_o(loaded),
      .table_write_o(table_write),
      .table_index_o(table_index),
      .table_last_o(table_last),
      .table_centre_x_o(table_centre_x),
      .table_centre_y_o(table_centre_y),
      .table_centre_z_o(table_centre_z),
      .table_radius_o(table_radius),
      .table_radius2_o(table_radius2),
      .table_inverse_o(table_inverse),
      .table_reflect_o(table_reflect),
      .table_red_o(table_red),
      .table_green_o(table_green),
      .table_blue_o(table_blue),
      .table_is_light_o(table_is_light),
      .fault_o(fault)
  );

  sphere_table u_sphere_table (
      .clk_i(clk_i),
      .table_write_i(table_write),
      .table_index_i(table_index),
      .table_last_i(table_last),
      .table_centre_x_i(table_centre_x),
      .table_centre_y_i(table_centre_y),
      .table_centre_z_i(table_centre_z),
      .table_radius_i(table_radius),
      .table_radius2_i(table_radius2),
      .table_inverse_i(table_inverse),
      .table_reflect_i(table_reflect),
      .table_red_i(table_red),
      .table_green_i(table_green),
      .table_blue_i(table_blue),
      .table_is_light_i(table_is_light),
      .index_i(sphere_index),
      .centre_x_o(centre_x),
      .centre_y_o(centre_y),
      .centre_z_o(centre_z),
      .radius_o(radius),
      .radius2_o(radius2),
      .inverse_o(inverse),
      .reflect_o(sphere_reflect),
      .red_o(sphere_red),
      .green_o(sphere_green),
      .blue_o(sphere_blue),
      .is_light_o(is_light),
      .last_o(sphere_last)
  );

  plane_table #(
      .PlaneFile(PlaneFile),
      .Planes(Planes)
  ) u_plane_table (
      .index_i(plane_index),
      .normal_x_o(normal_x),
      .normal_y_o(normal_y),
      .normal_z_o(normal_z),
      .distance_o(distance),
      .red_o(plane_red),
      .green_o(plane_green),
      .blue_o(plane_blue),
      .reflect_o(plane_reflect),
      .checker_o(plane_checker),
      .limited_o(limited),
      .limit_x_o(limit_x),
      .limit_y_o(limit_y),
      .limit_z_o(limit_z),
      .last_o(plane_last),
      .empty_o(plane_empty)
  );

  sphere_raygen u_sphere_raygen (
      .x_i(x),
      .y_i(tracer_y),
      .sub_i(sub),
      .direction_x_o(direction_x),
      .direction_y_o(direction_y),
      .direction_z_o(direction_z),
      .origin_x_i(origin_x),
      .origin_y_i(origin_y),
      .origin_z_i(origin_z),
      .screen_i(screen),
      .narrow_i(narrow)
  );

  vector_unit u_vector_unit (
      .op_i(op),
      .a_x_i(a_x),
      .a_y_i(a_y),
      .a_z_i(a_z),
      .b_x_i(b_x),
      .b_y_i(b_y),
      .b_z_i(b_z),
      .s_i(s),
      .product_x_o(product_x),
      .product_y_o(product_y),
      .product_z_o(product_z),
      .sum_o(sum),
      .square_o(square)
  );

  root_unit u_root_unit (
      .clk_i(clk_i),
      .rst_ni(rst_n),
      .start_i(root_start),
      .radicand_i(radicand),
      .root_o(root),
      .done_o(root_done)
  );

  divider_unit u_divider_unit (
      .clk_i(clk_i),
      .rst_ni(rst_n),
      .start_i(divider_start),
      .numerator_x_i(numerator_x),
      .numerator_y_i(numerator_y),
      .numerator_z_i(numerator_z),
      .denominator_i(denominator),
      .quotient_x_o(quotient_x),
      .quotient_y_o(quotient_y),
      .quotient_z_o(quotient_z),
      .done_o(divider_done)
  );

  sphere_tracer u_sphere_tracer (
      .clk_i(clk_i),
      .rst_ni(rst_n),
      .origin_x_i(origin_x),
      .origin_y_i(origin_y),
      .origin_z_i(origin_z),
      .light_x_i(light_x),
      .light_y_i(light_y),
      .light_z_i(light_z),
      .max_reflections_i(max_reflections),
      .alias_i(aliasing),
      .narrow_i(narrow),
      .planes_i(planes),
      .picture_done_o(picture_done),
      .done_o(done),
      .loaded_i(loaded),
      .x_o(x),
      .y_o(tracer_y),
      .sub_o(sub),
      .direction_x_i(direction_x),
      .direction_y_i(direction_y),
      .direction_z_i(direction_z),
      .sphere_index_o(sphere_index),
      .centre_x_i(centre_x),
      .centre_y_i(centre_y),
      .centre_z_i(centre_z),
      .radius2_i(radius2),
      .inverse_i(inverse),
      .sphere_reflect_i(sphere_reflect),
      .sphere_red_i(sphere_red),
      .sphere_green_i(sphere_green),
      .sphere_blue_i(sphere_blue),
      .is_light_i(is_light),
      .sphere_last_i(sphere_last),
      .plane_index_o(plane_index),
      .normal_x_i(normal_x),
      .normal_y_i(normal_y),
      .normal_z_i(normal_z),
      .distance_i(distance),
      .plane_red_i(plane_red),
      .plane_green_i(plane_green),
      .plane_blue_i(plane_blue),
      .plane_reflect_i(plane_reflect),
      .checker_i(plane_checker),
      .limited_i(limited),
      .limit_x_i(limit_x),
      .limit_y_i(limit_y),
      .limit_z_i(limit_z),
      .plane_last_i(plane_last),
      .plane_empty_i(plane_empty),
      .op_o(op),
      .a_x_o(a_x),
      .a_y_o(a_y),
      .a_z_o(a_z),
      .b_x_o(b_x),
      .b_y_o(b_y),
      .b_z_o(b_z),
      .s_o(s),
      .product_x_i(product_x),
      .product_y_i(product_y),
      .product_z_i(product_z),
      .sum_i(sum),
      .square_i(square),
      .root_start_o(root_start),
      .radicand_o(radicand),
      .root_i(root),
      .root_done_i(root_done),
      .divider_start_o(divider_start),
      .numerator_x_o(numerator_x),
      .numerator_y_o(numerator_y),
      .numerator_z_o(numerator_z),
      .denominator_o(denominator),
      .quotient_x_i(quotient_x),
      .quotient_y_i(quotient_y),
      .quotient_z_i(quotient_z),
      .divider_done_i(divider_done),
      .shader_op_o(shader_op),
      .base_red_o(base_red),
      .base_green_o(base_green),
      .base_blue_o(base_blue),
      .dark_o(dark),
      .fraction_o(fraction),
      .reflect_o(reflect),
      .direct_o(direct),
      .weight_i(weight),
      .word_valid_o(word_valid),
      .word_address_o(word_address),
      .word_ready_i(put_ready),
      .state_o(state)
  );

  sphere_shader u_sphere_shader (
      .clk_i(clk_i),
      .rst_ni(rst_n),
      .op_i(shader_op),
      .base_red_i(base_red),
      .base_green_i(base_green),
      .base_blue_i(base_blue),
      .dark_i(dark),
      .fraction_i(fraction),
      .reflect_i(reflect),
      .direct_i(direct),
      .sub_i(sub),
      .weight_o(weight),
      .alias_i(aliasing),
      .word_o(word)
  );

  frame_store #(
      .ClocksPerPixel(1)
  ) u_frame_store (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .put_rst_ni(rst_n),
      .put_valid_i(word_valid),
      .put_address_i(word_address),
      .put_data_i(word),
      .put_ready_o(put_ready),
      .mem_write_o(mem_write_o),
      .mem_address_o(mem_address_o),
      .mem_data_o(mem_data_o),
      .mem_data_i(mem_data_i),
      .hsync_no(hsync_no),
      .vsync_no(vsync_no),
      .red_o(red_o),
      .green_o(green_o),
      .blue_o(blue_o)
  );
endmodule

`default_nettype wire
