// The table of the block chip's wires: what drives each unit's ports, and what reads them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_chip.h"

namespace racebeam {

void block_chip::bind_host() {
  {
    auto& u = *u_block_convert;
    u.clk_i(clk_i);
    u.rst_ni(rst_ni);
    u.valid_i(valid_i);
    u.float_i(float_i);
    u.field_i(field_i);
    u.index_i(index_i);
    u.ready_o(ready_o);
    u.write_o(write);
    u.field_o(field);
    u.index_o(index);
    u.fixed_o(fixed);
    u.eye_k_o(eye_k);
    u.eye_o.bind(eye);
    u.light_o.bind(light);
    u.start_o.bind(start);
  }
  {
    auto& u = *u_block_scheduler;
    u.clk_i(clk_i);
    u.rst_ni(rst_ni);
    u.start_i(start_i);
    u.width_i(width);
    u.height_i(height);
    u.done_o(done_o);
    u.job_valid_o(job_valid);
    u.job_x_o(job_x);
    u.job_y_o(job_y);
    u.job_ready_i(job_ready);
    u.busy_i(busy);
  }
}

void block_chip::bind_core(block_core_place& place) {
  auto& u = *place.u_block_core;
  u.clk_i(clk_i);
  u.rst_ni(rst_ni);
  u.job_valid_i(place.job_valid);
  u.job_x_i(job_x);
  u.job_y_i(job_y);
  bind_channel(stalls_, u.job_ready_o, place.job_ready);
  u.busy_o(place.busy);
  u.write_i(write);
  u.field_i(field);
  u.index_i(index);
  u.value_i(fixed);
  u.eye_k_i(eye_k);
  u.spheres_i(spheres_i);
  u.eye_i.bind(eye);
  u.light_i.bind(light);
  u.start_i.bind(start);
  u.ax_i(ax_i);
  u.ay_i(ay_i);
  u.cone_sine_i(cone_sine_i);
  u.cone_cosine2_i(cone_cosine2_i);
  bind_channel(stalls_, u.word_valid_o, place.word_valid);
  u.word_address_o(place.word_address);
  u.word_o(place.word);
  bind_channel(stalls_, u.word_ready_i, place.word_ready);
  u.state_o(place.state);
  u.event_o(place.event_told);
}

void block_chip::bind_bus() {
  {
    auto& u = *u_block_bus;
    u.clk_i(clk_i);
    u.rst_ni(rst_ni);
    u.word_valid_i(word_valid);
    u.word_ready_o(word_ready);
    u.core_o(core);
    u.bus_valid_o(bus_valid);
    bind_channel(stalls_, u.bus_ready_i, delayed(delays_, u.bus_ready_i, put_ready));
  }
  auto& u = *u_write_buffer;
  u.rst_ni(rst_ni);
  bind_channel(stalls_, u.put_valid_i, delayed(delays_, u.put_valid_i, bus_valid));
  u.put_address_i(delayed(delays_, u.put_address_i, put_address));
  u.put_data_i(delayed(delays_, u.put_data_i, put_data));
}

}  // namespace racebeam
