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
#include "tb/report/notes_markdown.h"
#include "tb/show/open_show.h"

namespace racebeam {

int command_scene_notes(const SceneOptions& options) {
  catch_interrupts();
  std::vector<Show> shows;
  std::vector<knobs> settings;
  int frames = 0, done = 0;
  for (const std::string& scene : options.scenes) {
    shows.push_back(open_show(scene));
    expect_rooms(shows.back(), "scene notes");
    settings.push_back(knobs_of(shows.back(), options.run.assignments));
    frames += std::min(options.frames, shows.back().frames());
  }
  OutputFile file(options.notes);
  Progress progress(frames);
  std::string text = notes_head(options.scenes, options.run.set_text(), options.frames,
                                LineEstimate::budget(settings.front()));
  int unexplained = 0;
  for (std::size_t n = 0; n < shows.size(); ++n) {
    const Show& show = shows[n];
    progress.draw(done, 0);
    SceneNotes notes(show, settings[n]);
    for (const int frame : spread_frames(show.frames(), options.frames)) {
      if (interrupted()) break;
      notes.add(frame);
      progress.draw(++done, 0);
    }
    if (interrupted()) {
      progress.clear();
      tell("stopped early; nothing is written");
      return ExitInterrupted;
    }
    text += notes_section(notes);
    unexplained += notes.unexplained();
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
