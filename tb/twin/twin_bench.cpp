// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/twin_bench.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "sc/beam/sequencer.h"
#include "tb/scene/engines.h"
#include "tb/twin/random_episodes.h"
#include "tb/twin/twins.h"

namespace racebeam {

namespace {

void keep_last(PortStream& stream, std::uint64_t most) {
  const std::uint64_t left_out = stream.clocks() - most;
  std::vector<int> frames(std::move(stream.frames));
  stream = stream.without(0, left_out);
  if (frames.empty()) return;
  frames.erase(frames.begin(), frames.begin() + static_cast<std::ptrdiff_t>(left_out));
  stream.frames = std::move(frames);
}

}  // namespace

TwinBench::TwinBench(const UnitUnderTest& dut)
    : dut_(dut),
      model_(engine_of(dut.k).unit(dut.unit)->make("model", dut.k, dut.scene)),
      lockstep_("lockstep", dut.unit, *model_, engine_of(dut.k).parameters(dut.k), dut.plugin),
      bench_(*model_, &lockstep_.clk_i),
      counter_(dynamic_cast<sequencer_pins*>(model_.get())) {
  lockstep_.outlive_faults();
}

PortStream TwinBench::form() const {
  PortStream form = stream_of(traffic_of(dut_.unit, bench_),
                              twins_of(engine_of(dut_.k)).inputs(dut_.k, dut_.scene, dut_.unit));
  form.counts_frames = counter_ != nullptr;
  return form;
}

void TwinBench::stimulate(Stimulus stimulus, unsigned seed) {
  const Twins& row = twins_of(engine_of(dut_.k));
  const auto random = random_traffic(dut_, bench_, seed);  // resets
  if (stimulus == Stimulus::Walk)
    return drive_each(row.walk(dut_.unit)->begin(bench_, dut_.k, seed));
  seek_at_episodes(*random, *model_, dut_.frames, [this](int frame) {
    if (seeks_) seeks_(frame);
    seek_rtl(frame);
  });
  drive_each([random] { random->next(); });
}

PortStream TwinBench::record(std::uint64_t clocks, std::uint64_t most) {
  PortStream stream = form();
  const std::function<std::uint64_t()> frame = frame_register();
  if (frame) stream.frames = {0};
  const auto take = [&] {  // of the clock that has just ended
    for (const UnitBench::Pin* pin : bench_.pins())
      if (pin->input) stream.values.push_back(pin->value());
    if (frame) stream.frames.push_back(static_cast<int>(frame()));
    if (stream.clocks() >= 2 * most) keep_last(stream, most);
  };
  seeks_ = [&](int number) {
    stream.seeks[stream.clocks()] = number;
    stream.frames.back() = number;
  };
  next_ = [&, next = next_] {
    take();
    next();
  };
  bench_.clock(static_cast<int>(clocks));
  take();
  if (stream.clocks() > most) keep_last(stream, most);
  return stream;
}

std::function<std::uint64_t()> TwinBench::frame_register() const {
  if (counter_)
    for (const probe& one : dynamic_cast<const probed&>(*counter_).probes())
      if (one.name == "frame_q") return one.read;
  return {};
}

void TwinBench::seek(int frame) {
  counter_->deposit(frame);
  seek_rtl(frame);
}

void TwinBench::seek_rtl(int frame) {
  lockstep_.deposit([frame](rtl_instance& rtl) { rtl.seek(frame); });
}

void TwinBench::drive(const PortStream& stream, std::uint64_t clock) {
  if (const auto frame = stream.seeks.find(clock); frame != stream.seeks.end()) seek(frame->second);
  std::size_t input = 0;
  for (UnitBench::Pin* pin : bench_.pins())
    if (pin->input) pin->drive(stream.at(clock, input++));
}

void TwinBench::play(const PortStream& stream) {
  constexpr std::uint64_t Batch = 1000;  // clocks, then it looks
  const std::uint64_t begin = lockstep_.clocks(), end = begin + stream.clocks();
  lockstep_.forget();
  const bool fresh = begin == 0;  // then the first edge comes before a change
  if (fresh) drive(stream, 0);
  drive_each([&, clock = std::uint64_t{fresh}]() mutable {
    if (registers_) registers_->take(lockstep_.clocks());  // of the edge that has been
    if (clock < stream.clocks()) drive(stream, clock++);
  });
  while (lockstep_.clocks() < end && !lockstep_.first() && !lockstep_.fault())
    bench_.clock(static_cast<int>(std::min(Batch, end - lockstep_.clocks())));
  next_ = [] {};
}

RegisterHistory& TwinBench::remember_registers() { return registers_.emplace(*model_, lockstep_); }

void TwinBench::drive_each(std::function<void()> next) {
  if (!next_) bench_.between_edges([this] { next_(); });
  next_ = std::move(next);
}

PortTraffic TwinBench::model_traffic(const PortStream& stream) {
  PortTraffic traffic = traffic_of(stream.unit, bench_);
  for (std::uint64_t clock = 0; clock < stream.clocks(); ++clock) {
    drive(stream, clock);
    bench_.settle();
    traffic.append(bench_);
    bench_.clock();
  }
  return traffic;
}

}  // namespace racebeam
