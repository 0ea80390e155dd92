// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/trace/tile_run.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "tb/base/interrupt.h"

namespace racebeam {

namespace {

constexpr int WidestSignal = 64;
constexpr double PicosecondsPerSecond = 1e12;

ChipSignal signal_of(const rtl_port& port, bool is_pin) {
  const std::string path = std::string("chip.") + port.name;
  const auto dot = path.rfind('.');
  return {path.substr(0, dot),
          path.substr(dot + 1),
          port.bits,
          {},
          [data = port.data, bytes = static_cast<std::size_t>(port.bytes)] {
            std::uint64_t bits = 0;  // the machine's bytes begin with the lowest
            std::memcpy(&bits, data, bytes);
            return bits;
          },
          is_pin};
}

}  // namespace

TileRun::TileRun(TtRun& run)
    : run_(run),
      raster_(run.found().raster),
      period_ps_(static_cast<int>(std::lround(PicosecondsPerSecond / run.clock_hz()))) {}

void TileRun::restart() {
  each_clock({});
  run_.restart();
}

// A pin is as the chip's logic sees it: behind the register of the inputs.
std::vector<ChipSignal> TileRun::signals(bool) {
  run_.stand();
  const rtl_model& model = run_.chip().model();
  std::set<std::string> pins;
  for (int n = 0; n < model.port_count; ++n) pins.insert(model.ports[n].name);
  std::map<std::string, ChipSignal> by_name;
  for (int n = 0; n < model.signal_count; ++n) {
    const std::string name = model.signals[n].name;
    const bool is_pin = pins.count(name) > 0;
    if (model.signals[n].bits <= WidestSignal)
      by_name.emplace(name, signal_of(model.signals[n], is_pin));
  }
  for (int n = 0; n < model.port_count; ++n) {
    ChipSignal signal = signal_of(model.ports[n], true);
    if (signal.name == "ui_in") signal.inner = [this] { return seen_inputs().ui; };
    if (signal.name == "uio_in") signal.inner = [this] { return seen_inputs().uio; };
    by_name.emplace(signal.name, std::move(signal));
  }
  std::vector<ChipSignal> all;
  for (const bool is_pin : {true, false})
    for (auto& [name, signal] : by_name)
      if (signal.is_pin == is_pin) all.push_back(signal);
  return all;
}

std::int64_t TileRun::clock() const {
  return static_cast<std::int64_t>(run_.clock()) - static_cast<std::int64_t>(run_.found().first);
}

TilePins TileRun::seen_inputs() const {
  const std::uint64_t clock = run_.chip().clock();
  return run_.pins_at(clock > 0 ? clock - 1 : 0);
}

bool TileRun::go_to(std::int64_t clock) {
  const auto line = static_cast<std::uint64_t>(raster().line_clocks());
  std::vector<PinChange> changes;  // of no interest
  while (run_.clock() < since_reset(clock)) {
    if (interrupted()) return false;
    const std::uint64_t from = run_.clock();
    const std::uint64_t ahead = (from + line - run_.found().first % line) % line;
    run_.run(std::min(since_reset(clock), from + line - ahead), changes);
    changes.clear();
    line_done();
  }
  return !interrupted();
}

void TileRun::each_clock(std::function<void(std::int64_t)> look) {
  look_ = std::move(look);
  if (!look_) return run_.each_clock({});
  run_.each_clock([this](std::uint64_t clock) {
    look_(static_cast<std::int64_t>(clock - run_.found().first));
  });
}

void TileRun::settle() {
  if (look_) look_(static_cast<std::int64_t>(run_.clock() - run_.found().first));
}

}  // namespace racebeam
