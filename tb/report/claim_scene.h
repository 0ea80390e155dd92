// ClaimScene: what claims have measured in one scene, and a sweep's folder that keeps it.
//
// The folder is one of `racebeam sweep`: its points are the chips that the claims are about, so
// `sweep` status, check and export read it. What is there is not measured again.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "tb/report/claim_golden.h"
#include "tb/report/claim_table.h"
#include "tb/sweep/fork_server.h"
#include "tb/sweep/provenance.h"
#include "tb/sweep/sweep_progress.h"
#include "tb/sweep/sweep_state.h"

namespace racebeam {

/// How claims are measured.
struct ClaimSetting {
  int frames = 256;                      ///< of each chip; 0: all
  int jobs = 1;                          ///< workers at once
  bool fresh = false;                    ///< of another model: keeps what is there, measures anew
  std::vector<std::string> base;         ///< knobs of all chips that a claim does not set itself
  std::string folder;                    ///< with a folder for each scene
  std::string command;                   ///< that the user gave
  static constexpr int GoldenMost = 64;  ///< frames of figures with golden tracers, at most
};

/// The servers of workers: to be made while the process is small.
struct ClaimWorkers {
  ForkServer& frames;  ///< work_on
  ForkServer& golden;  ///< answer_golden
};

class ClaimScene {
 public:
  /// `all`: the checks of all claims, also those that are not asked for now: they make the sweep.
  /// Throws what a run of a sweep throws.
  ClaimScene(const std::string& scene, const std::vector<const ClaimCheck*>& all,
             const ClaimSetting& setting, const ClaimWorkers& workers);

  /// What measure() shall bring.
  void want(const std::string& figure, const std::vector<std::string>& side);
  /// False: it was interrupted; what has been measured is kept.
  bool measure();

  /// Of what was wanted and measured. Empty: the chip could not be measured, as failure() says.
  Strata read(const std::string& figure, const std::vector<std::string>& side) const;
  std::string failure(const std::vector<std::string>& side) const;
  /// The knobs of a chip on this scene.
  const knob_values& knobs_of(const std::vector<std::string>& side) const;

  Store& store() { return store_; }

 private:
  using GoldenKey = std::pair<int, const GoldenSet*>;  // point, set

  std::size_t point_of(const std::vector<std::string>& side) const;
  std::vector<int> first_frames(int most) const;
  std::string note(int point, const GoldenSet& set, int frame) const;
  bool measure_golden();
  bool run_golden(const std::vector<GoldenRequest>& requests, const std::vector<GoldenKey>& keys);

  const ClaimSetting& setting_;
  ForkServer& golden_workers_;
  const SweepPlan plan_;
  SweepFolder folder_;
  Store store_;
  const std::int64_t model_;
  SweepProgress progress_;
  Measurer measurer_;
  SweepState state_;
  std::set<int> points_;
  std::set<GoldenKey> golden_;
};

}  // namespace racebeam
