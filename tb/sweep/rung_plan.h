// RungPlan: what workers on other machines are to do, as a file that never changes.
//
//   plan/1.json    {"schema": "racebeam-sweep-plan", "version": 1, "rung": 1, "model": HASH,
//                   "blocks": [[{"setting": HASH, "work": {...}}, ...], ...]}
//
// A block of a plan takes a minute or two: it is some blocks of work (block.h), of several points
// on the same frames, so that what a frame is compared with is made once.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <list>
#include <string>
#include <vector>

#include "tb/sweep/block.h"

namespace racebeam {

/// A block of work, whose number no other one of its plan has.
struct PlannedWork {
  Block work;
  std::string setting;  ///< what tells its point's results from others
};

struct RungPlan {
  int rung = 0;
  std::string model;  ///< the hash of who may work on it
  std::vector<std::vector<PlannedWork>> blocks;
  std::string hash{};  ///< of its text: what tells its results from those of other plans
};

/// What a frame of some work takes.
using FrameSeconds = std::function<double(const Block& work)>;

/// Divides work among so many blocks at most, that take about the same time.
std::vector<std::vector<PlannedWork>> divided(const std::vector<PlannedWork>& work, int blocks,
                                              const FrameSeconds& seconds);

/// The file of a plan, in the folder of a sweep.
std::string rung_file(int rung);
/// Writes it; its hash is set. Throws OutputError.
void keep_rung(const std::string& folder, RungPlan& plan);
/// Throws UsageError if there is none, or it is none.
RungPlan load_rung(const std::string& folder, int rung);

}  // namespace racebeam
