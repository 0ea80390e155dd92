// sphere_chip: the sphere tracer's units, wired with signals under one clock in front of a frame
// store; the `signal` level.
//
// Names are as picture_chip's, but for aliasing and plane_checker: SystemVerilog keeps alias and
// checker for itself. The raster and the frame store's beam side follow rst_ni, all other units
// u_sphere_inputs' rst_n.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sc/base/unit_choices.h"
#include "sc/sphere/divider_unit.h"
#include "sc/sphere/plane_table.h"
#include "sc/sphere/root_unit.h"
#include "sc/sphere/sphere_collector.h"
#include "sc/sphere/sphere_host_link.h"
#include "sc/sphere/sphere_inputs.h"
#include "sc/sphere/sphere_raygen.h"
#include "sc/sphere/sphere_shader.h"
#include "sc/sphere/sphere_table.h"
#include "sc/sphere/sphere_tracer.h"
#include "sc/sphere/vector_unit.h"
#include "sc/store/picture_chip.h"

namespace racebeam {

class sphere_chip final : public picture_chip {
 public:
  // The board
  in_port<18> sw_i{"sw_i"};
  in_port<4> key_ni{"key_ni"};
  // The CPU
  in_port<8> sphere_i{"sphere_i"};
  in_port<16> color_i{"color_i"};
  in_port<SphereBits> x1_i{"x1_i"}, y1_i{"y1_i"}, z1_i{"z1_i"};
  in_port<UnitBits> reflect_i{"reflect_i"}, radius_i{"radius_i"};
  in_port<SphereBits> r2_i{"r2_i"};
  in_port<UnitBits> r_inv_i{"r_inv_i"};
  in_port<1> valid_i{"valid_i"};
  out_port<8> rotz_o{"rotz_o"};
  out_port<1> done_o{"done_o"};

  /// `tables` must outlive it. Throws RtlError if RTL that `choices` names does not fit.
  sphere_chip(const sc_core::sc_module_name& name, const sphere_knobs& k,
              const sphere_tables& tables, const unit_choices& choices = {});
  ~sphere_chip() override;

  /// What the board has at the pins of a chip that a bench was connected to; at first, the
  /// switches and keys of the tables, and a CPU that is silent.
  struct board_wires {
    explicit board_wires(const sphere_board& board)
        : sw("sw", static_cast<unsigned>(board.sw)),
          key_n("key_n", static_cast<unsigned>(board.key_n)) {}
    wire<18> sw;
    wire<4> key_n;
    wire<8> sphere{"sphere"};
    wire<16> color{"color"};
    wire<SphereBits> x1{"x1"}, y1{"y1"}, z1{"z1"};
    wire<UnitBits> cpu_reflect{"cpu_reflect"}, cpu_radius{"cpu_radius"};
    wire<SphereBits> r2{"r2"};
    wire<UnitBits> r_inv{"r_inv"};
    wire<1> valid{"valid"};
    wire<8> rotz{"rotz"};
    wire<1> done{"done"};
  };
  board_wires& board() { return *board_; }
  const board_wires& board() const { return *board_; }

  void connect(const wired_chip::pins& bench) override;
  /// Eye, light, screen and modes of each picture, as the bench knows them.
  void remember(std::function<sphere_inputs_core(int picture)> inputs) {
    inputs_ = std::move(inputs);
  }
  /// Eye, light, screen and modes of a picture, in HOST before it; the table is the CPU's.
  void deposit(int picture) override;
  void deposit_beside(const std::string& unit, rtl_instance& rtl, int picture) const override;
  /// In HOST.
  void begin_picture() override;
  void count() override { collector_.observe(view()); }
  /// Of the picture that was done last.
  frame_counts take_counts() override;

  /// The wires of the present clock, settled if called at its end.
  sphere_view view() const;
  const sphere_collector& collector() const { return collector_; }

  // sphere_inputs
  wire<1> rst_n{"rst_n"};
  axes_wire<SphereBits> origin{"origin"}, light{"light"};
  wire<2> max_reflections{"max_reflections"}, aliasing{"aliasing"};
  wire<1> narrow{"narrow"}, planes{"planes"}, scene{"scene"};
  wire<SphereBits> screen{"screen"};
  // sphere_host_link
  wire<1> loaded{"loaded"}, table_write{"table_write"}, table_is_light{"table_is_light"};
  wire<1> fault{"fault"};
  wire<SphereIndexBits> table_index{"table_index"}, table_last{"table_last"};
  axes_wire<SphereBits> table_centre{"table_centre"};
  wire<UnitBits> table_radius{"table_radius"}, table_inverse{"table_inverse"},
      table_reflect{"table_reflect"};
  wire<SphereBits> table_radius2{"table_radius2"};
  wire<SphereColourBits> table_red{"table_red"}, table_green{"table_green"},
      table_blue{"table_blue"};
  // sphere_table
  axes_wire<SphereBits> centre{"centre"};
  wire<UnitBits> radius{"radius"}, inverse{"inverse"}, sphere_reflect{"sphere_reflect"};
  wire<SphereBits> radius2{"radius2"};
  wire<SphereColourBits> sphere_red{"sphere_red"}, sphere_green{"sphere_green"},
      sphere_blue{"sphere_blue"};
  wire<1> is_light{"is_light"};
  wire<SphereIndexBits> sphere_last{"sphere_last"};
  // plane_table
  axes_wire<SphereBits> normal{"normal"};
  wire<SphereBits> distance{"distance"};
  wire<SphereColourBits> plane_red{"plane_red"}, plane_green{"plane_green"},
      plane_blue{"plane_blue"};
  wire<UnitBits> plane_reflect{"plane_reflect"};
  wire<4> plane_checker{"plane_checker"};
  wire<1> limited{"limited"}, plane_empty{"plane_empty"};
  axes_wire<UnitBits> limit{"limit"};
  wire<PlaneIndexBits> plane_last{"plane_last"};
  // sphere_raygen, vector_unit, root_unit, divider_unit
  axes_wire<SphereBits> direction{"direction"}, product{"product"}, quotient{"quotient"};
  wire<SphereSumBits> sum{"sum"}, square{"square"};
  wire<SphereBits> root{"root"};
  wire<1> root_done{"root_done"}, divider_done{"divider_done"};
  // sphere_tracer
  wire<1> picture_done{"picture_done"};
  wire<PixelBits> x{"x"}, tracer_y{"tracer_y"};
  wire<4> sub{"sub"};
  wire<SphereIndexBits> sphere_index{"sphere_index"};
  wire<PlaneIndexBits> plane_index{"plane_index"};
  wire<2> op{"op"};
  axes_wire<SphereBits> a{"a"}, b{"b"};
  wire<SphereBits> s{"s"}, radicand{"radicand"}, denominator{"denominator"};
  wire<1> root_start{"root_start"}, divider_start{"divider_start"};
  axes_wire<NumeratorBits> numerator{"numerator"};
  wire<3> shader_op{"shader_op"};
  wire<SphereColourBits> base_red{"base_red"}, base_green{"base_green"}, base_blue{"base_blue"};
  wire<1> dark{"dark"}, direct{"direct"};
  wire<UnitBits> fraction{"fraction"}, reflect{"reflect"};
  wire<1> word_valid{"word_valid"};
  wire<StoreAddressBits> word_address{"word_address"};
  wire<SphereStateBits> state{"state"};
  // sphere_shader
  wire<UnitBits> weight{"weight"};
  wire<StoreDataBits> word{"word"};

 private:
  const sphere_knobs knobs_;
  const sphere_tables& tables_;
  std::function<sphere_inputs_core(int picture)> inputs_;

 public:
  // Units
  const std::unique_ptr<sphere_inputs_pins> u_sphere_inputs;
  const std::unique_ptr<sphere_host_link_pins> u_sphere_host_link;
  const std::unique_ptr<sphere_table_pins> u_sphere_table;
  const std::unique_ptr<plane_table_pins> u_plane_table;
  const std::unique_ptr<sphere_raygen_pins> u_sphere_raygen;
  const std::unique_ptr<vector_unit_pins> u_vector_unit;
  const std::unique_ptr<root_unit_pins> u_root_unit;
  const std::unique_ptr<divider_unit_pins> u_divider_unit;
  const std::unique_ptr<sphere_tracer_pins> u_sphere_tracer;
  const std::unique_ptr<sphere_shader_pins> u_sphere_shader;

 private:
  sphere_chip(const sc_core::sc_module_name& name, const sphere_knobs& k,
              const sphere_tables& tables, const unit_maker& units);
  void bind_inputs();
  void bind_tables();
  void bind_arithmetic();
  void bind_tracer();
  void bind_buffer();

  sphere_collector collector_;
  std::unique_ptr<board_wires> board_;
};

/// As a bench of any engine takes it; `scene` are sphere_tables, nullptr those of no file. Throws
/// RtlError.
std::unique_ptr<wired_chip> make_sphere_chip(const char* name, const knob_values& k,
                                             const scene_tables* scene,
                                             const unit_choices& choices);

}  // namespace racebeam
