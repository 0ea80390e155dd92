// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/base/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "tb/base/console.h"

namespace racebeam {

namespace {

constexpr int BarWidth = 24;
constexpr std::chrono::milliseconds Pause{100};

std::string time_text(double seconds) {
  const auto whole = static_cast<long long>(seconds + 0.5);
  const long long hours = whole / 3600, minutes = whole / 60 % 60;
  return hours > 0 ? fmt::format("{}:{:02}:{:02}", hours, minutes, whole % 60)
                   : fmt::format("{}:{:02}", minutes, whole % 60);
}

}  // namespace

Progress::Progress(std::int64_t total, const char* things)
    : total_(std::max<std::int64_t>(total, 1)), things_(things), enabled_(watched()) {}

void Progress::draw(std::int64_t done, std::uint64_t clocks, const std::string& note) {
  if (!enabled_) return;
  const auto now = Clock::now();
  if (drawn_ && now - last_ < Pause) return;
  last_ = now;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const auto filled =
      static_cast<std::size_t>(BarWidth * std::clamp<std::int64_t>(done, 0, total_) / total_);
  std::string line = fmt::format("\r\x1b[K[{}{}] {}/{} {}", std::string(filled, '#'),
                                 std::string(BarWidth - filled, '.'), done, total_, things_);
  if (done > 0 && seconds > 0) {
    if (clocks > 0)
      line += fmt::format("  {:.1f} M clocks/s", static_cast<double>(clocks) / seconds / 1e6);
    const auto left = static_cast<double>(std::max<std::int64_t>(total_ - done, 0));
    line += "  " + time_text(seconds / static_cast<double>(done) * left) + " left";
  }
  if (!note.empty()) line += "  " + note;
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
