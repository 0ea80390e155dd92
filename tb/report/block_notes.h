// The notes of scenes of the block renderer as Markdown: a row of note_kinds().
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "tb/report/note_kinds.h"

namespace racebeam {

/// Ends with the head of a table.
std::string block_notes_head(const NotesCommand& command);

/// A line of that table.
std::unique_ptr<NotedScene> noted_blocks(const Show& show, const knob_values& k);

}  // namespace racebeam
