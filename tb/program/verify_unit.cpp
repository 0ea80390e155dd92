// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/verify_unit.h"

#include <algorithm>
#include <chrono>

#include "tb/base/interrupt.h"
#include "tb/scene/engines.h"
#include "tb/show/set_knob.h"
#include "tb/trace/difference_wave.h"
#include "tb/twin/twins.h"

namespace racebeam {

namespace {

constexpr std::uint64_t Batch = 10000;  // clocks, then it looks

}  // namespace

UnitVerdict verify_unit(const UnitUnderTest& dut, Stimulus stimulus, std::uint64_t clocks,
                        unsigned seed, const std::string& folder, const std::string& repeat,
                        const std::function<void(std::uint64_t)>& compared) {
  TwinBench twins(dut);
  const Lockstep& lockstep = twins.lockstep();
  const auto start = std::chrono::steady_clock::now();
  const bool random = stimulus == Stimulus::Random;
  const UnitWalk* const walk = random ? nullptr : twins_of(engine_of(dut.k)).walk(dut.unit);
  twins.stimulate(stimulus, seed);
  while (lockstep.clocks() < clocks && !(lockstep.first() && lockstep.first()->whole()) &&
         !lockstep.fault() && !interrupted()) {
    twins.bench().clock(
        static_cast<int>(std::min<std::uint64_t>(Batch, clocks - lockstep.clocks())));
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
