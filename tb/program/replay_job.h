// What a process of a replay of all frames does: some units on one part of the show, or gates of
// units on several parts at once.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "tb/base/file_lock.h"
#include "tb/program/replay_part.h"
#include "tb/program/verify_replay.h"

namespace racebeam {

/// A unit whose parts are kept.
struct KeptUnit {
  Replay what;
  TrafficHead head;
  std::string key;     ///< of what is compared
  std::string folder;  ///< of the parts
  std::unique_ptr<FileLock> lock;
};

struct ReplayJob {
  std::vector<ReplayPart> parts;
  std::vector<const KeptUnit*> units;
  bool in_parallel = false;  ///< else there is one part
};

/// For all parts that are not done, of units and parts that live as long. Gates that can be
/// replayed in parallel are, from eight parts on, in as many jobs as there are processes.
std::vector<ReplayJob> open_jobs(const std::vector<KeptUnit>& units,
                                 const std::vector<ReplayPart>& parts, std::size_t processes);

/// Does it, and writes the parts. `compared` gets the clocks of units. Throws what replayed() and
/// replayed_in_parallel() throw.
void do_job(const ReplayJob& job, std::atomic<std::uint64_t>& compared);

}  // namespace racebeam
