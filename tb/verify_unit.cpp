// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verify_unit.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <type_traits>

#include "sc/chip.h"
#include "tb/random_traffic.h"
#include "tb/unit_bench.h"

namespace racebeam {

namespace {

constexpr std::uint64_t Batch = 10000;  // clocks, then it looks

template <class Unit>
std::unique_ptr<sc_core::sc_module> make(const knobs& k) {
  if constexpr (std::is_constructible_v<Unit, const char*, const knobs&>)
    return std::make_unique<Unit>("model", k);
  else return std::make_unique<Unit>("model");
}

template <class... Units>
std::unique_ptr<sc_core::sc_module> make_one_of(const std::string& unit, const knobs& k) {
  std::unique_ptr<sc_core::sc_module> made;
  ((unit == Units::unit_name ? void(made = make<Units>(k)) : void()), ...);
  return made;
}

std::unique_ptr<sc_core::sc_module> make_model(const std::string& unit, const knobs& k) {
  return make_one_of<vga_timing, sequencer, camera_unit, ray_stepper, subdivider, stacks,
                     decision_datapath, scene, navigator, interval_fifo, pixel_output, pwm_sound>(
      unit, k);
}

}  // namespace

UnitVerdict verify_unit(const std::string& unit, const std::string& plugin, std::uint64_t clocks,
                        unsigned seed) {
  const auto start = std::chrono::steady_clock::now();
  const knobs k;
  const auto model = make_model(unit, k);
  Lockstep lockstep("lockstep", unit, *model, k, plugin);
  UnitBench bench(*model, &lockstep.clk_i);
  RandomTraffic traffic(bench, seed);
  bench.between_edges([&] { traffic.next(); });
  while (lockstep.clocks() < clocks && !lockstep.first())
    bench.clock(static_cast<int>(std::min<std::uint64_t>(Batch, clocks - lockstep.clocks())));
  UnitVerdict verdict{unit, "random", lockstep.clocks(), lockstep.differences(), 0, ""};
  verdict.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (lockstep.first()) verdict.first = lockstep.first()->text();
  return verdict;
}

}  // namespace racebeam
