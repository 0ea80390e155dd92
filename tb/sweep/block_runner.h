// BlockRunner: does blocks in workers, some at once, and hands on what they answer.
//
// A worker that dies, hangs or talks garbage loses nothing but its time: what it has answered is
// handed on, and another one gets the rest. If that ends at the same frame, the point fails.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <functional>
#include <list>
#include <string>
#include <vector>

#include "tb/sweep/block.h"
#include "tb/sweep/fork_server.h"

namespace racebeam {

class BlockRunner {
 public:
  using Seconds = std::chrono::duration<double>;

  /// What becomes of blocks. What these throw ends the run.
  struct Owner {
    virtual ~Owner() = default;
    /// Before a worker gets it; what it needs may be put into it.
    virtual void prepare(Block& block) = 0;
    /// Answered frames: of a whole block, or of one whose worker is gone.
    virtual void take(const Block& block, const std::vector<Answer>& answers) = 0;
    /// Its point cannot be measured. `words`: what the worker said last.
    virtual void fail(const Block& block, const std::string& reason, const std::string& words) = 0;
    /// Ten times a second at least.
    virtual void look() = 0;
  };

  /// So many workers at once; one that says nothing for `patience`, or for 20 times its slowest
  /// frame if that is longer, hangs.
  BlockRunner(ForkServer& server, int jobs, Owner& owner, Seconds patience = Seconds(30));
  /// Kills the workers that run.
  ~BlockRunner();

  /// Does all of them, in their order; false if it was interrupted: those that ran were finished.
  bool run(std::list<Block> blocks);

 private:
  struct Job;
  void start(Block block);
  void listen();
  /// False once its worker is gone.
  bool read_lines(Job& job);
  void take_line(Job& job, const std::string& line);
  void end(Job& job);
  Seconds patience() const;

  ForkServer& server_;
  const int jobs_;
  Owner& owner_;
  const Seconds patience_;
  Seconds slowest_{};
  std::list<Block> waiting_;
  std::list<Job> running_;
};

}  // namespace racebeam
