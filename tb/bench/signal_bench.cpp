// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/signal_bench.h"

#include "sc/base/constants.h"
#include "sc/beam/chip.h"
#include "sc/beam/engine.h"

namespace racebeam {

namespace {

WiredBench::Setting setting_of(const SignalBench::Options& o) {
  return {beam_engine(), o.k, o.program, o.program ? o.program->frames : DemoFrames, o.units};
}

WiredBench::Watches watches_of(const SignalBench::Options& o, IntervalWatcher& intervals) {
  WiredBench::Watches watches{o.stats, o.crc, o.sound};
  if (!o.intervals && !o.watch) return watches;
  IntervalWatcher* const watcher = o.intervals ? &intervals : nullptr;
  watches.each_edge = [watcher, watch = o.watch](const wired_chip& wired) {
    const auto& dut = static_cast<const chip&>(wired);
    const chip_view view = dut.view();
    const int room = static_cast<int>(dut.room.read());
    const int face = static_cast<int>(dut.hit_face.read());
    if (watcher) watcher->observe(view, room, face);
    if (watch) watch->clock(static_cast<int>(dut.uo_o->read()), view, room, face);
  };
  return watches;
}

}  // namespace

SignalBench::SignalBench(const Options& options)
    : WiredBench(setting_of(options), watches_of(options, watcher_)) {}

SignalBench::Frame SignalBench::render() {
  Frame frame = WiredBench::render();
  frame.intervals = watcher_.take();
  return frame;
}

}  // namespace racebeam
