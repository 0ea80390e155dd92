// Plug-ins of verilated RTL: finding, loading, and joining one to the pins of a unit.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "sc/knobs.h"
#include "sc/rtl_model.h"
#include "sc/unit.h"

namespace racebeam {

/// RTL that cannot stand in a unit's place: what is wrong with it, and what to do.
class RtlError : public std::runtime_error {
 public:
  using runtime_error::runtime_error;
};

/// The plug-in of a unit's own RTL in the folder `rtl` beside the program, or, when installed, in
/// ../lib/racebeam. Where `k` asks for other parameters than it was built with, one with those,
/// built when it is asked for the first time. Throws RtlError.
std::string rtl_plugin_path(const std::string& unit, const knobs& k);

/// The parameters, "Name=value", that a plug-in was built with and `k` wants otherwise. Throws
/// RtlError.
std::vector<std::string> other_parameters(const std::string& plugin, const knobs& k);

/// Verilates RTL of a unit, the unit's own if there are no `sources`, into the plug-in `out`, with
/// parameters "Name=value". Throws RtlError with what Verilator says.
void build_rtl_plugin(const std::string& unit, std::vector<std::string> sources,
                      const std::vector<std::string>& parameters, const std::string& out);

/// The same of a whole chip, whose inputs, but `clk`, pass a register: they count one clock later.
void build_chip_plugin(const std::string& top, const std::vector<std::string>& sources,
                       const std::string& out);

/// A port by its name. Throws RtlError if there is none.
const rtl_port& rtl_port_of(const rtl_model& model, const std::string& name);

/// A port that RTL must have.
struct rtl_pin {
  std::string name;
  bool is_input;
  int bits;
};

/// What of the ports of `model` does not fit: missing, extra, wrongly sized, an input instead of an
/// output; a line of its own for each, empty if all fit.
std::string port_faults(const rtl_model& model, const std::vector<rtl_pin>& wanted);

/// One instance of what a plug-in holds, with the library that it lives in.
class rtl_library {
 public:
  /// Throws RtlError: no such file, or no plug-in.
  explicit rtl_library(const std::string& plugin);
  const rtl_model& model() const { return *model_; }

 private:
  std::shared_ptr<void> library_;
  std::unique_ptr<rtl_model, void (*)(rtl_model*)> model_;
};

/// One instance of verilated RTL behind the ports of a module.
class rtl_instance {
 public:
  /// Loads a plug-in and joins its ports to those of `pins` by name. Throws RtlError: no such file,
  /// no plug-in, another unit, missing, extra or wrongly sized ports, built for other knobs.
  rtl_instance(const std::string& plugin, const std::string& unit,
               const std::vector<any_port*>& pins, const knobs& k);

  /// Copies the inputs from the wires and lets combinational outputs follow.
  void settle();
  /// One rising edge with the inputs of the last settle().
  void edge();
  /// Drives the wires of all outputs.
  void drive();

  /// The back doors of sequencer_pins and navigator_pins: the RTL gets there through its pins, in
  /// clocks of its own; to be followed by settle().
  void seek(int frame);
  void place(const vec3& position, int room);

  /// A port or signal of the RTL.
  class value {
   public:
    explicit value(const rtl_port& port) : port_(&port) {}
    int read() const;
    /// The low bits of `value`.
    void write(int value) const;
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
    int last = NoValue;    ///< written to the RTL, or driven onto the wire
  };
  const std::vector<joint>& inputs() const { return inputs_; }
  const std::vector<joint>& outputs() const { return outputs_; }

  /// A signal inside racebeam_top, such as "u_stacks.sp_i". Throws RtlError.
  value signal(const std::string& name) const;
  /// Writes a register inside racebeam_top; to be followed by settle(). Throws RtlError.
  void deposit(const std::string& signal, int value);

 private:
  static constexpr int NoValue = -1;

  value port(const std::string& name) const;
  void evaluate() { model().eval(model().top); }
  void private_edges(const std::vector<std::pair<const char*, int>>& inputs, int edges);
  const rtl_model& model() const { return library_.model(); }

  rtl_library library_;
  std::vector<joint> inputs_, outputs_;
  std::uint8_t* clock_ = nullptr;  // nullptr: the unit has none
  bool settled_ = false;           // at least once
};

}  // namespace racebeam
