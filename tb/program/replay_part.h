// One part of a replay of all frames: what it compared, in a file.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "tb/program/verify_unit.h"

namespace racebeam {

struct ReplayPart {
  int first, frames;

  /// "frames_00064_64.json"
  std::string file() const;
};

/// Writes it, whole or not at all. `key` tells what was compared. Throws OutputError.
void write_part(const std::string& folder, const ReplayPart& part, const std::string& key,
                const UnitVerdict& verdict);

/// What write_part() wrote; nullopt if there is none, or if it is damaged, which is told.
std::optional<UnitVerdict> read_part(const std::string& folder, const ReplayPart& part,
                                     const std::string& key);

}  // namespace racebeam
