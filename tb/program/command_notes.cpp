// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "tb/base/console.h"
#include "tb/base/counted.h"
#include "tb/base/errors.h"
#include "tb/base/interrupt.h"
#include "tb/base/output_file.h"
#include "tb/base/progress.h"
#include "tb/base/spread_frames.h"
#include "tb/program/command_scene.h"
#include "tb/report/note_kinds.h"
#include "tb/show/open_show.h"

namespace racebeam {

namespace {

/// A page is of one engine.
void expect_same_engine(const Show& first, const Show& other) {
  if (&first.engine() == &other.engine()) return;
  throw UsageError(first.name() + " is a scene for " + first.engine().name + ", " + other.name() +
                   " one for " + other.engine().name + "; write notes of each engine's apart");
}

}  // namespace

int command_scene_notes(const SceneOptions& options) {
  catch_interrupts();
  std::vector<Show> shows;
  std::vector<knob_values> settings;
  int frames = 0, done = 0;
  for (const std::string& scene : options.scenes) {
    shows.push_back(open_show(scene));
    expect_same_engine(shows.front(), shows.back());
    settings.push_back(knobs_of(shows.back(), options.run.assignments));
    frames += std::min(options.frames, shows.back().frames());
  }
  const NoteKind* kind = note_kind_of(shows.front().engine());
  if (!kind) throw UsageError(std::string("no notes of scenes for ") + shows.front().engine().name);
  OutputFile file(options.notes);
  Progress progress(frames);
  std::string text =
      kind->head({options.scenes, options.run.set_text(), options.frames, settings.front()});
  int unexplained = 0;
  for (std::size_t n = 0; n < shows.size(); ++n) {
    const Show& show = shows[n];
    progress.draw(done, 0);
    const auto notes = kind->scene(show, settings[n]);
    for (const int frame : spread_frames(show.frames(), options.frames)) {
      if (interrupted()) break;
      notes->add(frame);
      progress.draw(++done, 0);
    }
    if (interrupted()) {
      progress.clear();
      tell("stopped early; nothing is written");
      return ExitInterrupted;
    }
    text += notes->text();
    unexplained += notes->unexplained();
  }
  progress.clear();
  file.write(text.data(), text.size());
  file.commit();
  tell(fmt::format("wrote {}: {} frames of {}", options.notes, frames,
                   counted(shows.size(), "scene")));
  if (unexplained == 0) return ExitGood;
  tell(fmt::format("{} pixels are unexplained; please report the scene", unexplained));
  return ExitDifference;
}

}  // namespace racebeam
