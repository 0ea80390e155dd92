// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/trace/beam_trigger.h"

#include <algorithm>

#include "sc/beam/chip_core.h"
#include "tb/base/nearest.h"

namespace racebeam {

namespace {

enum Trigger { FirstStarved, FirstRestart, MaxStack };

bool tracing(const chip_view& v) { return v.run && !v.line_done && !v.line_end; }

}  // namespace

const std::vector<std::string>& trigger_names() {
  static const std::vector<std::string> names = {"first-starved", "first-restart", "max-stack"};
  return names;
}

std::optional<TracePoint> find_trigger(const std::string& name, const TraceWindow& searched,
                                       const knobs& k, const Raster& raster,
                                       const scene_program* program,
                                       const std::function<bool(std::int64_t)>& goes_on) {
  const auto& names = trigger_names();
  const auto known = std::find(names.begin(), names.end(), name);
  if (known == names.end()) throw unknown_name("trigger", name, names);
  const auto trigger = static_cast<Trigger>(known - names.begin());

  chip_core chip(program);
  chip.clock_video(false, k);
  chip.deposit(searched.from.frame, k);
  const std::int64_t last = searched.to.ordinal(raster);
  const std::int64_t first = searched.from.ordinal(raster);
  std::optional<TracePoint> found;
  int most = 0;
  const std::int64_t begin = TracePoint{searched.from.frame, FirstLine, 0}.ordinal(raster);
  for (std::int64_t at = begin; at <= last; ++at) {
    if (at % raster.line_clocks() == 0 && !goes_on(at - begin)) return std::nullopt;
    chip_view view{};
    chip.clock_video(true, k, &view);
    if (at < first || !raster.visible_line(view.y)) continue;
    if (trigger == MaxStack) {
      if (!tracing(view) || view.sd <= most) continue;
      most = view.sd;
      found = point_at(at, raster);
      continue;
    }
    const bool starved = view.consume && view.starving;
    const bool restarted = tracing(view) && view.restart && view.i2 != LastPixel;
    if (trigger == FirstStarved ? starved : restarted) return point_at(at, raster);
  }
  return found;
}

}  // namespace racebeam
