// Delays: registers put into channels between units, as a file says that the program writes.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "sc/base/delay_plan.h"
#include "sc/base/engine.h"
#include "tb/twin/channels.h"

namespace racebeam {

/// What the command line says of delays.
struct DelayOptions {
  std::string delays;  ///< the file; empty: none

  /// " --delays F", for a command that repeats a run.
  std::string delays_text() const { return delays.empty() ? "" : " --delays " + delays; }
};

/// The file with all channels of an engine that may be delayed, none of them delayed.
std::string delays_template(const engine& built);

/// What a file says, channels without latency left out; nullptr: nothing is delayed. Throws
/// UsageError with all that is wrong in it.
std::shared_ptr<const delay_plan> delay_plan_of(const engine& built, const DelayOptions& options);

/// The channel of an engine with so many clocks in it, and an entry for each and one more, so that
/// there may be an offer in each clock. Throws UsageError if it may not be delayed.
delay_plan::channel delayed_channel(const engine& built, const std::string& name, int latency);

/// With delays: all units wired in our RTL are not compared, as they have no registers; `words` are
/// the units as they were written. A user's may have them. Throws UsageError if the options stall,
/// or name ours.
void check_delays(const engine& built, const DelayOptions& options, const ShakeOptions& shake,
                  const std::vector<std::string>& words, unit_choices& choices);

}  // namespace racebeam
