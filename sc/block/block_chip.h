// block_chip: the block renderer's units, wired with signals under one clock in front of a frame
// store; the `signal` level.
//
// Names are as picture_chip's, but for event_told: SystemVerilog keeps event for itself. A core and
// its wires are in g_core[n]. What all cores have of one
// bit stands in one word, core 0 at the bottom. The only logic of its own besides picture_chip's:
// bits of these words go to and come from the cores, and `put_address`, `put_data`, the word of the
// core that block_bus serves.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "sc/base/engine.h"
#include "sc/base/unit_choices.h"
#include "sc/block/block_bus.h"
#include "sc/block/block_collector.h"
#include "sc/block/block_convert.h"
#include "sc/block/block_core.h"
#include "sc/block/block_scheduler.h"
#include "sc/store/picture_chip.h"

namespace racebeam {

/// A core with its own wires.
class block_core_place : public sc_core::sc_module {
 public:
  block_core_place(const sc_core::sc_module_name& name, const block_knobs& k,
                   const unit_maker& units);

  wire<1> job_valid{"job_valid"}, job_ready{"job_ready"}, busy{"busy"};
  wire<1> word_valid{"word_valid"}, word_ready{"word_ready"};
  wire<BlockAddressBits> word_address{"word_address"};
  wire<StoreDataBits> word{"word"};
  wire<BlockStateBits> state{"state"};
  wire<BlockEventBits> event_told{"event_told"};

  const std::unique_ptr<block_core_pins> u_block_core;
};

class block_chip final : public picture_chip {
 public:
  // The host
  in_port<1> valid_i{"valid_i"};
  in_port<32> float_i{"float_i"};
  in_port<BlockFieldBits> field_i{"field_i"};
  in_port<BlockIndexBits> index_i{"index_i"};
  out_port<1> ready_o{"ready_o"};
  in_port<BlockCountBits> spheres_i{"spheres_i"};
  in_port<BlockBits> ax_i{"ax_i"}, ay_i{"ay_i"};
  in_port<BlockBits> cone_sine_i{"cone_sine_i"}, cone_cosine2_i{"cone_cosine2_i"};
  in_port<1> start_i{"start_i"};
  out_port<1> done_o{"done_o"};

  /// Throws RtlError if RTL that `choices` names does not fit.
  block_chip(const sc_core::sc_module_name& name, const block_knobs& k,
             const unit_choices& choices = {});
  ~block_chip() override;

  /// What the host has at the pins of a chip that a bench was connected to; at first, it is silent.
  struct host_wires {
    wire<1> valid{"valid"};
    wire<32> number{"float"};
    wire<BlockFieldBits> field{"field"};
    wire<BlockIndexBits> index{"index"};
    wire<1> ready{"ready"};
    wire<BlockCountBits> spheres{"spheres"};
    wire<BlockBits> ax{"ax"}, ay{"ay"};
    wire<BlockBits> cone_sine{"cone_sine"}, cone_cosine2{"cone_cosine2"};
    wire<1> start{"start"}, done{"done"};
  };
  host_wires& host() { return *host_; }

  void connect(const wired_chip::pins& bench) override;
  /// Nothing: the host sends all of a picture.
  void deposit(int) override {}
  void deposit_beside(const std::string&, rtl_instance&, int) const override {}
  /// While done_o is 1.
  void begin_picture() override;
  void count() override { collector_.observe(view()); }
  /// Of the picture that was done last.
  frame_counts take_counts() override { return counted(collector_.last()); }

  /// The wires of the present clock, settled if called at its end.
  block_view view() const;
  const block_collector& collector() const { return collector_; }

  // block_convert
  wire<1> write{"write"};
  wire<BlockFieldBits> field{"field"};
  wire<BlockIndexBits> index{"index"};
  wire<BlockBits> fixed{"fixed"}, eye_k{"eye_k"};
  axes_wire<BlockBits> eye{"eye"}, light{"light"}, start{"start"};
  // block_scheduler
  wire<BlockPlaceBits> width{"width"}, height{"height"};  // nothing drives them
  wire<BlockCores> job_valid{"job_valid"};
  wire<BlockPlaceBits> job_x{"job_x"}, job_y{"job_y"};
  // block_core
  wire<BlockCores> job_ready{"job_ready"}, busy{"busy"}, word_valid{"word_valid"};
  // block_bus
  wire<BlockCores> word_ready{"word_ready"};
  wire<1> bus_valid{"bus_valid"};
  wire<BlockIndexBits> core{"core"};
  wire<StoreAddressBits> put_address{"put_address"};
  wire<StoreDataBits> put_data{"put_data"};

  // Units
  const std::unique_ptr<block_convert_pins> u_block_convert;
  const std::unique_ptr<block_scheduler_pins> u_block_scheduler;
  std::vector<std::unique_ptr<block_core_place>> g_core;
  const std::unique_ptr<block_bus_pins> u_block_bus;

 private:
  block_chip(const sc_core::sc_module_name& name, const block_knobs& k, const unit_maker& units);
  void bind_host();
  void bind_core(block_core_place& place);
  void bind_bus();
  void part_jobs();
  void part_ready();
  void join();
  void choose_word();

  std::vector<sc_core::sc_event_or_list> chosen_events_;  // what put_address and put_data follow
  block_collector collector_;
  std::unique_ptr<host_wires> host_;
};

/// As a bench of any engine takes it. Throws RtlError.
std::unique_ptr<wired_chip> make_block_chip(const char* name, const knob_values& k,
                                            const scene_tables* scene, const unit_choices& choices);

}  // namespace racebeam
