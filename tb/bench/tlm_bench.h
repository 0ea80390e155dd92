// The `tlm` level on the bench: the transaction-level chip with a screen at its display socket.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "sc/beam/scene_program.h"
#include "tb/bench/chip_bench.h"

namespace racebeam {

class TlmBench final : public ChipBench {
 public:
  struct Options {
    knobs k;
    bool stats = false;  ///< count
    bool crc = false;    ///< compute the CRCs of VgaFrame; the pins are then checked as well
    bool sound = false;  ///< listen to the PWM pin
    /// Instead of the built-in demo; must outlive the bench and fit the knobs.
    const scene_program* program = nullptr;
    bool intervals = false;  ///< collect IntervalEvents
  };

  explicit TlmBench(const Options& options);
  ~TlmBench() override;

  void seek(int frame) override;
  /// The next frame is the following one. SyncError only where CRCs are computed: otherwise the
  /// chip sends lines, which have no syncs.
  Frame render() override;
  std::uint64_t clocks() const override;
  const SoundMonitor* sound() const override;

 private:
  struct Platform;
  std::unique_ptr<Platform> platform_;
};

}  // namespace racebeam
