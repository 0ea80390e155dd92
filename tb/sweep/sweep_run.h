// A sweep from its file to what it found: the frames of each rung, racing, guard frames, pictures.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace racebeam {

struct SweepOptions {
  std::string file;                      ///< the sweep
  std::string folder;                    ///< what it is kept in
  int jobs = 1;                          ///< workers at once
  std::vector<std::string> assignments;  ///< knob=value: what the file is narrowed to
  std::vector<std::string> reuse;        ///< folders of other sweeps, whose equal results are taken
  bool fresh = false;        ///< tries again what failed; another model may measure anew
  bool dry_run = false;      ///< says what it would do
  std::string on = "local";  ///< "slurm" or "hand": where points are measured
  std::string slurm;         ///< options for sbatch
  int tasks = 0;             ///< blocks of a rung there; 0: as long as is good
  bool wait = true;          ///< for them
  std::string command;       ///< that the user gave
};

/// Starts a sweep, or goes on. Says the plan on stderr and what it found on stdout. The exit code.
/// Throws UsageError, MissingTool, OutputError, NotDeterministic.
int run_sweep(const SweepOptions& options);

}  // namespace racebeam
