// The units that a ray goes through, wired with signals: all models, or all RTL. The memories are
// outside.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/voxel/voxel_address.h"
#include "sc/voxel/voxel_leaf.h"
#include "sc/voxel/voxel_limits.h"
#include "sc/voxel/voxel_setup.h"
#include "sc/voxel/voxel_walker.h"
#include "tests/voxel/twins.h"

namespace racebeam {

struct AllModels {
  template <class Unit>
  using of = Unit;
};
struct AllRtl {
  template <class Unit>
  using of = own_voxel_rtl<Unit>;
};

template <class Twins>
class WiredRays : public sc_core::sc_module {
  template <class Unit>
  using twin = typename Twins::template of<Unit>;

 public:
  // Clock and reset
  in_port<1> clk_i{"clk_i"};
  in_port<1> rst_ni{"rst_ni"};
  // A ray
  in_port<1> start_i{"start_i"};
  in_port<1> shadow_i{"shadow_i"};
  axes_in<VoxelPositionBits> origin_i{"origin", "_i"};
  axes_in<VoxelDirectionBits> light_i{"light", "_i"};
  axes_in<VoxelDirectionBits> direction_i{"direction", "_i"};
  in_port<VoxelLimitBits> max_outer_i{"max_outer_i"};
  in_port<VoxelLimitBits> max_inner_i{"max_inner_i"};
  out_port<1> ray_done_o{"ray_done_o"};
  out_port<VoxelKindBits> kind_o{"kind_o"};
  axes_out<VoxelPositionBits> hit_o{"hit", "_o"};
  out_port<VoxelStateBits> state_o{"state_o"};
  out_port<1> sample_o{"sample_o"};
  // Memories
  out_port<1> bits_read_o{"bits_read_o"};
  out_port<VoxelWordBits> bits_address_o{"bits_address_o"};
  in_port<VoxelMemoryBits> bits_data_i{"bits_data_i"};
  out_port<1> column_read_o{"column_read_o"};
  out_port<VoxelColumnBits> column_address_o{"column_address_o"};
  in_port<VoxelMemoryBits> column_data_i{"column_data_i"};

  WiredRays(const sc_core::sc_module_name& name, const voxel_knobs& k)
      : sc_module(name), walker_("walker", k), leaf_("leaf", k), address_("address", k) {
    bind_walker();
    bind_leaf();
    bind_others();
  }

 private:
  void bind_walker() {
    walker_.clk_i(clk_i), walker_.rst_ni(rst_ni);
    walker_.start_i(start_i), walker_.shadow_i(shadow_i);
    walker_.origin_i.bind(origin_i), walker_.light_i.bind(light_i);
    walker_.direction_i.bind(direction_i);
    walker_.setup_o(setup), walker_.inverse_i.bind(inverse);
    walker_.ray_o.bind(ray), walker_.from_o.bind(from);
    walker_.x_o(x), walker_.y_o(y), walker_.z_o(z), walker_.level_o(level);
    walker_.inside_i(inside), walker_.bit_i(bit);
    walker_.read_o(bits_read_o), walker_.data_i(bits_data_i);
    walker_.leaf_o(leaf), walker_.at_o(at), walker_.column_o(column);
    walker_.t_o(t), walker_.t_out_o(t_out), walker_.step_o(step);
    walker_.some_i(some), walker_.sample_i(sample), walker_.hit_i(hit), walker_.done_i(done);
    walker_.position_i.bind(position);
    walker_.outer_o(outer), walker_.inner_o(inner), walker_.reached_i(reached);
    walker_.ray_done_o(ray_done_o), walker_.kind_o(kind_o), walker_.hit_o.bind(hit_o);
    walker_.state_o(state_o);
  }
  void bind_leaf() {
    leaf_.clk_i(clk_i), leaf_.rst_ni(rst_ni);
    leaf_.start_i(leaf), leaf_.at_i(at), leaf_.fetch_i(column);
    leaf_.t_from_i(t), leaf_.t_to_i(t_out), leaf_.step_i(step);
    leaf_.origin_i.bind(from), leaf_.direction_i.bind(ray);
    leaf_.stop_i(reached);
    leaf_.data_i(column_data_i), leaf_.read_o(column_read_o), leaf_.address_o(column_address_o);
    leaf_.some_o(some), leaf_.sample_o(sample), leaf_.hit_o(hit), leaf_.done_o(done);
    leaf_.t_o(sample_t), leaf_.samples_o(samples), leaf_.position_o.bind(position);
    SC_HAS_PROCESS(WiredRays);
    SC_METHOD(show_sample);
    sensitive << sample;
  }
  void bind_others() {
    address_.x_i(x), address_.y_i(y), address_.z_i(z), address_.level_i(level);
    address_.word_o(bits_address_o), address_.bit_o(bit), address_.inside_o(inside);
    setup_.clk_i(clk_i), setup_.rst_ni(rst_ni);
    setup_.start_i(setup), setup_.direction_i.bind(ray), setup_.inverse_o.bind(inverse);
    setup_.parallel_o(parallel), setup_.done_o(set_up);
    limits_.clk_i(clk_i), limits_.start_i(setup), limits_.outer_i(outer), limits_.inner_i(inner);
    limits_.max_outer_i(max_outer_i), limits_.max_inner_i(max_inner_i);
    limits_.reached_o(reached);
  }
  void show_sample() { sample_o.drive(sample.read()); }

  wire<1> setup, inside, leaf, at, column, some, sample, hit, done, outer, inner, reached, set_up;
  axes_wire<VoxelInverseBits> inverse{"inverse"};
  axes_wire<VoxelDirectionBits> ray{"ray"};
  axes_wire<VoxelPositionBits> from{"from"}, position{"position"};
  wire<VoxelCoordinateBits> x, y, z;
  wire<VoxelLevelBits> level;
  wire<VoxelBitBits> bit;
  wire<VoxelTBits> t, t_out, step, sample_t;
  wire<VoxelSampleBits> samples;
  wire<3> parallel;

  twin<voxel_walker> walker_;
  twin<voxel_leaf> leaf_;
  twin<voxel_address> address_;
  twin<voxel_setup> setup_{"setup"};
  twin<voxel_limits> limits_{"limits"};
};

}  // namespace racebeam
