// voxel_chip: the voxel tracer's units, wired with signals under one clock in front of a frame
// store; the `signal` level.
//
// Names are as picture_chip's. No logic of its own besides picture_chip's.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "sc/base/engine.h"
#include "sc/base/unit_choices.h"
#include "sc/store/picture_chip.h"
#include "sc/voxel/column_memory.h"
#include "sc/voxel/occupancy_memory.h"
#include "sc/voxel/voxel_address.h"
#include "sc/voxel/voxel_builder.h"
#include "sc/voxel/voxel_camera.h"
#include "sc/voxel/voxel_collector.h"
#include "sc/voxel/voxel_leaf.h"
#include "sc/voxel/voxel_limits.h"
#include "sc/voxel/voxel_scan.h"
#include "sc/voxel/voxel_setup.h"
#include "sc/voxel/voxel_shade.h"
#include "sc/voxel/voxel_tables.h"
#include "sc/voxel/voxel_walker.h"

namespace racebeam {

class voxel_chip final : public picture_chip {
 public:
  // The host
  in_port<1> palette_write_i{"palette_write_i"};
  in_port<VoxelPaletteBits> palette_index_i{"palette_index_i"};
  in_port<VoxelColourBits> palette_colour_i{"palette_colour_i"};
  in_port<1> column_write_i{"column_write_i"};
  in_port<VoxelColumnBits> column_address_i{"column_address_i"};
  in_port<VoxelMemoryBits> column_data_i{"column_data_i"};
  in_port<1> build_i{"build_i"};
  in_port<VoxelRectangleBits> rect_x_low_i{"rect_x_low_i"}, rect_y_low_i{"rect_y_low_i"};
  in_port<VoxelRectangleBits> rect_x_high_i{"rect_x_high_i"}, rect_y_high_i{"rect_y_high_i"};
  out_port<1> built_o{"built_o"};
  axes_in<VoxelPositionBits> origin_i{"origin", "_i"};
  axes_in<VoxelCameraBits> d00_i{"d00", "_i"}, dx_i{"dx", "_i"}, dy_i{"dy", "_i"};
  axes_in<VoxelDirectionBits> light_i{"light", "_i"};
  in_port<1> start_i{"start_i"};
  out_port<1> picture_done_o{"picture_done_o"};

  /// Throws RtlError if RTL that `choices` names does not fit.
  voxel_chip(const sc_core::sc_module_name& name, const voxel_knobs& k,
             const unit_choices& choices = {});
  ~voxel_chip() override;

  /// What the host has at the pins of a chip that a bench was connected to; at first, it is silent.
  struct host_wires {
    wire<1> palette_write{"palette_write"};
    wire<VoxelPaletteBits> palette_index{"palette_index"};
    wire<VoxelColourBits> palette_colour{"palette_colour"};
    wire<1> column_write{"column_write"};
    wire<VoxelColumnBits> column_address{"column_address"};
    wire<VoxelMemoryBits> column_data{"column_data"};
    wire<1> build{"build"};
    wire<VoxelRectangleBits> rect_x_low{"rect_x_low"}, rect_y_low{"rect_y_low"};
    wire<VoxelRectangleBits> rect_x_high{"rect_x_high"}, rect_y_high{"rect_y_high"};
    wire<1> built{"built"};
    axes_wire<VoxelPositionBits> origin{"origin"};
    axes_wire<VoxelCameraBits> d00{"d00"}, dx{"dx"}, dy{"dy"};
    axes_wire<VoxelDirectionBits> light{"light"};
    wire<1> start{"start"}, picture_done{"picture_done"};
  };
  host_wires& host() { return *host_; }

  void connect(const wired_chip::pins& bench) override;
  /// Nothing: the host sends all of a picture.
  void deposit(int) override {}
  void deposit_beside(const std::string&, rtl_instance&, int) const override {}
  /// Both memories as they are once all was built (back door).
  void deposit(const std::vector<std::uint32_t>& all);
  /// While no picture is drawn.
  void begin_picture() override;
  void count() override { collector_.observe(wires()); }
  /// Of the picture that was done last.
  frame_counts take_counts() override { return counted(collector_.last()); }

  /// The wires of the present clock, settled if called at its end.
  voxel_wires wires() const;
  const voxel_collector& collector() const { return collector_; }

  // voxel_builder
  wire<1> column_read{"column_read"}, column_write{"column_write"};
  wire<VoxelColumnBits> column_address{"column_address"};
  wire<1> occupancy_read{"occupancy_read"}, occupancy_write{"occupancy_write"};
  wire<VoxelWordBits> occupancy_address{"occupancy_address"};
  wire<VoxelMemoryBits> occupancy_data{"occupancy_data"};
  wire<32> columns{"columns"};
  wire<VoxelBuilderStateBits> builder_state{"builder_state"};
  // The memories
  wire<VoxelMemoryBits> column_word{"column_word"}, occupancy_word{"occupancy_word"};
  // voxel_scan
  wire<1> camera_start{"camera_start"}, next_pixel{"next_pixel"}, next_line{"next_line"};
  wire<1> start{"start"}, shadow{"shadow"};
  wire<VoxelLimitBits> max_outer{"max_outer"}, max_inner{"max_inner"};
  wire<1> take{"take"}, shade{"shade"}, shadowed{"shadowed"};
  wire<1> put_valid{"put_valid"};
  wire<StoreAddressBits> put_address{"put_address"};
  wire<StoreDataBits> put_data{"put_data"};
  wire<VoxelScanStateBits> scan_state{"scan_state"};
  // voxel_camera
  axes_wire<VoxelDirectionBits> direction{"direction"};
  // voxel_walker
  wire<1> setup{"setup"};
  axes_wire<VoxelDirectionBits> ray{"ray"};
  axes_wire<VoxelPositionBits> from{"from"};
  wire<VoxelCoordinateBits> voxel_x{"voxel_x"}, voxel_y{"voxel_y"}, voxel_z{"voxel_z"};
  wire<VoxelLevelBits> level{"level"};
  wire<1> walk_read{"walk_read"};
  wire<1> leaf{"leaf"}, at{"at"}, column{"column"};
  wire<VoxelTBits> t{"t"}, t_out{"t_out"}, step{"step"};
  wire<1> outer{"outer"}, inner{"inner"}, ray_done{"ray_done"};
  wire<VoxelKindBits> kind{"kind"};
  axes_wire<VoxelPositionBits> hit_position{"hit"};
  wire<VoxelStateBits> walker_state{"walker_state"};
  // voxel_setup
  axes_wire<VoxelInverseBits> inverse{"inverse"};
  wire<3> parallel{"parallel"};
  wire<1> setup_done{"setup_done"};
  // voxel_limits
  wire<1> reached{"reached"};
  // voxel_address
  wire<VoxelWordBits> word{"word"};
  wire<VoxelBitBits> bit{"bit"};
  wire<1> inside{"inside"};
  // voxel_leaf
  wire<1> leaf_read{"leaf_read"};
  wire<VoxelColumnBits> leaf_address{"leaf_address"};
  wire<1> some{"some"}, sample{"sample"}, leaf_hit{"leaf_hit"}, leaf_done{"leaf_done"};
  wire<VoxelTBits> leaf_t{"leaf_t"};
  wire<VoxelSampleBits> samples{"samples"};
  axes_wire<VoxelPositionBits> position{"position"};
  // voxel_shade
  wire<1> shade_read{"shade_read"};
  wire<VoxelColumnBits> shade_address{"shade_address"};
  wire<1> shade_done{"shade_done"};
  wire<VoxelColourBits> colour{"colour"};

  // Units
  const std::unique_ptr<voxel_builder_pins> u_voxel_builder;
  column_memory u_column_memory;
  occupancy_memory u_occupancy_memory;
  const std::unique_ptr<voxel_scan_pins> u_voxel_scan;
  const std::unique_ptr<voxel_camera_pins> u_voxel_camera;
  const std::unique_ptr<voxel_walker_pins> u_voxel_walker;
  const std::unique_ptr<voxel_setup_pins> u_voxel_setup;
  const std::unique_ptr<voxel_limits_pins> u_voxel_limits;
  const std::unique_ptr<voxel_address_pins> u_voxel_address;
  const std::unique_ptr<voxel_leaf_pins> u_voxel_leaf;
  const std::unique_ptr<voxel_shade_pins> u_voxel_shade;

 private:
  voxel_chip(const sc_core::sc_module_name& name, const voxel_knobs& k, const unit_maker& units);
  void bind_memories();
  void bind_scan();
  void bind_walker();
  void bind_ray();
  void bind_leaf();
  void bind_shade();

  const voxel_knobs knobs_;
  voxel_collector collector_;
  std::unique_ptr<host_wires> host_;
};

/// As a bench of any engine takes it. Throws RtlError.
std::unique_ptr<wired_chip> make_voxel_chip(const char* name, const knob_values& k,
                                            const scene_tables* scene, const unit_choices& choices);

}  // namespace racebeam
