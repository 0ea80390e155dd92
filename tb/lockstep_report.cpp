// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/lockstep_report.h"

#include <fmt/format.h>

#include "sc/constants.h"

namespace racebeam {

BeamPlace place_of(std::uint64_t clock, const std::vector<int>& frames, const Raster& raster) {
  if (clock == 0 || frames.empty()) return {frames.empty() ? 0 : frames.front(), FirstLine, -1};
  const std::uint64_t running = clock - 1;
  const std::size_t index = running / raster.frame_clocks();
  const int rest = static_cast<int>(running % raster.frame_clocks());
  return {frames.at(index), FirstLine + rest / raster.line_clocks(), rest % raster.line_clocks()};
}

std::string explain(const LockstepDifference& difference, const std::vector<int>& frames,
                    const Raster& raster, const std::string& repeat) {
  const BeamPlace at = place_of(difference.clock, frames, raster);
  return fmt::format(
      "{}: port {} differs in frame {}, line {}, clock {} of the line ({} clocks compared):\n"
      "  the model has {:#x}, the RTL {:#x}\n"
      "the last {} clocks, hexadecimal, the last column is that of the difference:\n{}"
      "repeat: {}\n",
      difference.unit, difference.port, at.frame, at.line, at.clock, difference.clock,
      difference.expected, difference.got, difference.history.size(), difference.text(), repeat);
}

}  // namespace racebeam
