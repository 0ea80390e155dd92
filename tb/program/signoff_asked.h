// What `racebeam signoff` is asked for: units, the whole chip, and which checks of them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/show/run.h"
#include "tb/signoff/signoff_unit.h"

namespace racebeam {

struct AskedUnit {
  std::string unit, file;                   ///< file: empty for the unit's own RTL
  std::vector<const SignoffCheck*> checks;  ///< in the order of the table
};

/// `words`: UNIT, UNIT=FILE, or all, which has the whole chip too, where its RTL is the chip of the
/// run; none is all. `only`: names of checks; none is all that a unit has. Throws UsageError.
std::vector<AskedUnit> asked_units(const std::vector<std::string>& words,
                                   const std::vector<std::string>& only, const Run& run);

/// What is asked of one engine.
struct AskedPart {
  Run run;
  std::vector<AskedUnit> units;
  std::string folder;  ///< for what is found
};

/// One, or with AllEngines one of each, in a folder of its own. `folder`: for all. Throws
/// UsageError.
std::vector<AskedPart> asked_parts(const RunOptions& options, const std::vector<std::string>& only,
                                   const std::string& folder);

/// Its RTL, verilated if need be. Throws RtlError, UsageError, MissingTool, Interrupted.
SignoffUnit unit_of(const AskedUnit& asked, const Run& run);

}  // namespace racebeam
