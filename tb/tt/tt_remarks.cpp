// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/tt/tt_remarks.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "tb/base/counted.h"

namespace racebeam {

std::vector<std::string> assumptions(const TtProject& project, const FoundFrames& found) {
  std::vector<std::string> all;
  const std::filesystem::path folder(project.folder);
  for (const std::string& define : project.config_defines)
    all.push_back(fmt::format("{} defines {}", (folder / "src/config.json").string(), define));
  if (found.clock_assumed)
    all.push_back(fmt::format(
        "{}; assumed {} Hz, since a line has {}: --clock-hz sets it",
        project.clock_hz == 0
            ? "info.yaml names no clock"
            : fmt::format("a clock of {} Hz does not fit {}", project.clock_hz, found.mode),
        std::llround(found.clock_hz), counted(found.raster.line_clocks(), "clock")));
  if (!found.known_mode)
    all.push_back(
        fmt::format("{} are no mode with a name; which part is visible, {}x{}, is "
                    "estimated from where it is not black",
                    found.mode, found.raster.columns, found.raster.rows));
  return all;
}

std::vector<std::string> complaints(const VgaFaults& faults) {
  std::vector<std::string> all;
  if (faults.sync_clocks)
    all.push_back(fmt::format("the syncs broke the mode in {}; first, {}",
                              counted(faults.sync_clocks, "clock"), faults.first_sync));
  if (faults.colour_clocks)
    all.push_back(fmt::format("colour outside of the visible pixels in {}; first, {}",
                              counted(faults.colour_clocks, "clock"), faults.first_colour));
  return all;
}

}  // namespace racebeam
