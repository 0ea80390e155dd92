// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/voxel_chip.h"

#include "sc/voxel/voxel_build.h"
#include "sc/voxel/voxel_parameters.h"

namespace racebeam {

voxel_chip::voxel_chip(const sc_core::sc_module_name& name, const voxel_knobs& k,
                       const unit_choices& choices)
    : voxel_chip(name, k, unit_maker(choices, voxel_parameters(k))) {}

voxel_chip::voxel_chip(const sc_core::sc_module_name& name, const voxel_knobs& k,
                       const unit_maker& units)
    : picture_chip(name, k.store(), voxel_knobs::clocks_per_pixel, units),
      u_voxel_builder(units.make<voxel_builder>(k)),
      u_column_memory("u_column_memory", k),
      u_occupancy_memory("u_occupancy_memory", k),
      u_voxel_scan(units.make<voxel_scan>(k)),
      u_voxel_camera(units.make<voxel_camera>()),
      u_voxel_walker(units.make<voxel_walker>(k)),
      u_voxel_setup(units.make<voxel_setup>()),
      u_voxel_limits(units.make<voxel_limits>()),
      u_voxel_address(units.make<voxel_address>(k)),
      u_voxel_leaf(units.make<voxel_leaf>(k)),
      u_voxel_shade(units.make<voxel_shade>(k)),
      knobs_(k),
      collector_(k) {
  bind_memories();
  bind_scan();
  bind_walker();
  bind_ray();
  bind_leaf();
  bind_shade();
}

voxel_chip::~voxel_chip() = default;

void voxel_chip::connect(const wired_chip::pins& bench) {
  picture_chip::connect(bench);
  host_ = std::make_unique<host_wires>();
  palette_write_i(host_->palette_write);
  palette_index_i(host_->palette_index);
  palette_colour_i(host_->palette_colour);
  column_write_i(host_->column_write);
  column_address_i(host_->column_address);
  column_data_i(host_->column_data);
  build_i(host_->build);
  rect_x_low_i(host_->rect_x_low);
  rect_y_low_i(host_->rect_y_low);
  rect_x_high_i(host_->rect_x_high);
  rect_y_high_i(host_->rect_y_high);
  built_o(host_->built);
  origin_i.bind(host_->origin);
  d00_i.bind(host_->d00);
  dx_i.bind(host_->dx);
  dy_i.bind(host_->dy);
  light_i.bind(host_->light);
  start_i(host_->start);
  picture_done_o(host_->picture_done);
}

void voxel_chip::begin_picture() {
  picture_chip::begin_picture();
  collector_.begin();
}

void voxel_chip::deposit(const std::vector<std::uint32_t>& all) {
  const voxel_world world(voxel_levels(knobs_), all);
  u_column_memory.words() = world.columns();
  u_occupancy_memory.words() = world.occupancy();
}

voxel_wires voxel_chip::wires() const {
  voxel_wires w;
  w.sends = palette_write_i.read() || column_write_i.read();
  w.build_columns = 0;
  if (build_i.read()) {
    const voxel_rectangle r{
        static_cast<int>(rect_x_low_i.value()), static_cast<int>(rect_y_low_i.value()),
        static_cast<int>(rect_x_high_i.value()), static_cast<int>(rect_y_high_i.value())};
    const voxel_rectangle all = voxel_aligned(r, voxel_levels(knobs_), 0);
    w.build_columns = static_cast<std::uint64_t>((all.x_high - all.x_low) * knobs_.voxel_x) *
                      static_cast<std::uint64_t>((all.y_high - all.y_low) * knobs_.voxel_y);
  }
  w.builder_state = static_cast<int>(builder_state.read().to_uint());
  w.scan_state = static_cast<int>(scan_state.read().to_uint());
  w.walker_state = static_cast<int>(walker_state.read().to_uint());
  w.level = static_cast<int>(level.read().to_uint());
  w.fetch = walk_read.read();
  w.sample = sample.read();
  w.column_read = shade_read.read();
  w.ray_done = ray_done.read();
  w.kind = static_cast<int>(kind.read().to_uint());
  w.store = stored(put_valid.read());
  return w;
}

std::unique_ptr<wired_chip> make_voxel_chip(const char* name, const knob_values& k,
                                            const scene_tables*, const unit_choices& choices) {
  return std::make_unique<voxel_chip>(name, k, choices);
}

}  // namespace racebeam
