// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/counters.h"

namespace racebeam {

const std::vector<counter_row>& counter_table() {
  static const std::vector<counter_row> table = {
      {{"clocks", "", 0}, &frame_stats::clocks},
      {{"decisions", "decisions", 10}, nullptr},
      {{"left_decisions", "", 0}, &frame_stats::left_decisions},
      {{"right_decisions", "", 0}, &frame_stats::right_decisions},
      {{"bisection_steps", "bisections", 10}, &frame_stats::bisection_steps},
      {{"adjust_steps", "", 0}, &frame_stats::adjust_steps},
      {{"descents", "", 0}, &frame_stats::descents},
      {{"pushes", "", 0}, &frame_stats::pushes},
      {{"returns", "", 0}, &frame_stats::returns},
      {{"return_clocks", "", 0}, &frame_stats::return_clocks},
      {{"emits", "intervals", 0}, &frame_stats::emits},
      {{"restarts", "restarts", 8}, &frame_stats::restarts},
      {{"starved_pixels", "starved pixels", 14}, &frame_stats::starved_pixels},
      {{"give_ups", "given up", 0}, &frame_stats::give_ups},
      {{"fifo_full_stalls", "FIFO stalls", 11}, &frame_stats::fifo_full_stalls},
      {{"rooms_entered", "rooms entered", 0}, &frame_stats::rooms_entered},
      {{"merges", "", 0}, &frame_stats::merges},
      {{"sign_splits", "", 0}, &frame_stats::sign_splits},
      {{"seen_starved_pixels", "", 0}, &frame_stats::seen_starved_pixels},
  };
  return table;
}

const std::vector<histogram_row>& histogram_table() {
  static const std::vector<histogram_row> table = {
      {{"fifo_fill", "fifo_entries"}, &frame_stats::fifo_fill},
      {{"stack_depth", "interval_stack_depth"}, &frame_stats::stack_depth},
      {{"walk_steps", nullptr, 10}, &frame_stats::walk_steps},
      {{"slack", nullptr, 64}, &frame_stats::slack},
  };
  return table;
}

const std::vector<line_row>& line_table() {
  static const std::vector<line_row> table = {
      {{"camera_clocks", "", false, ""}, &frame_stats::camera_clocks},
      {{"first_emit_clock", "lines_without", false, ""}, &frame_stats::first_emit},
      {{"done_clock", "lines_not_done", true, ""}, &frame_stats::done_clock},
      {{"busy_clocks", "", false, "busy clocks"}, &frame_stats::busy_clocks},
      {{"stack_needed", "", false, ""}, &frame_stats::stack_needed},
      {{"line_camera", "", true, "", "camera"}, &frame_stats::line_camera},
      {{"line_decide", "", true, "", "decide"}, &frame_stats::line_decide},
      {{"line_bisect", "", true, "", "bisect"}, &frame_stats::line_bisect},
      {{"line_walk", "", true, "", "walk"}, &frame_stats::line_walk},
      {{"line_enter", "", true, "", "enter"}, &frame_stats::line_enter},
      {{"line_return", "", true, "", "return"}, &frame_stats::line_return},
      {{"line_wait", "", true, "", "wait"}, &frame_stats::line_wait},
      {{"line_idle", "", true, "", "idle"}, &frame_stats::line_idle},
  };
  return table;
}

std::vector<std::uint64_t frame_stats::*> counter_registers() {
  std::vector<std::uint64_t frame_stats::*> registers;
  for (const counter_row& row : counter_table())
    if (row.member) registers.push_back(row.member);
  return registers;
}

frame_counts counted(const frame_stats& stats) {
  frame_counts counts;
  for (const counter_row& row : counter_table())
    counts.counters.push_back(row.member ? stats.*row.member : stats.decisions());
  for (const histogram_row& row : histogram_table()) {
    const auto& values = stats.*row.member;
    counts.histograms.emplace_back(values.begin(), values.end());
  }
  for (const line_row& row : line_table()) counts.lines.push_back(stats.*row.member);
  return counts;
}

}  // namespace racebeam
