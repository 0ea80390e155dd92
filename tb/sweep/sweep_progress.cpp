// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/sweep_progress.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace racebeam {

namespace {

// If racing stops none of them.
std::int64_t frames_at_most(const SweepPlan& plan) {
  std::int64_t frames = 0;
  for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene)
    frames += std::int64_t(plan.points_at_most()) * plan.sample(scene);
  return frames;
}

}  // namespace

SweepProgress::SweepProgress(const SweepPlan& plan, const SweepFolder& folder)
    : plan_(plan), folder_(folder), bar_(frames_at_most(plan)) {}

void SweepProgress::look(const Measurer& measurer, int rung) {
  bar_.draw(measurer.measured(), 0, fmt::format("rung of {} frames", rung));
  if (Clock::now() - written_ < std::chrono::seconds(1)) return;
  written_ = Clock::now();
  write(measurer, rung, "running");
}

void SweepProgress::end(const Measurer& measurer, int rung, bool whole) {
  bar_.clear();
  write(measurer, rung, whole ? "done" : "interrupted");
}

void SweepProgress::leave(const Measurer& measurer, int rung) {
  bar_.clear();
  write(measurer, rung, "submitted");
}

void SweepProgress::write(const Measurer& measurer, int rung, const char* state) {
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  const double rate = seconds > 0 ? double(measurer.measured()) / seconds : 0;
  const nlohmann::ordered_json json = {
      {"schema", "racebeam-sweep-status"},
      {"version", 1},
      {"name", plan_.file.name},
      {"state", state},
      {"points", plan_.points.size()},
      {"failed", measurer.failed()},
      {"rung", rung},
      {"frames", measurer.measured()},
      {"frames_at_most", frames_at_most(plan_)},
      {"seconds", seconds},
      {"frames_a_second", rate},
  };
  folder_.keep_status(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) +
                      "\n");
}

}  // namespace racebeam
