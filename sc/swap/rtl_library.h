// A plug-in of verilated RTL as a loaded library, and its table of ports.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "sc/swap/rtl_model.h"

namespace racebeam {

/// RTL that cannot stand in a unit's place: what is wrong with it, and what to do.
class RtlError : public std::runtime_error {
 public:
  using runtime_error::runtime_error;
};

/// RTL whose run is over: it has ended the simulation, its logic does not settle, it does not
/// return, it crashed, or it printed too much. Says which unit, where, and what the RTL said.
class RtlFault : public RtlError {
 public:
  using RtlError::RtlError;
};

/// Whether there is a port of this name.
bool has_rtl_port(const rtl_model& model, const std::string& name);
/// A port by its name. Throws RtlError if there is none.
const rtl_port& rtl_port_of(const rtl_model& model, const std::string& name);

/// "FILE:LINE" of the top module in the RTL's source.
std::string rtl_place(const rtl_model& model);

/// A port that RTL must have.
struct rtl_pin {
  std::string name;
  bool is_input;
  int bits;
  bool is_optional = false;
};

/// What of the ports of `model` does not fit: missing and not optional, extra, wrongly sized, an
/// input instead of an output; a line of its own for each, empty if all fit.
std::string port_faults(const rtl_model& model, const std::vector<rtl_pin>& wanted);

/// One instance of what a plug-in holds, with the library that it lives in.
class rtl_library {
 public:
  /// Throws RtlError: no such file, or no plug-in.
  explicit rtl_library(const std::string& plugin);
  const rtl_model& model() const { return *model_; }

  /// What quiet inputs have in their places.
  void copy_quiet() { model_->copy_quiet(model_->top); }
  /// The inputs have changed. Throws RtlFault.
  void eval() { evaluate(model_->eval); }
  /// Those have whose bits in rtl_model::moved are set. Throws RtlFault.
  void eval_moved() { evaluate(model_->eval_moved); }
  /// A whole clock; nothing without a clock. Throws RtlFault.
  void rise() {
    if (!model_->rise) return;
    evaluate(model_->rise);
    ++clocks_;
  }
  /// Whether a clock and inputs that change after it can be had at once.
  bool can_rise_and_eval() const { return model_->rise_and_eval != nullptr; }
  /// Both. Throws RtlFault.
  void rise_and_eval() {
    evaluate(model_->rise_and_eval);
    ++clocks_;
  }
  /// A clock that would change nothing.
  void pass() { ++clocks_; }

 private:
  void evaluate(void (*step)(void*));

  std::shared_ptr<void> library_;
  std::unique_ptr<rtl_model, void (*)(rtl_model*)> model_;
  std::uint64_t clocks_ = 0;
};

}  // namespace racebeam
