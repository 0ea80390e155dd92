// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/repeats.h"

#include <algorithm>

#include "tb/sweep/provenance.h"

namespace racebeam {

bool repeats_as_stored(const SweepPlan& plan, Store& store, std::int64_t model,
                       Measurer& measurer) {
  if (!is_new_program(store, model)) return true;
  std::vector<Want> there;  // the base first: others are compared with its pictures
  for (int point = 0; point < static_cast<int>(plan.points.size()); ++point)
    for (int scene = 0; scene < static_cast<int>(plan.scenes.size()); ++scene)
      for (const FrameRow& row : store.frames.read(measurer.key(point, scene), {}))
        if (!row.guard) there.push_back({point, scene, {row.frame}});
  const std::size_t some = std::min<std::size_t>(3, there.size());
  for (std::size_t i = 0; i < some; ++i)
    if (!measurer.repeat(there[i * (there.size() - 1) / 2])) return false;
  know_program(store, model);
  return true;
}

}  // namespace racebeam
