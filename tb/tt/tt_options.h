// The options of a Tiny Tapeout chip, which several commands share, and what they make ready.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "tb/tt/tt_inputs.h"
#include "tb/tt/tt_project.h"

namespace racebeam {

/// Frames of any chip: all up to the last that is wanted are simulated.
constexpr int MostTtFrames = 1'000'000;

/// The command line as it was written.
struct TtOptions {
  std::string project;               ///< project folder, instead of a scene; empty: there is none
  std::optional<long long> ui, uio;  ///< input pins from the reset on
  std::string inputs;                ///< file of inputs that change in time
  TtReading reading;                 ///< how the project is read
};

/// Of --ui, --uio and --inputs. Throws UsageError.
TtInputs tt_inputs(const TtOptions& options);

/// Throws UsageError if there is no --tt, but an option that means nothing without it.
void refuse_tt_options(const TtOptions& options);

/// Throws UsageError "--tt runs a chip of its own; leave out WHAT" if that is `given`.
void refuse_with_tt(bool given, const std::string& what);

}  // namespace racebeam
