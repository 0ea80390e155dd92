// The table of the sphere chip's wires: what drives each unit's ports, and what reads them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/sphere_chip.h"

namespace racebeam {

void sphere_chip::bind_inputs() {
  {
    auto& u = *u_sphere_inputs;
    u.clk_i(clk_i);
    u.rst_ni(rst_ni);
    u.rst_no(rst_n);
    u.sw_i(sw_i);
    u.key_ni(key_ni);
    u.rotz_o(rotz_o);
    u.picture_done_i(picture_done);
    u.origin_o.bind(origin);
    u.light_o.bind(light);
    u.max_reflections_o(max_reflections);
    u.alias_o(aliasing);
    u.narrow_o(narrow);
    u.planes_o(planes);
    u.screen_o(screen);
    u.scene_o(scene);
  }
  {
    auto& u = *u_sphere_host_link;
    u.clk_i(clk_i);
    u.rst_ni(rst_n);
    u.sphere_i(sphere_i);
    u.color_i(color_i);
    u.x1_i(x1_i);
    u.y1_i(y1_i);
    u.z1_i(z1_i);
    u.reflect_i(reflect_i);
    u.radius_i(radius_i);
    u.r2_i(r2_i);
    u.r_inv_i(r_inv_i);
    u.valid_i(valid_i);
    u.light_i.bind(light);
    u.scene_i(scene);
    u.host_i(done_o);
    u.loaded_o(loaded);
    u.table_write_o(table_write);
    u.table_index_o(table_index);
    u.table_last_o(table_last);
    u.table_centre_o.bind(table_centre);
    u.table_radius_o(table_radius);
    u.table_radius2_o(table_radius2);
    u.table_inverse_o(table_inverse);
    u.table_reflect_o(table_reflect);
    u.table_red_o(table_red);
    u.table_green_o(table_green);
    u.table_blue_o(table_blue);
    u.table_is_light_o(table_is_light);
    u.fault_o(fault);
  }
}

void sphere_chip::bind_tables() {
  {
    auto& u = *u_sphere_table;
    u.clk_i(clk_i);
    u.table_write_i(table_write);
    u.table_index_i(table_index);
    u.table_last_i(table_last);
    u.table_centre_i.bind(table_centre);
    u.table_radius_i(table_radius);
    u.table_radius2_i(table_radius2);
    u.table_inverse_i(table_inverse);
    u.table_reflect_i(table_reflect);
    u.table_red_i(table_red);
    u.table_green_i(table_green);
    u.table_blue_i(table_blue);
    u.table_is_light_i(table_is_light);
    u.index_i(sphere_index);
    u.centre_o.bind(centre);
    u.radius_o(radius);
    u.radius2_o(radius2);
    u.inverse_o(inverse);
    u.reflect_o(sphere_reflect);
    u.red_o(sphere_red);
    u.green_o(sphere_green);
    u.blue_o(sphere_blue);
    u.is_light_o(is_light);
    u.last_o(sphere_last);
  }
  {
    auto& u = *u_plane_table;
    u.index_i(plane_index);
    u.normal_o.bind(normal);
    u.distance_o(distance);
    u.red_o(plane_red);
    u.green_o(plane_green);
    u.blue_o(plane_blue);
    u.reflect_o(plane_reflect);
    u.checker_o(plane_checker);
    u.limited_o(limited);
    u.limit_o.bind(limit);
    u.last_o(plane_last);
    u.empty_o(plane_empty);
  }
}

void sphere_chip::bind_arithmetic() {
  {
    auto& u = *u_sphere_raygen;
    u.x_i(x);
    u.y_i(tracer_y);
    u.sub_i(sub);
    u.direction_o.bind(direction);
    u.origin_i.bind(origin);
    u.screen_i(screen);
    u.narrow_i(narrow);
  }
  {
    auto& u = *u_vector_unit;
    u.op_i(op);
    u.a_i.bind(a);
    u.b_i.bind(b);
    u.s_i(s);
    u.product_o.bind(product);
    u.sum_o(sum);
    u.square_o(square);
  }
  {
    auto& u = *u_root_unit;
    u.clk_i(clk_i);
    u.rst_ni(rst_n);
    u.start_i(root_start);
    u.radicand_i(radicand);
    u.root_o(root);
    u.done_o(root_done);
  }
  {
    auto& u = *u_divider_unit;
    u.clk_i(clk_i);
    u.rst_ni(rst_n);
    u.start_i(divider_start);
    u.numerator_i.bind(numerator);
    u.denominator_i(denominator);
    u.quotient_o.bind(quotient);
    u.done_o(divider_done);
  }
  {
    auto& u = *u_sphere_shader;
    u.clk_i(clk_i);
    u.rst_ni(rst_n);
    u.op_i(shader_op);
    u.base_red_i(base_red);
    u.base_green_i(base_green);
    u.base_blue_i(base_blue);
    u.dark_i(dark);
    u.fraction_i(fraction);
    u.reflect_i(reflect);
    u.direct_i(direct);
    u.sub_i(sub);
    u.weight_o(weight);
    u.alias_i(aliasing);
    u.word_o(word);
  }
}

void sphere_chip::bind_tracer() {
  {
    auto& u = *u_sphere_tracer;
    u.clk_i(clk_i);
    u.rst_ni(rst_n);
    u.origin_i.bind(origin);
    u.light_i.bind(light);
    u.max_reflections_i(max_reflections);
    u.alias_i(aliasing);
    u.narrow_i(narrow);
    u.planes_i(planes);
    u.picture_done_o(picture_done);
    u.done_o(done_o);
    u.loaded_i(loaded);
    u.x_o(x);
    u.y_o(tracer_y);
    u.sub_o(sub);
    u.direction_i.bind(direction);
    u.sphere_index_o(sphere_index);
    u.centre_i.bind(centre);
    u.radius2_i(radius2);
    u.inverse_i(inverse);
    u.sphere_reflect_i(sphere_reflect);
    u.sphere_red_i(sphere_red);
    u.sphere_green_i(sphere_green);
    u.sphere_blue_i(sphere_blue);
    u.is_light_i(is_light);
    u.sphere_last_i(sphere_last);
    u.plane_index_o(plane_index);
    u.normal_i.bind(normal);
    u.distance_i(distance);
    u.plane_red_i(plane_red);
    u.plane_green_i(plane_green);
    u.plane_blue_i(plane_blue);
    u.plane_reflect_i(plane_reflect);
    u.checker_i(plane_checker);
    u.limited_i(limited);
    u.limit_i.bind(limit);
    u.plane_last_i(plane_last);
    u.plane_empty_i(plane_empty);
    u.op_o(op);
    u.a_o.bind(a);
    u.b_o.bind(b);
    u.s_o(s);
    u.product_i.bind(product);
    u.sum_i(sum);
    u.square_i(square);
    u.root_start_o(root_start);
    u.radicand_o(radicand);
    u.root_i(root);
    bind_channel(stalls_, u.root_done_i, root_done);
    u.divider_start_o(divider_start);
    u.numerator_o.bind(numerator);
    u.denominator_o(denominator);
    u.quotient_i.bind(quotient);
    bind_channel(stalls_, u.divider_done_i, divider_done);
    u.shader_op_o(shader_op);
    u.base_red_o(base_red);
    u.base_green_o(base_green);
    u.base_blue_o(base_blue);
    u.dark_o(dark);
    u.fraction_o(fraction);
    u.reflect_o(reflect);
    u.direct_o(direct);
    u.weight_i(weight);
    u.word_valid_o(word_valid);
    u.word_address_o(word_address);
    bind_channel(stalls_, u.word_ready_i, delayed(delays_, u.word_ready_i, put_ready));
    u.state_o(state);
  }
}

void sphere_chip::bind_buffer() {
  auto& u = *u_write_buffer;
  u.rst_ni(rst_n);
  bind_channel(stalls_, u.put_valid_i, delayed(delays_, u.put_valid_i, word_valid));
  u.put_address_i(delayed(delays_, u.put_address_i, word_address));
  u.put_data_i(delayed(delays_, u.put_data_i, word));
}

}  // namespace racebeam
