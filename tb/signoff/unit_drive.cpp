// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/unit_drive.h"

#include <stdexcept>

#include "tb/base/errors.h"
#include "tb/base/interrupt.h"
#include "tb/scene/engines.h"
#include "tb/twin/random_episodes.h"

namespace racebeam {

namespace {

constexpr std::uint64_t Look = 1024;  // clocks, then it looks for an interrupt

}  // namespace

UnitDrive::UnitDrive(const UnitUnderTest& dut, const std::string& plugin, Stimulus stimulus,
                     unsigned seed)
    : model_(engine_of(dut.k).unit(dut.unit)->make("model", dut.k, dut.scene)),
      lockstep_("lockstep", dut.unit, *model_, engine_of(dut.k).parameters(dut.k), plugin),
      bench_(*model_, &lockstep_.clk_i) {
  lockstep_.outlive_faults();
  const Twins& row = twins_of(engine_of(dut.k));
  if (stimulus == Walk) {
    const UnitWalk* const walk = row.walk(dut.unit);
    if (!walk) throw std::logic_error(dut.unit + " has no walk");
    next_ = walk->begin(bench_, dut.k, seed);
    return;
  }
  const auto traffic = random_traffic(dut, bench_, seed);
  seek_at_episodes(*traffic, *model_, dut.frames, [this](int frame) {
    lockstep_.deposit([frame](rtl_instance& rtl) { rtl.seek(frame); });
  });
  next_ = [traffic] { traffic->next(); };
}

void UnitDrive::run(std::uint64_t clocks, const std::function<void()>& each) {
  for (std::uint64_t clock = 0; clock < clocks && !lockstep_.fault(); ++clock) {
    if (clock % Look == 0 && interrupted()) throw Interrupted();
    if (lockstep_.clocks() > 0) next_();  // the first clock is in reset
    bench_.settle();
    if (each) each();
    bench_.clock();
  }
}

}  // namespace racebeam
