// What `racebeam scene notes` says of the voxel tracer's scenes: a row of note_kinds().
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "tb/report/note_kinds.h"

namespace racebeam {

/// NoteKind::head and make.
std::string voxel_notes_head(const NotesCommand& command);
std::unique_ptr<NotedScene> noted_voxels(const Show& show, const knob_values& k);

}  // namespace racebeam
