// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/trace/tile_run.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <string>
#include <utility>

#include "tb/interrupt.h"

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
    : run_(run), period_ps_(static_cast<int>(std::lround(PicosecondsPerSecond / run.clock_hz()))) {
  restart();
}

void TileRun::restart() {
  look_ = {};
  run_.each_clock({});
  if (run_.clock() > since_reset(0)) run_.restart();
  go_to(0);
}

std::vector<ChipSignal> TileRun::signals(bool registers) {
  const rtl_model& model = run_.chip().model();
  std::vector<ChipSignal> all;
  std::set<std::string> known;
  const auto add = [&](const rtl_port& port, bool is_pin) {
    if (port.bits <= WidestSignal && known.insert(port.name).second)
      all.push_back(signal_of(port, is_pin));
  };
  for (int n = 0; n < model.port_count; ++n) add(model.ports[n], true);
  for (int n = 0; registers && n < model.signal_count; ++n) add(model.signals[n], false);
  return all;
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
