// sphere_tracer on the bench, with the cores of the units around it; rays of any pixel are given to
// it as those of its first one.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sc/sphere/divider_unit_core.h"
#include "sc/sphere/root_unit_core.h"
#include "sc/sphere/sphere_inputs_core.h"
#include "sc/sphere/sphere_raygen_core.h"
#include "sc/sphere/sphere_shader_core.h"
#include "sc/sphere/sphere_table_core.h"
#include "sc/sphere/sphere_tracer.h"
#include "sc/sphere/vector_unit_core.h"
#include "tb/twin/unit_bench.h"

namespace racebeam {

template <class Unit>
class TracerBench {
 public:
  /// In the first clock of RAY.
  TracerBench(const sphere_knobs& k, const std::vector<sphere_row>& spheres,
              const std::vector<plane_row>& planes)
      : knobs(k), planes(planes), unit("dut", k), bench(unit) {
    inputs.clock({false, 1 << 5, 15, false}, {});
    const int last = static_cast<int>(spheres.size());
    for (int n = 0; n < last; ++n)
      table.clock({true, n, last, spheres[static_cast<std::size_t>(n)]}, k);
    table.clock({true, last, last, sphere_row::light(inputs.light_q)}, k);
    clock();
    bench["rst_ni"].drive(1);
    bench["loaded_i"].drive(1);
    bench["word_ready_i"].drive(1);
    clock();
    bench["loaded_i"].drive(0);
  }

  /// The clocks of a pixel; the states in which it was are in `states`, the word in `word`.
  int pixel(int x, int y) {
    x_ = x;
    y_ = y;
    states.clear();
    int clocks = 0;
    for (bool last = false; !last && clocks < 5000; ++clocks) {
      settle();
      states.push_back(value("state_o"));
      last = states.back() == SphereNext && value("word_valid_o") && value("word_ready_i");
      if (value("word_valid_o")) {
        word = shader.word(value("sub_o"), inputs.alias_q, knobs);
        ++offers;
      }
      clock();
    }
    return clocks;
  }

  /// All wires of this clock.
  void settle() {
    axes3("origin", inputs.origin_q);
    axes3("light", inputs.light_q);
    set("max_reflections_i", inputs.max_reflections_q);
    set("alias_i", inputs.alias_q);
    set("narrow_i", inputs.narrow_q);
    set("planes_i", inputs.planes_q);
    set("sphere_last_i", table.last_q);
    set("plane_last_i", plane_table_core::last(planes));
    set("plane_empty_i", planes.empty());
    set("root_i", root.root_q);
    set("root_done_i", root.done_q);
    axes3("quotient", divider.quotient());
    set("divider_done_i", divider.done_q);
    bench.settle();
    axes3("direction",
          sphere_raygen_core::comb(
              {x_, y_, value("sub_o"), inputs.origin_q, inputs.screen_q, inputs.narrow_q}, knobs));
    const sphere_row& s = table.row(value("sphere_index_o"));
    axes3("centre", s.centre);
    set("radius2_i", s.radius2);
    set("inverse_i", s.inverse);
    set("sphere_reflect_i", s.reflect);
    colour("sphere_", s.colour);
    set("is_light_i", s.is_light);
    const plane_row& p = plane_table_core::row(planes, value("plane_index_o"));
    axes3("normal", p.normal);
    set("distance_i", p.distance);
    colour("plane_", p.colour);
    set("plane_reflect_i", p.reflect);
    set("checker_i", p.checker);
    set("limited_i", p.limited);
    axes3("limit", p.limit);
    set("weight_i", shader.weight(value("reflect_o")));
    bench.settle();
    const auto o = vector_unit_core::comb({value("op_o"), bench.read("a"), bench.read("b"),
                                           static_cast<int>(bench["s_o"].signed_value())});
    axes3("product", o.product);
    bench["sum_i"].drive(raw_bits(static_cast<std::uint64_t>(o.sum), 48));
    bench["square_i"].drive(raw_bits(static_cast<std::uint64_t>(o.square), 48));
    bench.settle();
  }
  void clock() {
    settle();
    const bool rst_n = value("rst_ni");
    root.clock({rst_n, value("root_start_o") != 0, value("radicand_o")}, knobs);
    divider.clock({rst_n,
                   value("divider_start_o") != 0,
                   {bench["numerator_x_o"].signed_value(), bench["numerator_y_o"].signed_value(),
                    bench["numerator_z_o"].signed_value()},
                   static_cast<int>(bench["denominator_o"].signed_value())},
                  knobs);
    shader.clock({rst_n,
                  value("shader_op_o"),
                  {value("base_red_o"), value("base_green_o"), value("base_blue_o")},
                  value("dark_o") != 0,
                  value("fraction_o"),
                  value("reflect_o"),
                  value("direct_o") != 0,
                  value("sub_o"),
                  inputs.alias_q});
    bench.clock();
  }
  int value(const char* port) { return static_cast<int>(bench[port].value()); }

  const sphere_knobs knobs;
  const std::vector<plane_row> planes;
  sphere_inputs_core inputs;
  sphere_table_core table;
  Unit unit;
  UnitBench bench;
  std::vector<int> states;
  std::uint64_t word = 0;
  int offers = 0;

 private:
  void set(const char* port, int value) {
    auto& pin = bench[port];
    pin.drive(raw_bits(static_cast<std::uint64_t>(value), pin.bits));
  }
  void axes3(const char* stem, const vec3& v) { bench.drive(stem, "_i", v); }
  void colour(const std::string& stem, const sphere_colour& c) {
    set((stem + "red_i").c_str(), c[0]);
    set((stem + "green_i").c_str(), c[1]);
    set((stem + "blue_i").c_str(), c[2]);
  }

  root_unit_core root;
  divider_unit_core divider;
  sphere_shader_core shader;
  int x_ = 0, y_ = 0;
};

}  // namespace racebeam
