// One evaluation of verilated RTL, and what can end it early.
//
// RTL is a guest in the process: it may end the simulation, print without end, never return, or
// crash. Each becomes an RtlFault of the program that evaluates it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "sc/swap/rtl_library.h"

namespace racebeam {

/// Calls step(model.top), in clock `clock` of that instance; one at a time in a process. Throws
/// RtlFault: the RTL ends the simulation, does not settle, has printed more than 10 MB in this
/// process, crashes, does not return within RACEBEAM_RTL_SECONDS (10) seconds of processor time, or
/// throws an exception. RTL that was left in the middle of the heap may have broken it: then
/// the program says so much and ends with 2.
void run_rtl(const rtl_model& model, std::uint64_t clock, void (*step)(void*));

/// How often run_rtl() was called in this process.
std::uint64_t rtl_evaluations();

/// What plug-ins are made with: what they print goes to stderr.
const rtl_host& rtl_run_host();

/// While it lives, it hears what RTL prints before that is printed. One at a time.
class RtlListener {
 public:
  /// `takes` one piece, mostly a line; true: it is not printed.
  explicit RtlListener(std::function<bool(const std::string& text)> takes);
  ~RtlListener();
  RtlListener(const RtlListener&) = delete;
  RtlListener& operator=(const RtlListener&) = delete;
};

/// For handlers of other signals than crashes: does not return if RTL is being evaluated; run_rtl()
/// then throws an RtlFault that names the signal.
void leave_rtl(int signal);

}  // namespace racebeam
