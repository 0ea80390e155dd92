// The handshakes between the units of each engine's chip, in one table: which may stall and, of
// those that may not, why; and which may have registers in them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sc/base/delay_plan.h"
#include "sc/base/engine.h"
#include "sc/base/stall_plan.h"

namespace racebeam {

/// What the command line says of stalls.
struct ShakeOptions {
  std::string shake;                ///< SEED[,BEGIN,GO_ON]; empty: nothing stalls
  std::vector<std::string> stalls;  ///< channels; empty: all that may

  /// " --shake 7,0.05,0.9 --stall word", for a command that repeats a run.
  std::string text() const;
};

struct ChannelRow {
  const char* name;
  const char* from;     ///< the unit that offers
  const char* to;       ///< the unit that takes
  const char* signals;  ///< wires, for people
  const char* why;      ///< it may stall: what makes that harmless; or it may not
  /// Empty: it may not stall.
  std::vector<stall_plan::port> ports{};
  const char* unless = "";  ///< as stall_plan has it
  /// No valid: no registers may be put into it, as it says here or, if nothing, in `why`.
  delay_plan::place delay{};
  const char* delay_why = "";  ///< what registers mean there; or why there may be none

  bool may_stall() const { return !ports.empty(); }
  bool may_delay() const { return !delay.valid.empty(); }
  std::string why_delay() const { return *delay_why ? delay_why : why; }
};

/// Of an engine, those of its frame store last.
std::vector<ChannelRow> channels_of(const engine& built);

/// A wire that makes colours a function of time while it is 1, whatever stalls; or nullptr.
const char* timed_wire(const engine& built);

/// nullptr: nothing stalls. Throws UsageError.
std::shared_ptr<const stall_plan> stall_plan_of(const engine& built, const ShakeOptions& options);

/// With stalls: all units wired in RTL are not compared, as nothing can be put into their wires;
/// `words` are the units as they were written. Throws UsageError if they name it.
void leave_out_whole_chip(const engine& built, const ShakeOptions& options,
                          const std::vector<std::string>& words, unit_choices& choices);

/// Channels of some engine that may stall.
std::vector<std::string> channel_names();

}  // namespace racebeam
