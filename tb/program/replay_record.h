// What whole replays compared, in a file that is kept: JSON, a line for each unit and level.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/program/verify_unit.h"
#include "tb/twin/traffic_file.h"

namespace racebeam {

struct ReplayRow {
  std::string engine, scene, unit;
  std::string level;  ///< "rtl", "gates", or what else stood in the unit's place
  int frames;         ///< or pictures
  std::uint64_t clocks, differences;
  std::string fault;       ///< what ended the RTL; or empty
  std::string model, rtl;  ///< what tells them from others
  std::string command;     ///< that compares the same
};

/// `key`: as of replay_key(); `run_text`: " --scene demo", the knobs, and which frames.
ReplayRow replay_row(const TrafficHead& head, const std::string& word, const std::string& key,
                     int frames, const UnitVerdict& verdict, const std::string& run_text);

/// The rows of a file; none if there is no such file. Throws UsageError if it holds others.
std::vector<ReplayRow> read_replay_record(const std::string& path);

/// Adds rows; one of the same command is replaced. Throws UsageError, OutputError.
void write_replay_record(const std::string& path, const std::vector<ReplayRow>& rows);

}  // namespace racebeam
