// What `racebeam trace` was asked for: checked, and the parts of the show that follow from it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tb/base/errors.h"
#include "tb/show/run.h"
#include "tb/trace/signal_trace.h"
#include "tb/trace/trace_window.h"
#include "tb/tt/tt_options.h"
#include "tb/twin/channels.h"
#include "tb/twin/delays.h"

namespace racebeam {

/// Instead of a trigger of the chip: what a unit in lockstep finds.
constexpr const char* Mismatch = "mismatch";

/// The command line as it was written.
/// `scene` may also be a waveform to draw; level tlm: transactions.
struct TraceOptions : RunOptions, TtOptions, ShakeOptions, DelayOptions {
  TraceOptions() { level = LevelSignal; }

  std::string output, from, to;
  std::string picture;                 ///< SVG
  std::string around;                  ///< a trigger, or empty
  std::string when;                    ///< a condition, or empty
  std::optional<long long> lines;      ///< before and after it; 1
  std::optional<long long> pixels;     ///< from --from on, instead of --to
  std::optional<long long> pre, post;  ///< clocks before and after it instead
  long long record = 0;                ///< lines that a flight recorder keeps; 0: none
  std::vector<std::string> scopes;     ///< patterns of paths
  long long depth = 0;
  std::vector<std::string> diff;  ///< two files to compare instead of a scene
  bool shared = false;            ///< --diff: compare what both have

  /// Something says what a run of the chip is to do, or how it is written: it means nothing for
  /// waveforms that are there already.
  bool needs_run() const;
  /// Throws UsageError.
  TraceSelection selection() const;
  /// Throws UsageError unless a scene can be traced so, and MissingTool.
  void check(const Raster& raster) const;

  bool transactions() const;
  /// Something is to be found first: the window follows from it.
  bool searches() const;
  /// It is found by running the chip, not by the cores alone.
  bool watches() const;
  bool awaits_mismatch() const;
  /// The part of the show that is searched: to the end of the frame unless --to says more.
  TraceWindow searched(const TraceWindowReader& reader) const;
  /// What is to be written around what was found.
  TraceWindow around_point(const TracePoint& point, const TraceWindowReader& reader,
                           const Raster& raster) const;
  /// Clocks before it that this may ask for, and of the whole window.
  long long clocks_before(const Raster& raster) const;
  long long most_clocks(const Raster& raster) const;
  UsageError nothing_found(const TraceWindow& where, const TraceAxis& raster) const;
  /// The one that --from, --to and --pixels say.
  TraceWindow said(const TraceWindowReader& reader) const;

 private:
  void check_files() const;
  void check_level() const;
  void check_search() const;
  long long lines_around() const;
};

}  // namespace racebeam
