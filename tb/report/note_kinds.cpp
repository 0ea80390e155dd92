// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/note_kinds.h"

#include "sc/beam/engine.h"
#include "sc/block/engine.h"
#include "sc/sphere/engine.h"
#include "sc/voxel/engine.h"
#include "tb/report/block_notes.h"
#include "tb/report/notes_markdown.h"
#include "tb/report/sphere_notes.h"
#include "tb/report/voxel_notes.h"

namespace racebeam {

namespace {

class NotedRooms final : public NotedScene {
 public:
  NotedRooms(const Show& show, const knobs& k) : notes_(show, k) {}
  void add(int frame) override { notes_.add(frame); }
  std::string text() const override { return notes_section(notes_); }
  int unexplained() const override { return notes_.unexplained(); }

 private:
  SceneNotes notes_;
};

std::string rooms_head(const NotesCommand& command) {
  return notes_head(notes_command(command), command.frames, !command.set.empty(),
                    LineEstimate::budget(command.k));
}

std::unique_ptr<NotedScene> noted_rooms(const Show& show, const knob_values& k) {
  return std::make_unique<NotedRooms>(show, k);
}

}  // namespace

const std::vector<NoteKind>& note_kinds() {
  static const std::vector<NoteKind> table = {{beam_engine(), rooms_head, noted_rooms},
                                              {sphere_engine(), sphere_notes_head, noted_spheres},
                                              {block_engine(), block_notes_head, noted_blocks},
                                              {voxel_engine(), voxel_notes_head, noted_voxels}};
  return table;
}

const NoteKind* note_kind_of(const engine& built) {
  for (const NoteKind& kind : note_kinds())
    if (&kind.engine == &built) return &kind;
  return nullptr;
}

}  // namespace racebeam
