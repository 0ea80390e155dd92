// TtSource: a verilated Tiny Tapeout chip as the source of frames.
//
// It knows the pins and nothing else. Its past is simulated again from the reset when a frame is
// sought: the same inputs, those of the keys too, give the same frames.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tb/monitor/pin_sound.h"
#include "tb/tt/tt_run.h"
#include "tb/view/frame_source.h"

namespace racebeam {

class TtSource : public FrameSource {
 public:
  /// Stands before frame 0. `run` outlives it. `sound_pin` of uio_out is heard where the chip
  /// drives it.
  TtSource(TtRun& run, int sound_pin);

  const char* level() const override { return "verilated"; }
  bool fast() const override { return false; }
  const FrameWatch& watch() const override { return watch_; }
  double clock_hz() const override { return run_.clock_hz(); }
  /// A frame far away takes a while: advance() simulates what is before it, which is not shown.
  void seek(int frame) override;
  int advance(int clocks) override;
  std::optional<TilePins> inputs() const override { return run_.pins(); }
  std::string inputs_text() const override { return run_.inputs().text(); }
  void press(TilePins pins) override;
  std::vector<float> take_sound() override { return sound_.take(); }
  Rows rows() const override;

 private:
  std::uint64_t begin_of(int frame) const;
  void show(std::uint64_t from, std::uint64_t until);

  TtRun& run_;
  const int sound_pin_;
  FrameWatch watch_;
  PinSound sound_;
  int frame_ = 0;       // that it stands in, or before
  PinChange now_{};     // pins of the last clock
  bool heard_ = false;  // the chip drives the sound pin
  std::vector<PinChange> changes_;
};

}  // namespace racebeam
