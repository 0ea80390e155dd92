// Who waits for whom in the interval tracer's chip.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>

#include "sc/beam/chip.h"
#include "tb/bench/waits.h"

namespace racebeam {

class BeamWaits final : public WaitWatch {
 public:
  BeamWaits(const chip& watched, const knobs& k);

  void clock() override;
  std::vector<Wait> chain() const override;

 private:
  void look_at_tracer();
  void remember_pushes();
  Wait fifo() const;
  Wait tracer() const;
  Wait camera() const;
  Wait decision() const;
  Wait conductor() const;

  const chip& chip_;
  const knobs knobs_;
  const std::uint64_t line_;  // clocks
  Held no_line_end_, line_end_;
  Held answer_without_offer_, offer_, refused_;
  Held reset_, stepping_in_reset_, running_, lock_;
  Held second_, climb_, climb_stays_, descend_stays_;
  int descents_ = 0;  // since an offer, or a restart
  int asides_ = 0;    // portals of one face in turn
  int tag_ = -1;
  bool run_ = false, climbed_ = false, descended_ = false;
  std::map<int, int> pushed_;  // tags by place of the interval stack
  bool wrong_top_ = false;
};

std::unique_ptr<WaitWatch> make_beam_waits(const wired_chip& chip, const knob_values& k,
                                           const LastRises&);

}  // namespace racebeam
