// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/shake_run.h"

#include <fmt/format.h>

#include <map>
#include <stdexcept>

#include "sc/swap/channel_stalls.h"
#include "tb/bench/benches.h"
#include "tb/show/level.h"
#include "tb/twin/channels.h"

namespace racebeam {

struct ShakeRun::Shown {
  VgaFrame picture;
  std::uint64_t starved = 0;
  bool timed = false;  ///< its colours are a function of time
};

struct ShakeRun::Parts {
  const Run run;
  const planned_stalls plan;
  const std::unique_ptr<ChipBench> bench;
  WiredBench& wired;
  channel_stalls& stalls;
  const wire<1>* timed = nullptr;
  std::map<int, Shown> quiet;

  Parts(const Run& r, std::shared_ptr<const stall_plan> p)
      : run(r),
        plan(std::move(p)),
        bench(bench_of(run.show.engine())
                  .make(LevelSignal,
                        {run.show.engine(), run.k, run.show.tables(), run.show.frames(), run.units},
                        {})),
        wired(dynamic_cast<WiredBench&>(*bench)),
        stalls(*channel_stalls::of(wired.dut())) {
    for (const std::string& port : stalls.missing())
      throw std::logic_error("the chip has no filter at " + port);
    if (const char* const name = timed_wire(run.show.engine())) {
      const std::string path = std::string(wired.dut().name()) + "." + name;
      timed = dynamic_cast<const wire<1>*>(sc_core::sc_find_object(path.c_str()));
      if (!timed) throw std::logic_error("the chip has no wire " + path);
    }
  }
};

namespace {

// A beam that starves between two pixels makes the tracer hurry, which gives up short intervals.
std::uint64_t starved_of(const engine& built, const frame_counts& counts) {
  std::uint64_t sum = 0;
  for (std::size_t n = 0; n < built.counters.size(); ++n)
    for (const std::string name : {"starved_pixels", "give_ups"})
      if (built.counters[n].name == name) sum += counts.counters[n];
  return sum;
}

}  // namespace

ShakeRun::ShakeRun(const Run& run, std::shared_ptr<const stall_plan> plan)
    : parts_(new Parts(run, std::move(plan))) {}
ShakeRun::~ShakeRun() = default;

ShakeRun::Shown ShakeRun::show(int number) {
  Parts& p = *parts_;
  const engine& built = p.run.show.engine();
  p.bench->seek(number);
  Shown shown;
  if (p.timed) {
    // In the middle of each line.
    const Raster raster = p.run.raster();
    const int line = raster.line_clocks();
    for (int clock = line / 2; clock < raster.frame_clocks(); clock += line) {
      p.wired.advance(clock < line ? line / 2 : line);
      shown.timed |= p.timed->read();
    }
  }
  const ChipBench::Frame frame = p.bench->render();
  shown.picture = frame.picture;
  shown.starved = starved_of(built, *frame.stats);
  return shown;
}

const ShakeRun::Shown& ShakeRun::quiet(int number) {
  const auto known = parts_->quiet.find(number);
  if (known != parts_->quiet.end()) return known->second;
  parts_->stalls.rest();
  return parts_->quiet[number] = show(number);
}

std::string ShakeRun::objection(int number) {
  const Shown& shown = quiet(number);
  if (shown.timed)
    return fmt::format("{} is 1: colours are a function of time",
                       timed_wire(parts_->run.show.engine()));
  if (shown.starved > 0)
    return fmt::format("{} pixels or intervals starve without stalls", shown.starved);
  return {};
}

ShakenPicture ShakeRun::shake(std::uint64_t seed, int number) {
  const Shown& expected = quiet(number);
  Parts& p = *parts_;
  p.stalls.reseed(seed);
  const std::uint64_t before = p.stalls.stalled_clocks();
  const Shown got = show(number);
  ShakenPicture shaken{seed, number, p.stalls.stalled_clocks() - before};
  shaken.starved = got.starved;
  const std::size_t pixels = expected.picture.pixels();
  for (std::size_t n = 0; n < pixels; ++n) {
    if (got.picture.colour(n) == expected.picture.colour(n)) continue;
    if (shaken.pixels++ > 0) continue;
    shaken.x = static_cast<int>(n % static_cast<std::size_t>(expected.picture.width));
    shaken.y = static_cast<int>(n / static_cast<std::size_t>(expected.picture.width));
    shaken.expected = expected.picture.colour(n);
    shaken.got = got.picture.colour(n);
  }
  return shaken;
}

std::uint64_t ShakeRun::clocks() const { return parts_->bench->clocks(); }

}  // namespace racebeam
