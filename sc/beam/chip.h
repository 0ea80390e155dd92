// chip: all units wired with signals under one clock; the `signal` level.
//
// The wiring has no arithmetic: a wire carries the name of the port that drives it, without its
// suffix. Instances are named u_<unit>. A scene_program puts timeline in the place of sequencer and
// scene_rom in the place of scene; nothing else knows the difference.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "sc/base/unit_choices.h"
#include "sc/base/wired_chip.h"
#include "sc/beam/camera_unit.h"
#include "sc/beam/chip_view.h"
#include "sc/beam/decision_datapath.h"
#include "sc/beam/interval_fifo.h"
#include "sc/beam/navigator.h"
#include "sc/beam/pixel_output.h"
#include "sc/beam/pwm_sound.h"
#include "sc/beam/ray_stepper.h"
#include "sc/beam/scene_rom.h"
#include "sc/beam/stacks.h"
#include "sc/beam/stats_collector.h"
#include "sc/beam/subdivider.h"
#include "sc/beam/timeline.h"
#include "sc/swap/channel_delays.h"
#include "sc/swap/channel_stalls.h"
#include "sc/video/vga_timing.h"

namespace racebeam {

class rtl_island;

class chip final : public wired_chip {
 public:
  // Pins
  in_port<1> clk_i{"clk_i"};
  in_port<1> rst_ni{"rst_ni"};
  in_port<3> speed_i{"speed_i"};
  in_port<1> no_interlace_i{"no_interlace_i"};
  out_port<8> uo_o{"uo_o"};  // {hsync, B0, G0, R0, vsync, B1, G1, R1}
  out_port<1> pwm_o{"pwm_o"};

  /// The chip with its own demo, or with a program, which must outlive it and fit `k`. Throws
  /// RtlError if RTL that `choices` names does not fit.
  chip(const sc_core::sc_module_name& name, const knobs& k, const scene_program* program = nullptr,
       const unit_choices& choices = {});
  ~chip() override;

  /// The wires of the present clock, settled if called at its end.
  chip_view view() const;
  /// timeline and scene_rom are in it.
  bool has_program() const { return program_; }

  void connect(const wired_chip::pins& bench) override;
  void set_pins() override;
  void deposit(int to) override;
  void deposit_beside(const std::string& unit, rtl_instance& rtl, int to) const override;
  void count() override { collector_.observe(view()); }
  frame_counts take_counts() override;

  // vga_timing
  wire<11> x2{"x2"};
  wire<10> y{"y"};
  wire<1> hsync_n{"hsync_n"}, vsync_n{"vsync_n"}, active{"active"}, h_active{"h_active"};
  wire<1> consume{"consume"}, line_end{"line_end"}, active_start{"active_start"};
  wire<1> frame_end{"frame_end"}, nav_line{"nav_line"};
  // sequencer
  wire<AngleBits> angle{"angle"};
  wire<FrameBits> frame{"frame"};
  wire<6> scene_flags{"scene_flags"};
  wire<2> palette{"palette"};
  wire<ColoursBits> colours{"colours"};
  wire<1> shading_b{"shading_b"}, scene_interlace{"scene_interlace"}, lock{"lock"};
  wire<1> inverse{"inverse"}, nav_reset{"nav_reset"};
  axes_wire<NavigatorPortBits> start{"start"};
  wire<RoomPortBits> start_room{"start_room"};
  axes_wire<VelocityPortBits> velocity{"velocity"};
  // camera_unit
  wire<2> src{"src"};
  wire<1> run{"run"}, tracer_reset{"tracer_reset"};
  wire<1> load{"load"}, load_zero{"load_zero"}, ext{"ext"}, copy_ext{"copy_ext"},
      idx_load{"idx_load"};
  wire<3> ext_sign{"ext_sign"}, axis_mask{"axis_mask"};
  axes_wire<DdrPortBits> delta{"delta"};
  wire<PixelBits> idx_start{"idx_start"}, i2_init{"i2_init"};
  // ray_stepper
  axes_wire<DrPortBits> dr1{"dr1"}, dr2{"dr2"};
  // subdivider
  wire<2> state{"state"};
  wire<1> descend{"descend"}, climb{"climb"}, restart{"restart"}, emit{"emit"};
  wire<4> cur{"cur"};
  wire<2> leave{"leave"};
  wire<3> ray_signs{"ray_signs"};
  wire<PixelBits> len_m1{"len_m1"}, idx2{"idx2"}, i2{"i2"};
  wire<1> step{"step"}, neg{"neg"}, copy_sub{"copy_sub"}, push_en{"push_en"};
  wire<11> step_size{"step_size"};
  wire<StackPointerPortBits> sp{"sp"};
  wire<StackCountPortBits> sd{"sd"};
  wire<1> line_done{"line_done"};
  // stacks
  wire<TagPortBits> top_tag{"top_tag"};
  wire<PixelBits> top_i2{"top_i2"};
  wire<FacePortBits> fread{"fread"};
  // decision_datapath
  wire<4> dec{"dec"}, mask{"mask"};
  wire<TagPortBits> tag{"tag"};
  wire<1> wall{"wall"}, second{"second"}, fwrite{"fwrite"};
  wire<FacePortBits> fdata{"fdata"};
  wire<2> hit_face{"hit_face"};
  wire<RoomPortBits> room{"room"};
  wire<2> look_axis{"look_axis"}, look_way{"look_way"};
  wire<3> look_signs{"look_signs"};
  wire<PortalBits> look_portal{"look_portal"};
  axes_wire<CornerPortBits> corner{"corner"};
  // scene
  axes_wire<CornerPortBits> half_size{"half_size"}, position{"position"};
  wire<RoomPortBits> neighbour{"neighbour"};
  wire<PortalBits> back{"back"};
  wire<4> edges{"edges"};
  // navigator
  axes_wire<NavigatorPortBits> nav_position{"nav_position"};
  wire<RoomPortBits> nav_room{"nav_room"};
  wire<2> nav_axis{"nav_axis"};
  wire<PortalBits> nav_portal{"nav_portal"};
  wire<1> nav_negative{"nav_negative"}, nav_move{"nav_move"};
  wire<3> nav_op{"nav_op"};
  // interval_fifo, pixel_output
  wire<1> ack{"ack"}, starving{"starving"};
  wire<2> display{"display"}, value{"value"};
  wire<1> display_half{"display_half"}, half{"half"};
  wire<7> fill{"fill"};

  // Units
  const std::unique_ptr<vga_timing_pins> u_vga_timing;
  const std::unique_ptr<sequencer_pins> u_sequencer;
  const std::unique_ptr<camera_unit_pins> u_camera_unit;
  const std::unique_ptr<ray_stepper_pins> u_ray_stepper;
  const std::unique_ptr<subdivider_pins> u_subdivider;
  const std::unique_ptr<stacks_pins> u_stacks;
  const std::unique_ptr<decision_datapath_pins> u_decision_datapath;
  const std::unique_ptr<scene_pins> u_scene;
  const std::unique_ptr<navigator_pins> u_navigator;
  const std::unique_ptr<interval_fifo_pins> u_interval_fifo;
  const std::unique_ptr<pixel_output_pins> u_pixel_output;
  const std::unique_ptr<pwm_sound_pins> u_pwm_sound;

 private:
  const std::unique_ptr<channel_stalls> stalls_;
  const std::unique_ptr<channel_delays> delays_;

  void bind_raster_and_camera();
  void bind_tracer();
  void bind_output();

  const knobs knobs_;
  const scene_program* const program_;
  struct strap_wires;
  std::unique_ptr<strap_wires> straps_;  // pins that hold knobs
  stats_collector collector_;
  std::vector<std::unique_ptr<rtl_island>> islands_;
};

}  // namespace racebeam
