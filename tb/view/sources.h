// How the viewer gets its frames, in a row for each engine.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tb/show/run.h"
#include "tb/view/frame_source.h"
#include "tb/view/view_control.h"

namespace racebeam {

struct SourceKind {
  const racebeam::engine& engine;
  std::vector<std::string> levels;
  KeyHelp::Chip keys;
  /// Of a run whose units were put in. The show outlives it.
  std::unique_ptr<FrameSource> (*make)(const Run& run);
};

const std::vector<SourceKind>& sources();

/// The row of an engine. Throws UsageError if there is none, or if it has not got the level.
const SourceKind& source_of(const engine& built, const std::string& level);

}  // namespace racebeam
