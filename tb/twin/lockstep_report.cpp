// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/lockstep_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "sc/base/constants.h"
#include "tb/base/console.h"
#include "tb/twin/lockstep_text.h"

namespace racebeam {

namespace {

constexpr int FirstColumn = -320;  // of the visible pixels

}  // namespace

BeamPlace place_of(std::uint64_t clock, const std::vector<int>& frames, const Raster& raster) {
  if (clock == 0 || frames.empty()) return {frames.empty() ? 0 : frames.front(), FirstLine, -1};
  const std::uint64_t running = clock - 1;
  const std::size_t index =
      std::min<std::size_t>(running / raster.frame_clocks(), frames.size() - 1);
  std::size_t first = index;  // of its picture
  while (first > 0 && frames[first - 1] == frames[index]) --first;
  const auto rest = static_cast<int>(running - first * raster.frame_clocks());
  return {frames[index], FirstLine + rest / raster.line_clocks(), rest % raster.line_clocks()};
}

std::string place_text(const BeamPlace& place, const Raster& raster) {
  std::string text =
      fmt::format("frame {}, line {}, clock {}", place.frame, place.line, place.clock);
  const int column =
      place.clock < 0 ? -1
                      : raster.clocks[static_cast<std::size_t>(place.clock)].position - FirstColumn;
  if (raster.visible_line(place.line) && column >= 0) text += fmt::format(", pixel {}", column);
  return text;
}

std::string picture_text(const BeamPlace& place, const Raster& raster) {
  return fmt::format("picture {}, clock {}", place.frame,
                     (place.line - FirstLine) * raster.line_clocks() + place.clock);
}

std::string trace_command(const std::string& scene, const std::string& from,
                          const std::string& unit, const std::string& rest) {
  return fmt::format("racebeam trace {} --from {}{} --around mismatch -o {}_mismatch.vcd", scene,
                     from, rest, unit);
}

std::string explain(const LockstepDifference& d, const DifferenceContext& context) {
  return fmt::format(
      "{}: port {} differs {} ({} clocks compared):\n"
      "  the model has {:#x}, the RTL {:#x}\n{}{}"
      "clocks, 0 is that of the difference; values are hexadecimal, {} marks those of the RTL that "
      "differ:\n{}{}"
      "knobs: {}\n{}repeat: {}\n{}",
      d.unit, d.port, context.where, d.clock, d.expected, d.got,
      d.wiring.empty() ? "" : d.wiring + "\n", difference_hints(d), DifferenceMark,
      difference_table(context.registers ? context.registers->beside(d) : d),
      context.registers ? context.registers->text(d) : "", context.knobs,
      context.window.empty() ? "" : "waveform: " + context.window + "\n", context.repeat,
      context.closer.empty() ? "" : "all signals: " + context.closer + "\n");
}

void tell_difference(const std::string& explanation) {
  tell(in_colours() ? in_colour(explanation) : explanation);
}

}  // namespace racebeam
