// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/frame_watch.h"

namespace racebeam {

void FrameWatch::clock(int uo, const chip_view& view, int room, int face) {
  if (whole()) forget();
  if (++seen_ == 2) frame_ = view.frame;  // in its first clock the counter may still restart
  now_ = view;
  screen_.clock(uo);
  collector_.observe(view);
  watcher_.observe(view, room, face);
}

void FrameWatch::restart() {
  forget();
  screen_.home();
}

void FrameWatch::forget() {
  collector_ = {};
  watcher_ = {};
  seen_ = 0;
}

}  // namespace racebeam
