// ClusterRung: a plan that others work on, and how far they are.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <list>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tb/sweep/block_results.h"
#include "tb/sweep/block_runner.h"
#include "tb/sweep/rung_plan.h"
#include "tb/sweep/store.h"
#include "tb/sweep/sweep_plan.h"

namespace racebeam {

class ClusterRung {
 public:
  /// `plan` as it lies in the folder. What of it the sweep does not ask for any more is nobody's.
  ClusterRung(RungPlan plan, const std::string& folder, const SweepPlan& sweep);
  ClusterRung(const ClusterRung&) = delete;
  ClusterRung& operator=(const ClusterRung&) = delete;

  const RungPlan& plan() const { return plan_; }
  int blocks() const { return static_cast<int>(plan_.blocks.size()); }
  /// Takes what workers have answered since; what they could not do fails. Lines that are none of
  /// this plan's are told once.
  void collect(BlockRunner::Owner& owner);
  /// Blocks of which something is neither answered nor failed, in order.
  std::vector<int> open() const;
  /// Fails what of a block is open.
  void fail(int block, const std::string& reason, const std::string& words,
            BlockRunner::Owner& owner);
  /// Whether the plan has all frames of these, done or not.
  bool covers(const std::list<Block>& blocks) const;
  /// Takes away the frames that are answered or have failed, and blocks that have none left.
  void remove_settled(std::list<Block>& blocks) const;

  /// How often a block was queued, and in how many looks at the queue it was missing since.
  struct Task {
    int tries = 0, missing = 0;
    bool cancelled = false;
  };
  std::vector<Task> tasks;
  bool looked = false;  ///< at the queue
  int minutes = 10;     ///< that a task may take

  /// Among the notes of a store: which plan is worked on.
  void keep(NoteTable& notes, bool ended) const;

 private:
  struct Work {
    Block as;  ///< where it stands in the sweep now
    bool wanted = false, failed = false;
    std::string error{};  ///< a worker could not do it
    std::map<int, std::uint64_t> answered{};
    bool open() const { return wanted && !failed && answered.size() < as.frames.size(); }
  };
  using Answers = std::map<int, std::vector<Answer>>;
  using Key = std::tuple<int, int, bool, bool, bool>;
  static Key key(const Block& block);
  void hand_on(Answers& answers, BlockRunner::Owner& owner);

  const RungPlan plan_;
  ResultReader reader_;
  std::map<int, Work> works_;
  std::set<std::string> told_;
};

/// What keep() has kept.
struct KeptRung {
  int rung = 0;  ///< 0: there was none
  bool ended = true;
  std::vector<int> tries{};
};
KeptRung kept_rung(const NoteTable& notes);

/// What a frame takes in scenes of a sweep, by some that are rendered; all wait for them.
FrameSeconds timed_frames(const std::list<Block>& blocks, ForkServer& server);

}  // namespace racebeam
