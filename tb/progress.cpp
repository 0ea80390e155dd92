// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace racebeam {

namespace {

constexpr int BarWidth = 24;

bool terminal_moves_cursor() {
  const char* term = std::getenv("TERM");
  return isatty(STDERR_FILENO) && term && std::string_view(term) != "dumb";
}

}  // namespace

Progress::Progress(int frames) : frames_(frames), enabled_(terminal_moves_cursor()) {}

void Progress::draw(int frames_done, std::uint64_t clocks) {
  if (!enabled_) return;
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  const double seconds = elapsed.count();
  const int filled = BarWidth * frames_done / frames_;
  std::string line = fmt::format("\r\x1b[K[{}{}] {}/{} frames", std::string(filled, '#'),
                                 std::string(BarWidth - filled, '.'), frames_done, frames_);
  if (frames_done > 0 && seconds > 0) {
    const int left = static_cast<int>(seconds / frames_done * (frames_ - frames_done) + 0.5);
    if (clocks > 0) line += fmt::format("  {:.1f} M clocks/s", clocks / seconds / 1e6);
    line += fmt::format("  {}:{:02} left", left / 60, left % 60);
  }
  std::fputs(line.c_str(), stderr);
  std::fflush(stderr);
  drawn_ = true;
}

void Progress::clear() {
  if (!drawn_) return;
  std::fputs("\r\x1b[K", stderr);
  std::fflush(stderr);
  drawn_ = false;
}

}  // namespace racebeam
