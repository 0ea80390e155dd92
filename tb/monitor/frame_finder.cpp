// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/monitor/frame_finder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "tb/base/counted.h"
#include "tb/monitor/sync_pulses.h"
#include "tb/monitor/vga_monitor.h"
#include "tb/monitor/video_mode.h"

namespace racebeam {

namespace {

constexpr std::uint64_t LeastSearch = 6'000'000;  // clocks
constexpr double LongestSearch = 0.1;             // s: six frames of 60 Hz
constexpr int MaxSpeed = 7;                       // pins
constexpr int MaxPicturePixels = 8;               // that the picture may be early or late
constexpr std::uint64_t LeastLine = 64, LeastLines = 100, MostFrame = 100'000'000;
constexpr double ClockTolerance = 0.25;  // of a clock that is given
constexpr double UnknownRate = 60;       // frames a second

struct Syncs {
  SyncPulse hsync, vsync;

  int line() const { return static_cast<int>(hsync.period); }
  int lines() const { return static_cast<int>(vsync.period / hsync.period); }
};

bool regular(const SyncPulse& pulse) { return pulse.period >= LeastLine; }

[[noreturn]] void no_pulse(const std::vector<PinChange>& changes, const char* name, int pin,
                           std::uint64_t clocks) {
  std::string text =
      fmt::format("{}, uo_out[{}], has no pulses in the {} clocks after reset;", name, pin, clocks);
  for (int other = 0; other < 8; ++other)
    if (const auto pulse = usual_pulse(changes, other);
        pin == PinHsync && other != PinHsync && other != PinVsync && pulse && regular(*pulse))
      text += fmt::format(
          " uo_out[{}] has one every {} clocks, but the pins must be those of "
          "TinyVGA;",
          other, pulse->period);
  throw SyncError(text + " does the chip need other inputs? --ui and --uio set them");
}

/// Both syncs, or nothing yet. Throws SyncError if they make no frame, or never come.
std::optional<Syncs> measure(const std::vector<PinChange>& changes, std::uint64_t clocks,
                             double clock_hz) {
  const bool enough =
      clocks >= std::max(LeastSearch, static_cast<std::uint64_t>(clock_hz * LongestSearch));
  const auto hsync = usual_pulse(changes, PinHsync);
  const auto vsync = hsync ? last_pulse(changes, PinVsync, hsync->period) : std::nullopt;
  if (!(hsync && vsync) && !enough) return {};
  if (!hsync || !regular(*hsync)) no_pulse(changes, "hsync", PinHsync, clocks);
  if (!vsync) no_pulse(changes, "vsync", PinVsync, clocks);
  const std::uint64_t frame = vsync->period, line = hsync->period;
  if (frame % line != 0 || frame / line < LeastLines || frame > MostFrame) {
    if (!enough) return {};
    throw SyncError(
        fmt::format("a frame lasts {} clocks from vsync to vsync, a line {} from hsync "
                    "to hsync: {:.2f} lines are no picture",
                    frame, line, double(frame) / double(line)));
  }
  return Syncs{*hsync, *vsync};
}

/// The mode of this project's chip, with its checks, if the lines are as long as that.
bool take_own_raster(FoundFrames& found, const Syncs& syncs, double clock_hz) {
  if (syncs.lines() != FrameLines) return false;
  const auto given = static_cast<int>(std::lround(clock_hz / PixelClockHz));
  for (int clocks = 1; clocks <= 8; ++clocks)
    for (int speed = 0; speed <= (clocks == given ? MaxSpeed : 0); ++speed) {
      const Raster raster(clocks, speed);
      const int pulse = raster.sync_end - raster.sync_begin;
      if (raster.line_clocks() != syncs.line() ||
          std::abs(pulse - static_cast<int>(syncs.hsync.length)) > pulse / 4)
        continue;
      found.raster = raster;
      found.clocks_per_pixel = clocks;
      return true;
    }
  return false;
}

Raster raster_of(const VideoMode& mode, const Syncs& syncs) {
  const double scale = double(syncs.line()) / mode.line_pixels();
  const auto clocks = [&](int pixels) { return static_cast<int>(std::lround(pixels * scale)); };
  const bool whole = syncs.line() % mode.line_pixels() == 0;
  const int pulse = whole ? clocks(mode.sync) : static_cast<int>(syncs.hsync.length);
  const int begin = clocks(mode.front);
  return Raster(RasterShape{syncs.line(), begin, begin + pulse,
                            clocks(mode.front + mode.sync + mode.back), mode.columns, mode.above,
                            mode.rows, mode.below, mode.vsync_lines});
}

/// Calls `coloured` with begin and end of each time in which the pins are not black, after a line.
template <class Coloured>
void each_colour(const std::vector<PinChange>& changes, std::uint64_t from,
                 const Coloured& coloured) {
  for (std::size_t i = 0; i + 1 < changes.size(); ++i)
    if ((changes[i].uo & ColourPins) && changes[i].clock >= from)
      coloured(changes[i].clock, changes[i + 1].clock);
}

struct Extent {
  int begin, end;
};

/// What of a line, or of a frame, is visible: where it was seen not to be black if that is most of
/// it, else the usual part at least. All count from the begin of the sync pulse.
Extent visible_part(const std::vector<bool>& coloured, int pulse, double above, double below) {
  const int all = static_cast<int>(coloured.size());
  const Extent usual{pulse + static_cast<int>(all * above), all - static_cast<int>(all * below)};
  int begin = all, end = 0;
  for (int at = pulse; at < all; ++at)
    if (coloured[at]) {
      begin = std::min(begin, at);
      end = at + 1;
    }
  if ((end - begin) * 5 >= all * 3) return {begin, end};
  return {std::min(begin, usual.begin), std::max(end, usual.end)};
}

/// A mode that no table has.
Raster estimated_raster(const std::vector<PinChange>& changes, const Syncs& syncs) {
  const int line = syncs.line(), lines = syncs.lines();
  const auto pulse = static_cast<int>(syncs.hsync.length);
  std::vector<bool> columns(line), rows(lines);
  each_colour(changes, line, [&](std::uint64_t begin, std::uint64_t end) {
    for (end = std::min(end, begin + line); begin < end; ++begin)
      columns[(begin + line - syncs.hsync.begin % line) % line] = true;
  });
  const Extent x = visible_part(columns, pulse, 0.06, 0.02);
  // A line ends with its last visible clock; the one in which vsync begins has number 0.
  const std::uint64_t frame = syncs.vsync.period;
  const std::uint64_t line_begin = (syncs.hsync.begin + x.end) % line;
  const std::uint64_t first =
      syncs.vsync.begin + frame - (syncs.vsync.begin + line - line_begin) % line;
  each_colour(changes, line, [&](std::uint64_t begin, std::uint64_t end) {
    for (; begin < end; begin += line) rows[(begin + frame - first % frame) % frame / line] = true;
  });
  const int vsync_lines =
      std::max(1, static_cast<int>((syncs.vsync.length + line / 2) / std::uint64_t(line)));
  const Extent y = visible_part(rows, vsync_lines, 0.04, 0.01);
  const int height = y.end - y.begin, width = x.end - x.begin;
  const int clocks_per_pixel = std::max(1, static_cast<int>(std::lround(width * 0.75 / height)));
  const int front = line - x.end;
  return Raster(RasterShape{line, front, front + pulse, front + x.begin,
                            std::max(1, width / clocks_per_pixel), y.begin - vsync_lines, height,
                            lines - y.end, vsync_lines});
}

/// How late the picture is, if what is not black then fits into the visible columns; else 0.
int find_picture(const std::vector<PinChange>& changes, const Raster& raster,
                 std::uint64_t line_begin, int limit) {
  const int line = raster.line_clocks(), width = line - raster.active_begin;
  int left = width, right = 0;
  bool wide = false;
  each_colour(changes, line, [&](std::uint64_t from, std::uint64_t to) {
    const auto length = static_cast<int>(std::min<std::uint64_t>(to - from, line));
    wide |= length > width;
    int begin = static_cast<int>((from + line - line_begin) % line) - raster.active_begin;
    if (begin < -raster.active_begin / 2) begin += line;  // late: in the next front porch
    left = std::min(left, begin);
    right = std::max(right, begin + length);
  });
  const int late = wide || right - left > width ? 0 : left < 0 ? left : std::max(0, right - width);
  return std::abs(late) <= limit ? late : 0;
}

/// Mode, raster and clock.
void find_mode(FoundFrames& found, const std::vector<PinChange>& changes, const Syncs& syncs,
               double clock_hz, bool sure) {
  const VideoMode* mode =
      find_video_mode({syncs.line(), static_cast<int>(syncs.hsync.length), syncs.lines(),
                       syncs.hsync.level, syncs.vsync.level, clock_hz});
  double needed = UnknownRate * double(syncs.vsync.period);
  found.known_mode = true;
  if (take_own_raster(found, syncs, clock_hz)) {
    found.mode = "640x480 at 60 Hz";
    needed = PixelClockHz * found.clocks_per_pixel;
  } else if (mode) {
    found.raster = raster_of(*mode, syncs);
    found.mode = mode->name();
    found.clocks_per_pixel = double(syncs.line()) / mode->line_pixels();
    needed = mode->pixel_mhz * 1e6 * found.clocks_per_pixel;
  } else {
    found.raster = estimated_raster(changes, syncs);
    found.mode =
        fmt::format("{} by {}", counted(syncs.line(), "clock"), counted(syncs.lines(), "line"));
    found.clocks_per_pixel =
        double(syncs.line() - found.raster.active_begin) / found.raster.columns;
    found.known_mode = false;
  }
  found.clock_assumed = clock_hz <= 0 || (!sure && found.known_mode &&
                                          std::abs(clock_hz / needed - 1) > ClockTolerance);
  found.clock_hz = found.clock_assumed ? needed : clock_hz;
}

}  // namespace

std::optional<FoundFrames> find_frames(const std::vector<PinChange>& changes, std::uint64_t clocks,
                                       double clock_hz, bool sure) {
  const auto syncs = measure(changes, clocks, clock_hz);
  if (!syncs) return {};
  FoundFrames found;
  find_mode(found, changes, *syncs, clock_hz, sure);
  Raster& raster = found.raster;
  const auto line = static_cast<std::uint64_t>(raster.line_clocks());
  const auto frame = static_cast<std::uint64_t>(raster.frame_clocks());
  raster.hsync_pulse = syncs->hsync.level;
  raster.vsync_pulse = syncs->vsync.level;
  const std::uint64_t line_begin = (syncs->hsync.begin + line - raster.sync_begin) % line;
  raster.vsync_at = static_cast<int>((syncs->vsync.begin + line - line_begin) % line);
  const std::uint64_t above = line * (raster.vsync_line - raster.first_line);
  found.first = (syncs->vsync.begin + frame - raster.vsync_at + frame - above) % frame;
  found.picture_late =
      find_picture(changes, raster, line_begin,
                   static_cast<int>(MaxPicturePixels * std::max(1.0, found.clocks_per_pixel)));
  raster.advance_syncs(found.picture_late);
  found.first = (found.first + frame + found.picture_late) % frame;
  return found;
}

}  // namespace racebeam
