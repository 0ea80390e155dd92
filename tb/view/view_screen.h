// ViewScreen: where a viewer is seen and heard, and its keys are pressed: a window, a terminal.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/base/console.h"
#include "tb/view/view_control.h"
#include "tb/view/viewer.h"

namespace racebeam {

class ViewScreen {
 public:
  virtual ~ViewScreen() = default;

  /// Hands on what the user did since the last call. True if the picture must be shown again.
  virtual bool poll(ViewControl& control) = 0;
  virtual void show(const Viewer& viewer) = 0;
  /// Samples at FrameSource::SoundRate, -1..1.
  virtual void play(const std::vector<float>&) {}
  /// A line for stderr, as soon as that does not disturb the screen.
  virtual void tell_user(const std::string& line) { tell(line); }
};

/// Runs the viewer at 60 pictures a second until the user quits, or until its frames are shown and
/// `keys`, one pressed after each picture, are used up. Returns the exit code: 130 after an
/// interruption.
int run_view(Viewer& viewer, ViewScreen& screen, const std::vector<std::string>& keys);

}  // namespace racebeam
