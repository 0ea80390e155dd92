// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/monitor/video_mode.h"

#include <fmt/format.h>

#include <cmath>

namespace racebeam {

namespace {

constexpr double PulseTolerance = 0.25;  // of the pulse, where pixels are whole clocks
constexpr double ShareTolerance = 0.06;  // of the pulse's share in the line, where they are not
constexpr double RateTolerance = 0.02;   // of the line rate

/// How far the syncs are from a mode; negative: they are not of this mode.
double distance(const MeasuredSyncs& syncs, const VideoMode& mode) {
  if (syncs.lines != mode.lines()) return -1;
  const double nominal = static_cast<double>(mode.sync) / mode.line_pixels();
  const double share = static_cast<double>(syncs.hsync_clocks) / syncs.line_clocks;
  const double pulse = std::abs(share / nominal - 1);
  const bool whole_clocks = syncs.line_clocks % mode.line_pixels() == 0;
  const double rate = syncs.clock_hz / syncs.line_clocks;
  const double nominal_rate = mode.pixel_mhz * 1e6 / mode.line_pixels();
  const bool near = pulse <= (whole_clocks ? PulseTolerance : ShareTolerance) ||
                    std::abs(rate / nominal_rate - 1) <= RateTolerance;
  if (!near) return -1;
  return pulse + (whole_clocks ? 0 : 1) + 0.1 * (syncs.hsync_positive != mode.hsync_positive) +
         0.1 * (syncs.vsync_positive != mode.vsync_positive);
}

}  // namespace

const std::vector<VideoMode>& video_modes() {
  static const std::vector<VideoMode> modes = {
      {640, 350, 70, 25.175, 16, 96, 48, 37, 2, 60, true, false},
      {640, 350, 85, 31.5, 32, 64, 96, 32, 3, 60, true, false},
      {640, 400, 70, 25.175, 16, 96, 48, 12, 2, 35, false, true},
      {640, 400, 85, 31.5, 32, 64, 96, 1, 3, 41, false, true},
      {720, 400, 70, 28.322, 18, 108, 54, 12, 2, 35, false, true},
      {720, 400, 85, 35.5, 36, 72, 108, 1, 3, 42, false, true},
      {640, 480, 60, 25.175, 16, 96, 48, 10, 2, 33, false, false},
      {640, 480, 72, 31.5, 24, 40, 128, 9, 3, 28, false, false},
      {640, 480, 75, 31.5, 16, 64, 120, 1, 3, 16, false, false},
      {640, 480, 85, 36, 56, 56, 80, 1, 3, 25, false, false},
      {720, 480, 60, 27, 16, 62, 60, 9, 6, 30, false, false},
      {848, 480, 60, 33.75, 16, 112, 112, 6, 8, 23, true, true},
      {720, 576, 50, 27, 12, 64, 68, 5, 5, 39, false, false},
      {800, 600, 56, 36, 24, 72, 128, 1, 2, 22, true, true},
      {800, 600, 60, 40, 40, 128, 88, 1, 4, 23, true, true},
      {800, 600, 72, 50, 56, 120, 64, 37, 6, 23, true, true},
      {800, 600, 75, 49.5, 16, 80, 160, 1, 3, 21, true, true},
      {800, 600, 85, 56.25, 32, 64, 152, 1, 3, 27, true, true},
      {1024, 768, 60, 65, 24, 136, 160, 3, 6, 29, false, false},
      {1024, 768, 70, 75, 24, 136, 144, 3, 6, 29, false, false},
      {1024, 768, 75, 78.75, 16, 96, 176, 1, 3, 28, true, true},
      {1024, 768, 85, 94.5, 48, 96, 208, 1, 3, 36, true, true},
      {1152, 864, 75, 108, 64, 128, 256, 1, 3, 32, true, true},
      {1280, 720, 60, 74.25, 110, 40, 220, 5, 5, 20, true, true},
      {1280, 720, 50, 74.25, 440, 40, 220, 5, 5, 20, true, true},
      {1280, 768, 60, 79.5, 64, 128, 192, 3, 7, 20, false, true},
      {1280, 800, 60, 83.5, 72, 128, 200, 3, 6, 22, false, true},
      {1280, 960, 60, 108, 96, 112, 312, 1, 3, 36, true, true},
      {1280, 1024, 60, 108, 48, 112, 248, 1, 3, 38, true, true},
      {1280, 1024, 75, 135, 16, 144, 248, 1, 3, 38, true, true},
      {1360, 768, 60, 85.5, 64, 112, 256, 3, 6, 18, true, true},
      {1366, 768, 60, 85.5, 70, 143, 213, 3, 3, 24, true, true},
      {1440, 900, 60, 106.5, 80, 152, 232, 3, 6, 25, false, true},
      {1600, 1200, 60, 162, 64, 192, 304, 1, 3, 46, true, true},
      {1680, 1050, 60, 146.25, 104, 176, 280, 3, 6, 30, false, true},
      {1920, 1080, 60, 148.5, 88, 44, 148, 4, 5, 36, true, true}};
  return modes;
}

std::string VideoMode::name() const { return fmt::format("{}x{} at {} Hz", columns, rows, hertz); }

const VideoMode* find_video_mode(const MeasuredSyncs& syncs) {
  const VideoMode* best = nullptr;
  double nearest = 0;
  for (const VideoMode& mode : video_modes()) {
    const double far = distance(syncs, mode);
    if (far < 0 || (best && far >= nearest)) continue;
    best = &mode;
    nearest = far;
  }
  return best;
}

}  // namespace racebeam
