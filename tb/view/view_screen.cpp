// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/view_screen.h"

#include <chrono>
#include <cstddef>
#include <thread>

#include "tb/base/errors.h"
#include "tb/base/interrupt.h"

namespace racebeam {

namespace {

using Clock = std::chrono::steady_clock;
constexpr auto PicturePeriod = std::chrono::microseconds(16'667);

double seconds(Clock::duration time) { return std::chrono::duration<double>(time).count(); }

}  // namespace

int run_view(Viewer& viewer, ViewScreen& screen, const std::vector<std::string>& keys) {
  std::size_t next_key = 0;
  Clock::time_point last = Clock::now();
  while (!viewer.quit()) {
    if (interrupted()) return ExitInterrupted;
    const Clock::time_point now = Clock::now();
    const bool stale = screen.poll(viewer.control);
    viewer.tick(seconds(now - last), [&] { return Clock::now() - now < PicturePeriod * 3 / 4; });
    last = now;
    if (viewer.take_changed() || stale) screen.show(viewer);
    screen.play(viewer.take_sound());
    for (const std::string& line : viewer.take_news()) screen.tell_user(line);
    const bool ready =
        !viewer.filling() && (viewer.source().watch().whole() || viewer.control.state.paused);
    if (next_key < keys.size()) {
      if (ready) viewer.control.press(keys[next_key++]);
    } else if (viewer.finished() && !viewer.filling()) {
      break;
    }
    std::this_thread::sleep_until(now + PicturePeriod);
  }
  return ExitGood;
}

}  // namespace racebeam
