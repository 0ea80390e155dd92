// TtBench: a Tiny Tapeout chip that runs, and the monitors of whole frames at its pins.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "tb/monitor/pin_stats.h"
#include "tb/monitor/sound_monitor.h"
#include "tb/monitor/vga_monitor.h"
#include "tb/tt/tt_run.h"

namespace racebeam {

class TtBench {
 public:
  static constexpr int SoundPin = 7;  ///< of uio

  struct Frame {
    VgaFrame picture;
    PinStats stats;
  };

  /// Puts the run before frame 0. `sound`: listen to uio[7] from frame `first` on.
  TtBench(TtRun& run, bool crc, bool sound, int first);

  /// Simulates one frame. Throws SyncError if the syncs are lost.
  Frame render();
  /// What broke the mode so far.
  const VgaFaults& faults() const { return faults_; }
  /// Clocks simulated so far.
  std::uint64_t clocks() const { return run_.clock(); }
  /// What the sound pin played so far, half scale while the chip does not drive it; nullptr if not
  /// asked for.
  const SoundMonitor* sound() const { return sound_.get(); }
  /// The chip drove the sound pin in some clock.
  bool has_sound_pin() const { return has_sound_pin_; }

 private:
  void feed(const PinChange& pins);

  TtRun& run_;
  const FoundFrames found_;
  std::vector<PinChange> changes_;  // that no monitor has seen
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
