// The table of the voxel chip's wires: what drives each unit's ports, and what reads them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/voxel_chip.h"

namespace racebeam {

void voxel_chip::bind_memories() {
  {
    auto& u = *u_voxel_builder;
    u.clk_i(clk_i);
    u.rst_ni(rst_ni);
    u.rect_x_low_i(rect_x_low_i);
    u.rect_y_low_i(rect_y_low_i);
    u.rect_x_high_i(rect_x_high_i);
    u.rect_y_high_i(rect_y_high_i);
    u.start_i(build_i);
    u.host_write_i(column_write_i);
    u.host_address_i(column_address_i);
    u.done_o(built_o);
    u.walk_read_i(walk_read);
    u.walk_address_i(word);
    u.leaf_read_i(shade_read);
    u.leaf_address_i(shade_address);
    u.column_read_o(column_read);
    u.column_write_o(column_write);
    u.column_address_o(column_address);
    u.column_data_i(column_word);
    u.occupancy_read_o(occupancy_read);
    u.occupancy_write_o(occupancy_write);
    u.occupancy_address_o(occupancy_address);
    u.occupancy_data_o(occupancy_data);
    u.occupancy_data_i(occupancy_word);
    u.columns_o(columns);
    u.state_o(builder_state);
  }
  {
    auto& u = u_column_memory;
    u.clk_i(clk_i);
    u.read_i(column_read);
    u.write_i(column_write);
    u.address_i(column_address);
    u.data_i(column_data_i);
    u.data_o(column_word);
  }
  {
    auto& u = u_occupancy_memory;
    u.clk_i(clk_i);
    u.read_i(occupancy_read);
    u.write_i(occupancy_write);
    u.address_i(occupancy_address);
    u.data_i(occupancy_data);
    u.data_o(occupancy_word);
  }
}

void voxel_chip::bind_scan() {
  {
    auto& u = *u_voxel_scan;
    u.clk_i(clk_i);
    u.rst_ni(rst_ni);
    u.start_i(start_i);
    u.picture_done_o(picture_done_o);
    u.camera_start_o(camera_start);
    u.next_pixel_o(next_pixel);
    u.next_line_o(next_line);
    u.start_o(start);
    u.shadow_o(shadow);
    u.ray_done_i(ray_done);
    u.kind_i(kind);
    u.max_outer_o(max_outer);
    u.max_inner_o(max_inner);
    u.take_o(take);
    u.shade_o(shade);
    u.shadowed_o(shadowed);
    bind_channel(stalls_, u.done_i, shade_done);
    u.colour_i(colour);
    u.put_valid_o(put_valid);
    u.put_address_o(put_address);
    u.put_data_o(put_data);
    bind_channel(stalls_, u.put_ready_i, delayed(delays_, u.put_ready_i, put_ready));
    u.state_o(scan_state);
  }
  {
    auto& u = *u_voxel_camera;
    u.clk_i(clk_i);
    u.d00_i.bind(d00_i);
    u.dx_i.bind(dx_i);
    u.dy_i.bind(dy_i);
    u.start_i(camera_start);
    u.next_pixel_i(next_pixel);
    u.next_line_i(next_line);
    u.direction_o.bind(direction);
  }
  {
    auto& u = *u_write_buffer;
    u.rst_ni(rst_ni);
    bind_channel(stalls_, u.put_valid_i, delayed(delays_, u.put_valid_i, put_valid));
    u.put_address_i(delayed(delays_, u.put_address_i, put_address));
    u.put_data_i(delayed(delays_, u.put_data_i, put_data));
  }
}

void voxel_chip::bind_walker() {
  auto& u = *u_voxel_walker;
  u.clk_i(clk_i);
  u.rst_ni(rst_ni);
  u.start_i(start);
  u.shadow_i(shadow);
  u.origin_i.bind(origin_i);
  u.light_i.bind(light_i);
  u.direction_i.bind(direction);
  u.setup_o(setup);
  u.inverse_i.bind(inverse);
  u.ray_o.bind(ray);
  u.from_o.bind(from);
  u.x_o(voxel_x);
  u.y_o(voxel_y);
  u.z_o(voxel_z);
  u.level_o(level);
  u.inside_i(inside);
  u.bit_i(bit);
  u.read_o(walk_read);
  u.data_i(occupancy_word);
  u.leaf_o(leaf);
  u.at_o(at);
  u.column_o(column);
  u.t_o(t);
  u.t_out_o(t_out);
  u.step_o(step);
  u.some_i(some);
  u.sample_i(sample);
  u.hit_i(leaf_hit);
  u.done_i(leaf_done);
  u.position_i.bind(position);
  u.outer_o(outer);
  u.inner_o(inner);
  u.reached_i(reached);
  u.ray_done_o(ray_done);
  u.kind_o(kind);
  u.hit_o.bind(hit_position);
  u.state_o(walker_state);
}

void voxel_chip::bind_ray() {
  {
    auto& u = *u_voxel_setup;
    u.clk_i(clk_i);
    u.rst_ni(rst_ni);
    u.start_i(setup);
    u.direction_i.bind(ray);
    u.inverse_o.bind(inverse);
    u.parallel_o(parallel);
    u.done_o(setup_done);
  }
  {
    auto& u = *u_voxel_limits;
    u.clk_i(clk_i);
    u.start_i(start);
    u.outer_i(outer);
    u.inner_i(inner);
    u.max_outer_i(max_outer);
    u.max_inner_i(max_inner);
    u.reached_o(reached);
  }
  {
    auto& u = *u_voxel_address;
    u.x_i(voxel_x);
    u.y_i(voxel_y);
    u.z_i(voxel_z);
    u.level_i(level);
    u.word_o(word);
    u.bit_o(bit);
    u.inside_o(inside);
  }
}

void voxel_chip::bind_leaf() {
  auto& u = *u_voxel_leaf;
  u.clk_i(clk_i);
  u.rst_ni(rst_ni);
  u.start_i(leaf);
  u.at_i(at);
  u.fetch_i(column);
  u.t_from_i(t);
  u.t_to_i(t_out);
  u.step_i(step);
  u.origin_i.bind(from);
  u.direction_i.bind(ray);
  u.stop_i(reached);
  u.data_i(column_word);
  u.read_o(leaf_read);
  u.address_o(leaf_address);
  u.some_o(some);
  u.sample_o(sample);
  u.hit_o(leaf_hit);
  u.done_o(leaf_done);
  u.t_o(leaf_t);
  u.samples_o(samples);
  u.position_o.bind(position);
}

void voxel_chip::bind_shade() {
  auto& u = *u_voxel_shade;
  u.clk_i(clk_i);
  u.rst_ni(rst_ni);
  u.palette_write_i(palette_write_i);
  u.palette_index_i(palette_index_i);
  u.palette_colour_i(palette_colour_i);
  u.take_i(take);
  u.shade_i(shade);
  u.shadowed_i(shadowed);
  u.kind_i(kind);
  u.hit_i.bind(hit_position);
  u.direction_z_i(direction.z);
  u.leaf_read_i(leaf_read);
  u.leaf_address_i(leaf_address);
  u.read_o(shade_read);
  u.address_o(shade_address);
  u.data_i(column_word);
  u.done_o(shade_done);
  u.colour_o(colour);
  bind_channel(stalls_, u.put_ready_i, delayed(delays_, u.put_ready_i, put_ready));
}

}  // namespace racebeam
