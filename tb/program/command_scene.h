// `racebeam scene`: check, show, draw, start and judge scene files.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/program/command.h"
#include "tb/show/run.h"

namespace racebeam {

struct SceneOptions {
  std::string file;                 ///< the scene
  std::string picture;              ///< of `scene plan`
  bool json = false;                ///< of `scene show`
  std::string engine;               ///< of `scene new`
  RunOptions run;                   ///< --set, of `scene show` and `scene notes`
  std::vector<std::string> scenes;  ///< of `scene notes`; may be "demo"
  std::string notes;                ///< file of `scene notes`
  int frames = 12;                  ///< of each scene, for `scene notes`
};

/// "good: N rooms, M portals"; warnings go to stderr. This and the next two throw UsageError if the
/// scene has faults.
int command_scene_check(const SceneOptions& options);
/// Counts, widths and an estimate of the worst line with the knobs set.
int command_scene_show(const SceneOptions& options);
/// Views of the storeys from above and from the south, as PNG or SVG by the name. Throws
/// OutputError.
int command_scene_plan(const SceneOptions& options);
/// Writes a scene to start from. Throws UsageError if the file exists, OutputError.
int command_scene_new(const SceneOptions& options);
/// Writes counters of some frames of each scene and why they are not the ideal pictures, as
/// Markdown; ExitDifference if some pixel remains unexplained. Throws UsageError if a scene has
/// faults, OutputError.
int command_scene_notes(const SceneOptions& options);

Command scene_row();

}  // namespace racebeam
