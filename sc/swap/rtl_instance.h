// Verilated RTL joined to the pins of a unit.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "sc/swap/changed_ports.h"
#include "sc/swap/followed_inputs.h"
#include "sc/swap/rtl_back_door.h"
#include "sc/swap/rtl_library.h"
#include "sc/swap/rtl_parameters.h"
#include "sc/swap/rtl_rest.h"

namespace racebeam {

/// One instance of verilated RTL behind the ports of a module. Whatever simulates throws RtlFault.
class rtl_instance {
 public:
  /// Loads a plug-in and joins its ports to those of `pins` by name. Throws RtlError: no such file,
  /// no plug-in, another unit, missing, extra or wrongly sized ports, built with other
  /// parameters than `wanted`.
  rtl_instance(const std::string& plugin, const std::string& unit,
               const std::vector<any_port*>& pins, const std::vector<rtl_parameter>& wanted);

  /// Copies the inputs from the wires and lets combinational outputs follow.
  void settle();
  /// One rising edge with the inputs of the last settle().
  void edge();

  /// In a chip: the edge that is due; what settle() does; all outputs drive their wires; quiet
  /// inputs wait.
  void follow();
  /// In a chip: takes the quiet inputs, for a rising edge. Its outputs drive their wires, unless
  /// moved() tells that it is due, at once with the inputs that move after it. Throws RtlFault too
  /// if an output follows from a quiet input, as is looked for now and then.
  void clock();
  /// In a chip: an input has moved that reaches an output before the next edge, or an edge is due.
  const sc_core::sc_event& moved() const { return moved_; }

  /// The back doors of sequencer_pins and navigator_pins: the RTL gets there through its pins, in
  /// clocks of its own; to be followed by settle().
  void seek(int frame);
  void place(const vec3& position, int room);
  /// Edges of its own with these inputs, the others as they are; to be followed by settle().
  void private_edges(const input_values& inputs, int edges);

  /// A port or signal of the RTL.
  class value {
   public:
    explicit value(const rtl_port& port) : port_(&port) {}
    std::uint64_t read() const;
    /// The low bits of `value`.
    void write(std::uint64_t value) const;
    const char* name() const { return port_->name; }
    int bits() const { return port_->bits; }

   private:
    const rtl_port* port_;
  };

  /// An input or output of both sides; the clock is none of them.
  struct joint {
    any_port* pin;
    value rtl;
    wire_contents wire{};  ///< once it has settled
  };
  const std::vector<joint>& inputs() const { return inputs_; }
  const std::vector<joint>& outputs() const { return outputs_; }

  /// A signal inside racebeam_top, such as "u_stacks.sp_i". Throws RtlError.
  value signal(const std::string& name) const;
  /// All signals inside of RTL that was built with `--signals`; of other RTL none.
  std::vector<probe> probes() const;
  /// Writes a register inside racebeam_top; to be followed by settle(). Throws RtlError.
  void deposit(const std::string& signal, std::uint64_t value);

 private:
  void begin(sc_core::sc_event* moved);
  bool drive();
  void check_quiet();
  value port(const std::string& name) const;
  const rtl_model& model() const { return library_.model(); }

  // What each clock reads comes first, in few lines of the cache.
  alignas(64) rtl_library library_;
  followed_inputs wires_{library_.model()};
  changed_ports changes_;          // of the outputs
  std::vector<any_wire*> driven_;  // by them
  rtl_rest rest_;
  bool has_quiet_ = false;
  bool settled_ = false;   // the RTL has seen its inputs, and its outputs follow
  bool bound_ = false;     // the wires are known
  bool due_ = false;       // an edge is
  bool followed_ = false;  // since the last edge inputs have moved, as they may after the next one
  std::uint64_t edges_ = 0;
  sc_core::sc_event moved_;
  std::vector<joint> inputs_, outputs_;
};

}  // namespace racebeam
