// The `signal` level on the bench: a wired chip of any engine between a clock, its input pins and
// monitors. What waveforms and viewers ask of a chip, they ask here.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "sc/base/engine.h"
#include "sc/base/wired_chip.h"
#include "tb/bench/chip_bench.h"

namespace racebeam {

class Surroundings;

class WiredBench : public ChipBench {
 public:
  /// What is built.
  struct Setting {
    const engine& built;
    knob_values k;
    /// Instead of the built-in demo; outlives the bench and fits the knobs.
    const scene_tables* scene;
    int frames;            ///< of the show, which then starts again
    unit_choices units{};  ///< models, RTL, or both in lockstep
  };
  /// What is watched.
  struct Watches {
    bool stats = false;           ///< count
    bool crc = false;             ///< compute the CRCs of VgaFrame
    bool sound = false;           ///< listen to the PWM pin
    bool outlive_faults = false;  ///< of RTL in lockstep: the chip goes on without it
    /// Called at the edge that ends each clock, its wires settled.
    std::function<void(const wired_chip&)> each_edge{};
  };

  /// Throws RtlError.
  explicit WiredBench(const Setting& setting);
  WiredBench(const Setting& setting, const Watches& watches);
  ~WiredBench() override;

  /// Not in the middle of a frame. A chip with surroundings that is busy loses frames by it.
  void seek(int frame) override;
  /// Simulates so many clocks, to the end of the frame at most. Throws SyncError, what
  /// each_clock()'s `look` throws, RtlFault, and Interrupted between two lines.
  void advance(int clocks);
  /// One frame, or the rest of one; of a chip with surroundings, frames to the end of a picture,
  /// and as the picture what the screen shows in the last of them.
  Frame render() override;
  /// What is around the chip; nullptr: nothing.
  const Surroundings* around() const;
  /// Lets all wires settle without a clock: after seek(), and after construction, they have not.
  void settle();
  /// From now on `look` is called in every clock once its wires have settled, beginning with the
  /// clock that the bench stands in; an empty one ends that. Without one there is no cost. After
  /// an exception it is called no more.
  void each_clock(std::function<void()> look);
  /// From the next line on all registers follow every clock, which costs an eighth of the speed.
  void watch_registers();
  /// Lockstep begins anew: differences so far are no first ones.
  void forget_differences();
  /// The chip, to be looked into between clocks.
  const wired_chip& dut() const;
  /// Of a clock, in picoseconds.
  int period_ps() const;
  std::uint64_t clocks() const override;
  const SoundMonitor* sound() const override;
  std::vector<const Lockstep*> locksteps() const override;
  /// Test of the comparison itself: what Lockstep::invert() does, in the next clock, to a unit that
  /// runs in lockstep; the number of that clock.
  std::uint64_t invert(const std::string& unit, const std::string& port, int bit);

 private:
  struct Platform;
  std::unique_ptr<Platform> platform_;
};

}  // namespace racebeam
