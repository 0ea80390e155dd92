// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/frame_finder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "tb/counted.h"
#include "tb/vga_monitor.h"

namespace racebeam {

namespace {

constexpr int MaxFrames = 3;         // to look at
constexpr int MaxSpeed = 7;          // pins
constexpr int MaxPicturePixels = 8;  // that the picture may be early or late

struct Pulse {
  std::uint64_t begin = 0, period = 0;  // clocks
  bool level = false;
};

/// The last whole period of a pin; its pulse is the shorter part. The first clocks do not count: a
/// register that has no reset may change then.
std::optional<Pulse> find_pulse(const std::vector<PinChange>& changes, int pin,
                                std::uint64_t from) {
  std::array<std::uint64_t, 3> edges{};
  int count = 0;
  bool level = false;
  for (const PinChange& change : changes) {
    const bool now = (change.uo >> pin) & 1;
    if (now != level && change.clock >= from) {
      edges = {edges[1], edges[2], change.clock};
      ++count;
    }
    level = now;
  }
  if (count < 3) return {};
  const bool pulse_first = edges[1] - edges[0] < edges[2] - edges[1];
  // From edges[0] on the level is that from edges[2] on, which is the present one.
  return Pulse{pulse_first ? edges[0] : edges[1], edges[2] - edges[0],
               pulse_first ? level : !level};
}

[[noreturn]] void no_pulse(const char* name, int pin, std::uint64_t clocks) {
  throw SyncError(
      fmt::format("{}, uo_out[{}], has no pulses in the {} clocks after reset, {} frames;"
                  " does the chip need other inputs? --ui and --uio set them",
                  name, pin, clocks, MaxFrames));
}

Raster raster_of_line(std::uint64_t line_clocks, int clocks_per_pixel) {
  for (int speed = 0; speed <= MaxSpeed; ++speed) {
    const Raster raster(clocks_per_pixel, speed);
    if (line_clocks == static_cast<std::uint64_t>(raster.line_clocks())) return raster;
  }
  throw SyncError(fmt::format(
      "a line lasts {} clocks from hsync to hsync, must last {}: only 640x480 at 60 Hz is known, "
      "{} a pixel at this clock_hz",
      line_clocks, Raster(clocks_per_pixel).line_clocks(), counted(clocks_per_pixel, "clock")));
}

/// How late the picture is, if what is not black then fits into the visible columns; else 0.
int find_picture(const std::vector<PinChange>& changes, const Raster& raster,
                 std::uint64_t line_begin, int limit) {
  const int line = raster.line_clocks(), width = line - raster.active_begin;
  int left = width, right = 0;
  for (std::size_t i = 0; i + 1 < changes.size(); ++i) {
    const PinChange& run = changes[i];
    if (!(run.uo & ColourPins) || run.clock < static_cast<std::uint64_t>(line)) continue;
    const std::uint64_t length = changes[i + 1].clock - run.clock;
    if (length > static_cast<std::uint64_t>(width)) return 0;
    int begin = static_cast<int>((run.clock + line - line_begin) % line) - raster.active_begin;
    if (begin < -raster.active_begin / 2) begin += line;  // late: in the next front porch
    left = std::min(left, begin);
    right = std::max(right, begin + static_cast<int>(length));
  }
  const int late = right - left > width ? 0 : left < 0 ? left : std::max(0, right - width);
  return std::abs(late) <= limit ? late : 0;
}

}  // namespace

std::optional<FoundFrames> find_frames(const std::vector<PinChange>& changes, std::uint64_t clocks,
                                       int clocks_per_pixel) {
  const Raster nominal(clocks_per_pixel);
  const bool enough = clocks >= static_cast<std::uint64_t>(MaxFrames * nominal.frame_clocks());
  const auto from = static_cast<std::uint64_t>(nominal.line_clocks());
  const auto vsync = find_pulse(changes, PinVsync, from);
  const auto hsync = find_pulse(changes, PinHsync, from);
  if (!(hsync && vsync) && !enough) return {};
  if (!hsync) no_pulse("hsync", PinHsync, clocks);

  FoundFrames found{raster_of_line(hsync->period, clocks_per_pixel)};
  if (!vsync) no_pulse("vsync", PinVsync, clocks);
  Raster& raster = found.raster;
  const auto line = static_cast<std::uint64_t>(raster.line_clocks());
  const auto frame = static_cast<std::uint64_t>(raster.frame_clocks());
  if (vsync->period != frame)
    throw SyncError(fmt::format(
        "a frame lasts {} clocks from vsync to vsync, must last {}: {} lines of {} clocks; only "
        "640x480 at 60 Hz is known",
        vsync->period, frame, FrameLines, line));
  raster.hsync_pulse = hsync->level;
  raster.vsync_pulse = vsync->level;
  const std::uint64_t line_begin = (hsync->begin + line - raster.sync_begin) % line;
  raster.vsync_at = static_cast<int>((vsync->begin + line - line_begin) % line);
  const std::uint64_t above = line * (raster.vsync_line - FirstLine);
  found.first = (vsync->begin + frame - raster.vsync_at + frame - above) % frame;
  found.picture_late =
      find_picture(changes, raster, line_begin, MaxPicturePixels * clocks_per_pixel);
  raster.advance_syncs(found.picture_late);
  found.first = (found.first + frame + found.picture_late) % frame;
  return found;
}

}  // namespace racebeam
