// TileRun: a verilated Tiny Tapeout chip, moved by the clocks of its frames.
//
// Its pins are `chip.ui_in`, `chip.uo_out` and so on; what is inside has the names of its RTL:
// `chip.hvsync_gen.hpos`.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/trace/clocked_run.h"
#include "tb/tt/tt_run.h"

namespace racebeam {

class TileRun : public ClockedRun {
 public:
  /// `run` outlives it. Its plug-in lets signals be read, or there are the pins alone.
  explicit TileRun(TtRun& run);

  const TraceAxis& raster() const override { return raster_; }
  int period_ps() const override { return period_ps_; }
  /// Those that are wider than 64 bits are left out. To be asked for before each_clock().
  std::vector<ChipSignal> signals(bool) override;
  const char* left_out() const override { return "the chip's pins and the beam alone"; }

  bool go_to(std::int64_t clock) override;
  std::int64_t clock() const override;
  void each_clock(std::function<void(std::int64_t)> look) override;
  void settle() override;
  /// Stands at the reset again, without each_clock(); what signals() gave is gone.
  void restart();

 private:
  TilePins seen_inputs() const;
  std::uint64_t since_reset(std::int64_t clock) const {
    return run_.found().first + static_cast<std::uint64_t>(clock);
  }

  TtRun& run_;
  const TraceAxis raster_;
  const int period_ps_;
  std::function<void(std::int64_t)> look_;
};

}  // namespace racebeam
