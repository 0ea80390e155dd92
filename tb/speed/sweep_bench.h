// SweepBench: sweeps in a folder of their own, run as a user runs them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/speed/program_run.h"
#include "tb/sweep/store.h"
#include "tb/sweep/sweep_plan.h"
#include "tb/verilate/cache_folder.h"

namespace racebeam {

class SweepBench {
 public:
  /// The sweep `text`, called so, in the folder of results `folder`.
  ProgramRun run(const std::string& text, const std::string& folder, int jobs = 1) const;
  /// From an empty folder.
  ProgramRun run_anew(const std::string& text, const std::string& folder, int jobs = 1) const;

  /// A folder of results as another one is, instead of what it was.
  void copy(const std::string& from, const std::string& to) const;

  SweepPlan plan(const std::string& text) const;
  std::string store_of(const std::string& folder) const;

  /// Gives all points of a sweep the frames that its base has in a folder.
  void fill(const std::string& text, const std::string& folder) const;
  /// Frames that the points of a sweep have taken, as its racing says; of `sample` each.
  std::int64_t frames_raced(const std::string& text, const std::string& folder, int sample) const;

  /// One `render` of the first `sample` frames of a sweep, with a knob set and without files; its
  /// statistics go nowhere.
  ProgramRun render(const std::string& text, int sample, const std::string& setting) const;

 private:
  std::string file_of(const std::string& text) const;

  const WorkFolder work_;
};

/// Processor seconds of this process so far.
double processor_seconds();

}  // namespace racebeam
