// The notes of scenes as Markdown: facts, counters, and why the chip does not show the ideal
// picture.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/report/scene_notes.h"

namespace racebeam {

/// What comes before the first scene. `scenes` as on the command line; of a path the last part is
/// named, so that the text does not depend on the machine. `set`: " --set knob=value" for
/// each knob. `budget`: LineEstimate::budget().
std::string notes_head(const std::vector<std::string>& scenes, const std::string& set, int frames,
                       int budget);

/// One scene.
std::string notes_section(const SceneNotes& notes);

}  // namespace racebeam
