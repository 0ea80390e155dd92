// The notes of scenes as Markdown: facts, counters, and why the chip does not show the ideal
// picture.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/report/note_kinds.h"
#include "tb/report/scene_notes.h"

namespace racebeam {

/// Text of users on a line of Markdown.
std::string markdown_text(const std::string& text);

/// The command that makes the notes. Of a path the last part is named, so that the text does not
/// depend on the machine.
std::string notes_command(const NotesCommand& command);

/// What comes before the first scene. `set`: there are knobs. `budget`: LineEstimate::budget().
std::string notes_head(const std::string& command, int frames, bool set, int budget);

/// One scene.
std::string notes_section(const SceneNotes& notes);

}  // namespace racebeam
