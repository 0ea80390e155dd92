// `racebeam verify --replay`: recorded traffic into RTL without SystemC.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "tb/program/command_verify.h"
#include "tb/program/verify_unit.h"
#include "tb/twin/traffic_file.h"

namespace racebeam {

/// In the place of the file of a unit: its model.
constexpr const char* ModelPlayer = "model";

/// A unit that traffic is replayed into, and how the user said it.
struct Replay {
  const VerifyOptions& options;
  const Run& run;
  std::string word;    ///< "stacks", "stacks=mine.sv" or "stacks=model"
  UnitUnderTest dut;   ///< its plug-in, or ModelPlayer
  std::string folder;  ///< for waveforms
  std::string traffic = "replay";
  std::string gates{};     ///< for ParallelGates, if they can be replayed in parallel
  std::string captured{};  ///< with these options of `racebeam capture`, if there is no file

  std::string repeat() const;
};

/// The unit that `word` means, verilated, unless it has Replay::gates; `head`: whose traffic it
/// must be, in a file of VerifyOptions::replay, or nullptr. Throws UsageError, RtlError,
/// MissingTool.
Replay replay_of(const VerifyOptions& options, const Run& run, const std::string& word,
                 const TrafficHead* head);

/// Verilates it if it is not yet. Throws RtlError, MissingTool.
void verilate(Replay& what);

/// In a process of its own: RTL may do anything. A difference is explained, and saved in the
/// folder. `compared` is told in that process how many clocks are done. Throws RtlError,
/// Interrupted, what the source throws.
UnitVerdict replayed(const Replay& what, TrafficSource& source,
                     const std::function<void(std::uint64_t)>& compared);

/// As command_verify() with VerifyOptions::replay.
int verify_replay(const VerifyOptions& options);

}  // namespace racebeam
