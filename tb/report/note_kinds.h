// The notes of scenes, in a row for each engine.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tb/show/show.h"

namespace racebeam {

/// What is measured of one scene.
class NotedScene {
 public:
  virtual ~NotedScene() = default;
  /// Draws a frame, or picture, and compares it with the golden tracers: takes seconds.
  virtual void add(int frame) = 0;
  virtual std::string text() const = 0;
  /// Pixels that no cause accounts for: must be 0.
  virtual int unexplained() const = 0;
};

/// The command line, for the head. `set`: " --set knob=value" for each knob.
struct NotesCommand {
  std::vector<std::string> scenes;
  std::string set;
  int frames;
  knob_values k;  ///< of the first scene
};

struct NoteKind {
  const racebeam::engine& engine;
  std::string (*head)(const NotesCommand& command);
  std::unique_ptr<NotedScene> (*scene)(const Show& show, const knob_values& k);
};

const std::vector<NoteKind>& note_kinds();

/// The row of an engine; nullptr: it has none.
const NoteKind* note_kind_of(const engine& built);

}  // namespace racebeam
