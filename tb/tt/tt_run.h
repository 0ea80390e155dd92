// TtRun: a Tiny Tapeout tile that runs from its reset, while its inputs change in time.
//
// What it is asked for again it simulates again, from the reset: the same inputs give the same.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tb/monitor/frame_finder.h"
#include "tb/tt/tt_chip.h"
#include "tb/tt/tt_inputs.h"
#include "tb/tt/tt_project.h"

namespace racebeam {

class TtRun {
 public:
  /// Resets the chip for 10 clocks and looks for its frames, with the inputs of the reset; the
  /// first whole one after reset is frame 0. It then stands at the reset. Throws RtlError as TtChip
  /// does, SyncError, and UsageError as TtInputs::clocks() does.
  TtRun(const TtProject& project, const std::string& plugin, TtInputs inputs);

  const FoundFrames& found() const { return found_; }
  double clock_hz() const { return found_.clock_hz; }
  /// The clock it stands before, since reset.
  std::uint64_t clock() const { return clock_; }
  /// Stands at the reset again.
  void restart();
  /// Runs up to that clock and adds what changes; the first clock after reset is always added.
  void run(std::uint64_t until, std::vector<PinChange>& changes);
  /// From here on calls `look` with every clock that is run, its signals settled; an empty one
  /// ends that.
  void each_clock(std::function<void(std::uint64_t clock)> look);
  /// From this clock on the inputs are others, and those that were to come are dropped. Not before
  /// frame 0.
  void press(TilePins pins);

  /// The inputs in this clock.
  TilePins pins() const { return pins_at(clock_); }
  /// The inputs as they were set in some clock since reset.
  TilePins pins_at(std::uint64_t clock) const;
  /// All of the run, and what is to come.
  const TtInputs& inputs() const { return inputs_; }
  /// Brings the chip itself to the clock that the run stands before; it may have been ahead.
  void stand();
  /// The chip, which restart() and stand() may make anew.
  const TtChip& chip() const { return *chip_; }

 private:
  void reset_chip();
  FoundFrames find();
  void schedule();
  void simulate(std::uint64_t until);

  const TtProject project_;
  const std::string plugin_;
  TtInputs inputs_;
  std::unique_ptr<TtChip> chip_;
  std::vector<PinChange> ahead_;  // of the chip that are not handed out yet
  const FoundFrames found_;
  std::vector<std::uint64_t> times_;  // of inputs_.changes(), since reset
  std::size_t next_ = 0;              // of them: the chip has those before
  std::uint64_t clock_ = 0;
  std::function<void(std::uint64_t)> look_;
};

}  // namespace racebeam
