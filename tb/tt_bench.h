// TtBench: a Tiny Tapeout chip on the bench, between its input pins and the monitors.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "tb/frame_finder.h"
#include "tb/pin_stats.h"
#include "tb/sound_monitor.h"
#include "tb/tt_chip.h"
#include "tb/tt_project.h"
#include "tb/vga_monitor.h"

namespace racebeam {

class TtBench {
 public:
  static constexpr int SoundPin = 7;  ///< of uio

  struct Frame {
    VgaFrame picture;
    PinStats stats;
  };

  /// Resets the chip for 10 clocks and looks for its frames; the next is the first whole one after
  /// reset, frame 0. `sound`: listen to uio[7] from frame `first` on. Throws SyncError.
  TtBench(TtChip& chip, const TtProject& project, bool crc, bool sound, int first);

  const FoundFrames& found() const { return found_; }
  /// Simulates one frame. Throws SyncError if the syncs are lost.
  Frame render();
  /// What broke the mode so far.
  const VgaFaults& faults() const { return faults_; }
  /// Clocks simulated so far.
  std::uint64_t clocks() const { return chip_.clock(); }
  /// What the sound pin played so far, half scale while the chip does not drive it; nullptr if not
  /// asked for.
  const SoundMonitor* sound() const { return sound_.get(); }
  /// The chip drove the sound pin in some clock.
  bool has_sound_pin() const { return has_sound_pin_; }

 private:
  FoundFrames find(double clock_hz);
  void feed(const PinChange& pins);

  TtChip& chip_;
  std::vector<PinChange> changes_;  // that no monitor has seen
  const FoundFrames found_;
  VgaFrame picture_;
  VgaFaults faults_;
  VgaMonitor vga_;
  PinCounter counter_;
  std::unique_ptr<SoundMonitor> sound_;
  const std::uint64_t sound_begin_;  // clock
  std::uint64_t next_;               // clock 0 of the next frame
  bool has_sound_pin_ = false;
};

}  // namespace racebeam
