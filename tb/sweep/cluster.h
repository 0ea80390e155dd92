// Cluster: does blocks elsewhere: writes the plan of a rung, has it queued, and collects what
// workers answer, in this run of the program or a later one.
//
// A block is done when its lines are there, whatever the queue says. One that is neither done nor
// queued is queued again, three times at most; then its points fail. What somebody has cancelled
// waits for the same command.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tb/sweep/block_place.h"
#include "tb/sweep/cluster_rung.h"
#include "tb/sweep/slurm.h"
#include "tb/sweep/store.h"
#include "tb/sweep/sweep_folder.h"
#include "tb/sweep/sweep_plan.h"

namespace racebeam {

struct ClusterOptions {
  bool slurm = true;    ///< else workers are started by hand
  std::string options;  ///< for sbatch
  int tasks = 0;        ///< blocks of a rung; 0: so many that each takes 60 to 120 s
  bool wait = true;
};

class Cluster : public BlockPlace {
 public:
  /// All of it outlives this. Throws MissingTool.
  Cluster(const ClusterOptions& options, const SweepPlan& plan, const SweepFolder& folder,
          Store& store, ForkServer& server);

  bool run(std::list<Block> blocks, BlockRunner::Owner& owner) override;
  /// run() has left what is not done to others, as was asked.
  bool left() const { return left_; }

 private:
  using States = std::map<int, TaskState>;

  std::unique_ptr<ClusterRung> open_rung() const;
  std::unique_ptr<ClusterRung> new_rung(const std::list<Block>& blocks);
  bool bring(std::list<Block> blocks, BlockRunner::Owner& owner);
  bool finish(ClusterRung& rung, BlockRunner::Owner& owner);
  bool leave(const ClusterRung& rung);
  std::optional<States> states(const ClusterRung& rung);
  void look_after(ClusterRung& rung, const States& states, BlockRunner::Owner& owner);
  void submit(ClusterRung& rung, const std::vector<int>& blocks);
  void give_up(ClusterRung& rung, int block, BlockRunner::Owner& owner);
  std::string worker_command(const ClusterRung& rung, const std::string& program,
                             const std::string& block) const;
  std::string setting(const Block& block) const;

  const ClusterOptions options_;
  const SweepPlan& plan_;
  const SweepFolder& folder_;
  Store& store_;
  ForkServer& server_;
  std::optional<Slurm> slurm_;
  bool left_ = false;
  bool answered_ = false, accepted_ = false;  // by squeue and sbatch
  bool complained_ = false;
};

}  // namespace racebeam
