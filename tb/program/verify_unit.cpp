// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/verify_unit.h"

#include <algorithm>
#include <chrono>
#include <memory>

#include "sc/beam/sequencer.h"
#include "tb/base/interrupt.h"
#include "tb/scene/engines.h"
#include "tb/show/set_knob.h"
#include "tb/trace/difference_wave.h"
#include "tb/twin/random_traffic.h"
#include "tb/twin/twins.h"
#include "tb/twin/unit_bench.h"

namespace racebeam {

namespace {

constexpr std::uint64_t Batch = 10000;  // clocks, then it looks

/// No episode is long enough to count there. One in four: the last frame.
int any_frame(const UnitUnderTest& dut, unsigned random) {
  const auto frames = static_cast<unsigned>(dut.frames);
  return static_cast<int>(random % 4 == 0 ? frames - 1 : random / 4 % frames);
}

}  // namespace

UnitVerdict verify_unit(const UnitUnderTest& dut, Stimulus stimulus, std::uint64_t clocks,
                        unsigned seed, const std::string& folder, const std::string& repeat,
                        const std::function<void(std::uint64_t)>& compared) {
  const engine& built = engine_of(dut.k);
  const auto model = built.unit(dut.unit)->make("model", dut.k, dut.scene);
  Lockstep lockstep("lockstep", dut.unit, *model, built.parameters(dut.k), dut.plugin);
  lockstep.outlive_faults();
  UnitBench bench(*model, &lockstep.clk_i);
  const auto start = std::chrono::steady_clock::now();
  const bool random = stimulus == Stimulus::Random;
  const UnitWalk* const walk = random ? nullptr : twins_of(built).walk(dut.unit);
  RandomTraffic traffic(bench, twins_of(built).inputs(dut.k), seed);
  if (auto* counter = dynamic_cast<sequencer_pins*>(model.get()))
    traffic.at_episodes([&, counter](unsigned random) {
      const int frame = any_frame(dut, random);
      counter->deposit(frame);
      lockstep.deposit([&](rtl_instance& rtl) { rtl.seek(frame); });
    });
  if (walk) bench.between_edges(walk->begin(bench, dut.k, seed));
  else bench.between_edges([&] { traffic.next(); });
  while (lockstep.clocks() < clocks && !(lockstep.first() && lockstep.first()->whole()) &&
         !lockstep.fault() && !interrupted()) {
    bench.clock(static_cast<int>(std::min<std::uint64_t>(Batch, clocks - lockstep.clocks())));
    compared(lockstep.clocks());
  }
  UnitVerdict verdict{dut.unit,
                      random ? "random" : "walk",
                      lockstep.clocks(),
                      lockstep.masked(),
                      lockstep.differences(),
                      0,
                      {},
                      {}};
  verdict.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  verdict.fault = lockstep.fault().value_or("");
  if (const auto& d = lockstep.first())
    verdict.first = FirstDifference{
        d->port,
        d->clock,
        d->expected,
        d->got,
        {},
        explain(*d,
                {random ? "on random traffic" : std::string("on the walk ") + walk->where, repeat,
                 "", save_unit_window(*d, verdict.traffic, dut.k, folder), knobs_text(dut.k)})};
  return verdict;
}

}  // namespace racebeam
